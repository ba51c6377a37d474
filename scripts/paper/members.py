"""What is varied to see what the type of a condition depends on: members of an ensemble."""
import dataclasses
import re

PRESSURES = (10, 20, 30)  # MPa
NUMBERS = (1.5e-5, 1.5e-3, 1.5)  # Da
SEEDS = range(1, 11)
PAPER = {1.5e-5: dict.fromkeys(PRESSURES, "permeation"), 1.5e-3: dict.fromkeys(PRESSURES, "permeation"),
         1.5: {10: "cavity", 20: "cavity", 30: "permeation-cavity"}}

# Each by itself, against the cases as they are. Names are those of the table; values as the command line takes them.
CHOICES = {
    "c_d 0.35": ["damage.pathway_factor=0.35"],
    "c_d 0.6": ["damage.pathway_factor=0.6"],
    "least aperture 2 cells": ["damage.minimum_aperture=2"],
    "least aperture 5 cells": ["damage.minimum_aperture=5"],
    "pathways wider by c_d h": ['damage.pathway_widening="added"'],
    "as wide as cracks gape": ['damage.aperture="opening"'],
    "T0 237.15 K, as printed": ["reaction.reference_temperature=237.15"],
    "l_c 0.1 m": ["reaction.length=0.1"],
    "no thermal expansion": ["mechanics.thermal_expansion=0"],
    "twice the thermal expansion": ["mechanics.thermal_expansion=1.6e-5"],
    "cohesion as printed": ['mechanics.profile="paper-literal"'],
    "cohesion as the Weibull scale": ['mechanics.profile="weibull-scale"'],
    "half the side stiffness": [f"boundary.{side}.traction.stiffness=2e11" for side in ("right", "top")],
    "twice the side stiffness": [f"boundary.{side}.traction.stiffness=8e11" for side in ("right", "top")],
    "triangles of 4 mm": ["rock.element_size=4e-3"],
    "no local damping": ["mechanics.local_damping=0"],
    "pressure raised within 1 ms": ["boundary.injection.flow.ramp_time=1e-3"],
}

# The groups of numbers that the paper's lattice cannot have as they are in rock (docs/acid-fracturing.md).
SIMILARITY = {
    "half the viscosity": ["flow.viscosity=1.1e-3"],
    "twice the viscosity": ["flow.viscosity=4.4e-3"],
    "half the diffusivity of acid": [*(f"solute.species.{k}.diffusivity=2.5e-4" for k in (0, 1)), "reaction.damkohler={twice_da:g}"],
    "twice the diffusivity of acid": [*(f"solute.species.{k}.diffusivity=1e-3" for k in (0, 1)), "reaction.damkohler={half_da:g}"],
    "half the conduction of heat": ["heat.fluid_diffusivity=7e-4", "heat.solid_diffusivity=1.75e-3"],
    "twice the conduction of heat": ["heat.fluid_diffusivity=2.8e-3", "heat.solid_diffusivity=7e-3"],
    "twice the speed of sound": ["lattice.time_step=1.25e-6"],
}

# The paper's own lattices, relaxation time, wall and area, which the cases replace by more accurate ones; the advective
# form of the solutes (Eq. 5 is conservative), the presets' other intervals and Eq. 29 normalised remain. (The paper names
# nine velocities for the solutes, and none for heat.) Read literally, Eq. 18 gives 0.0083 for the diffusivity 0.02 of
# Table 2 (docs/model.md); the rate constant stays.
LITERAL = ['solute.velocity_set="d2q9"', 'heat.velocity_set="d2q9"', "solute.relaxation_time=0.7", 'reaction.wall="paper"',
           "reaction.surface_normal=false", "accuracy.solute_interval=1", "accuracy.heat_interval=1"]
# As much of the paper's scheme as vug has: Eq. 5 conservative as well, every interval 1 and double precision, Eq. 29 and
# the fracture energies of Table 1 as printed. Left: the flow's collision (MRT, of which the paper prints no rates), T0,
# springs in series instead of Eq. 25, and what the case files choose.
FULL = [*LITERAL, 'accuracy.preset="reference"', "solute.advective_form=false", "damage.normalised=false",
        "mechanics.bond.path_ratio=1"]
NUMERICS = {
    "the paper's numerics": LITERAL,
    "the paper's scheme in full": FULL,
    "the same, Eq. 18 as printed": [*LITERAL, *(f"solute.species.{k}.diffusivity=2.075e-4" for k in (0, 1)),
                                    "reaction.damkohler={literal_da:g}"],
}
ALL = CHOICES | SIMILARITY | NUMERICS


@dataclasses.dataclass(frozen=True)
class Member:
    """A run of the ensemble."""

    pressure: float  # MPa
    da: float
    seed: int = 1
    choice: str = ""  # a key of ALL; empty: as the cases are

    @property
    def folder(self):
        choice = re.sub(r"[^\w.]+", "_", self.choice) or "base"
        return f"{choice}/p{self.pressure:g}_da{self.da:g}_seed{self.seed}"

    @property
    def settings(self):
        """`key=value` each; of two with the same key the last holds. Rate constants are Da D / l_c."""
        rates = {"twice_da": 2 * self.da, "half_da": self.da / 2, "literal_da": self.da * 0.02 / 0.0083}
        return [f"boundary.injection.flow.pressure={self.pressure * 1e6:g}", f"reaction.damkohler={self.da:g}",
                f"rock.seed={self.seed}", *(text.format(**rates) for text in ALL.get(self.choice, []))]


def nine(**what):
    return [Member(p, da, **what) for da in NUMBERS for p in PRESSURES]


PARTS = {
    "seeds": [member for seed in SEEDS for member in nine(seed=seed)],
    "choices": [member for choice in CHOICES for member in nine(choice=choice)],
    "map": [Member(p, da, seed) for seed in (1, 2, 3) for da in (1.5e-5, 1.5e-4, 1.5e-3, 1.5e-2, 0.15, 1.5)
            for p in (10, 15, 20, 25, 30)],
    "similarity": [member for choice in SIMILARITY for member in nine(choice=choice)],
    "numerics": [member for choice in NUMERICS for member in nine(choice=choice)],
}
