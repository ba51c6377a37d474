"""The problems on which choices are measured: four with a solution on paper, and the paper's rock against itself."""
import dataclasses
import math

import numpy as np
from paper.run_data import FAILED, Run


@dataclasses.dataclass
class Choice:
    """One way to compute a problem."""

    group: str  # of the table
    name: str
    overrides: dict


def last(directory):
    run = Run(directory)
    return run.snapshot(run.steps[-1])


def crack_length(snapshot):
    """Of all failed bonds, m."""
    ends = snapshot.bonds(FAILED)
    return float(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).sum())


class OnPaper:
    """A problem whose solution is on paper."""

    def prepare(self, _):
        """Nothing has to be run first."""

    def remember(self, _):
        """Nothing to remember of a run of the default."""


class Wall(OnPaper):
    """Eq. 28: diffusion to a reactive wall at Da = 4.8, steady. Error: L2 of C over that of Eq. 28."""

    name = "wall"
    case = "cases/diffusion_reaction.toml"
    common = {"time.end": 2800, "output.interval": 2800}  # from 2400 s on the error changes by no more than its digits
    choices = [
        Choice("default", "as it is: D2Q5, kinetic wall, double", {}),
        Choice("precision", "precision = single", {"accuracy.precision": "single"}),
        Choice("scalar velocities", "velocity_set = d2q9", {"solute.velocity_set": "d2q9"}),
        Choice("scalar velocities", "d2q9, tau_h = 0.6, wall = paper",
               {"solute.velocity_set": "d2q9", "solute.relaxation_time": 0.6, "reaction.wall": "paper"}),
        Choice("interval", "solute_interval = 2", {"accuracy.solute_interval": 2}),
        Choice("interval", "solute_interval = 4", {"accuracy.solute_interval": 4}),
        Choice("interval", "solute_interval = 8", {"accuracy.solute_interval": 8}),
        Choice("spacing", "spacing x 2, time step x 4",
               {"lattice.spacing": 2e-5, "lattice.time_step": 12e-3, "lattice.size": "[1.0e-3, 0.82e-3]",
                "geometry.shapes.0.to": "[1.0e-3, 0.82e-3]"}),
        Choice("spacing", "spacing x 4, time step x 16",
               {"lattice.spacing": 4e-5, "lattice.time_step": 48e-3, "lattice.size": "[1.0e-3, 0.84e-3]",
                "geometry.shapes.0.to": "[1.0e-3, 0.84e-3]", "output.interval": 2799.984}),
    ]

    @staticmethod
    def exact(x, y, length, height, damkohler):
        total = np.zeros_like(x)
        for n in range(3000):
            low, high = n * math.pi, (n + 0.5) * math.pi
            for _ in range(80):  # beta H tan(beta H) = Da
                middle = (low + high) / 2
                if middle * math.tan(middle) > damkohler:
                    high = middle
                else:
                    low = middle
            beta = low / height
            weight = 2 * math.sin(low) / (low + math.sin(low) * math.cos(low))
            across = (np.exp(-beta * x) + np.exp(-beta * (2 * length - x))) / (1 + math.exp(-2 * beta * length))
            total += weight * np.cos(beta * y) * across
        return total

    def errors(self, directory, _):
        snapshot = last(directory)
        x, y = snapshot.nodes()
        fluid = y < 0.8e-3
        exact = self.exact(x[fluid], y[fluid], 1e-3, 0.8e-3, 4.8)
        found = snapshot.field["concentration_L1"][fluid]
        return {"concentration": float(np.linalg.norm(found - exact) / np.linalg.norm(exact))}


class Channel(OnPaper):
    """Plane Poiseuille flow through a narrow channel. Error: L2 of the profile."""

    name = "channel"
    case = "cases/poiseuille.toml"
    # as narrow as the paper's pathways, and at its relaxation time
    common = {"lattice.size": "[0.064, 0.0003]", "lattice.time_step": 8.8e-4, "time.steps": 100000,
              "output.interval_steps": 100000, "flow.body_force": "[0.08889, 0]"}
    choices = [
        Choice("default", "as it is: MRT with Lambda = 3/16, double", {}),
        Choice("precision", "precision = single", {"accuracy.precision": "single"}),
        Choice("collision", "collision = lallemand_luo", {"flow.collision": "lallemand_luo"}),
        Choice("collision", "collision = regularised", {"flow.collision": "regularised"}),
        Choice("collision", "collision = bgk", {"flow.collision": "bgk"}),
    ]

    def errors(self, directory, _):
        snapshot = last(directory)
        _, y = snapshot.nodes()
        height, viscosity, force = y.shape[0] * snapshot.dx, 1e-6, 0.08889
        exact = force * y * (height - y) / (2 * viscosity)
        return {"velocity": float(np.linalg.norm(snapshot.field["velocity"][..., 0] - exact) / np.linalg.norm(exact))}


class Cooling(OnPaper):
    """Rock cooled from one side, before the cold reaches the other. Error: largest, over the step of temperature."""

    name = "cooling"
    case = "perf/accuracy/cooling.toml"
    common = {}
    choices = [
        Choice("default", "as it is: D2Q5, double", {}),
        Choice("precision", "precision = single", {"accuracy.precision": "single"}),
        Choice("scalar velocities", "velocity_set = d2q9", {"heat.velocity_set": "d2q9"}),
        Choice("interval", "heat_interval = 2", {"accuracy.heat_interval": 2}),
        Choice("interval", "heat_interval = 4", {"accuracy.heat_interval": 4}),
        Choice("interval", "heat_interval = 8", {"accuracy.heat_interval": 8}),
        Choice("spacing", "spacing x 2, time step x 4",
               {"lattice.spacing": 5e-4, "lattice.time_step": 1e-5, "lattice.size": "[0.1, 0.02]"}),
        Choice("spacing", "spacing x 4, time step x 16",
               {"lattice.spacing": 1e-3, "lattice.time_step": 4e-5, "lattice.size": "[0.1, 0.02]"}),
    ]

    def errors(self, directory, _):
        snapshot = last(directory)
        x, _ = snapshot.nodes()
        depth = x / (2 * math.sqrt(3.5e-3 * snapshot.time))
        exact = 288.15 + 200 * np.vectorize(math.erf)(depth)
        return {"temperature": float(np.abs(snapshot.field["temperature"] - exact).max() / 200)}


class Receding(OnPaper):
    """A wall that recedes slowly. Error of the recession against the limit of slow dissolution, in which diffusion is
    steady at every moment: (L + D/k) x + x^2/2 = M C D t."""

    name = "receding"
    case = "perf/accuracy/receding.toml"
    common = {}
    choices = [
        Choice("default", "as it is", {}),
        Choice("dissolution", "dissolution_factor = 2", {"accuracy.dissolution_factor": 2, "time.end": 100}),
        Choice("dissolution", "dissolution_factor = 5", {"accuracy.dissolution_factor": 5, "time.end": 40}),
        Choice("dissolution", "dissolution_factor = 10", {"accuracy.dissolution_factor": 10, "time.end": 20}),
        Choice("dissolution", "dissolution_factor = 50", {"accuracy.dissolution_factor": 50, "time.end": 4}),
        Choice("precision", "precision = single", {"accuracy.precision": "single"}),
        Choice("interval", "update_interval = 100", {"accuracy.update_interval": 100}),
    ]

    def errors(self, directory, choice):
        history = Run(directory).history()
        time = history["time_s"][-1] * choice.overrides.get("accuracy.dissolution_factor", 1)
        layer = 0.010 + 1e-4 / 0.01
        exact = math.sqrt(layer**2 + 2 * 1.2e-5 * 1000 * 1e-4 * time) - layer
        return {"recession": abs(history["dissolved_volume_m3_per_m"][-1] / 3e-3 / exact - 1)}


class Rock:
    """The paper's rock, coarse, at 30 MPa and Da = 1.5e-3, its first 12 ms, against `preset = "reference"` with small
    mechanical sub-steps: the dissolved volume (also against the default's), the acid in place, the temperature, the length
    of the cracks, looked at every millisecond: at the end alone a bond that fails a moment later would count in full."""

    name = "rock"
    case = "cases/acid_fracturing/coarse/p30_da1.5e-3.toml"
    common = {"accuracy.preset": "careful", "time.end": 0.012, "output.interval": 0.001,
              "output.fields": '["temperature", "node_type", "state"]', "output.compress": "false",
              "output.checkpoint_interval": 0.012}
    choices = [
        Choice("default", "preset = careful", {}),
        Choice("preset", "preset = balanced", {"accuracy.preset": "balanced"}),
        Choice("preset", "preset = balanced, precision = single",
               {"accuracy.preset": "balanced", "accuracy.precision": "single"}),
        Choice("preset", "preset = fast", {"accuracy.preset": "fast"}),
        Choice("preset", "preset = fast, mass_scaling = 1", {"accuracy.preset": "fast", "mechanics.mass_scaling": 1}),
        Choice("preset", "preset = fast, rest_tolerance = 0", {"accuracy.preset": "fast", "mechanics.rest_tolerance": 0}),
        Choice("preset", "preset = reference", {"accuracy.preset": "reference"}),
        # with what the tolerance chooses beside the intervals
        Choice("tolerance", "accuracy.tolerance = 1e-4", {"accuracy.preset": "balanced", "accuracy.tolerance": 1e-4}),
        Choice("tolerance", "accuracy.tolerance = 1e-3",
               {"accuracy.preset": "fast", "accuracy.precision": "double", "accuracy.tolerance": 1e-3}),
        Choice("tolerance", "accuracy.tolerance = 1e-2", {"accuracy.preset": "fast", "accuracy.tolerance": 1e-2}),
        Choice("precision", "precision = single", {"accuracy.precision": "single"}),
        Choice("interval", "update_interval = 1", {"accuracy.update_interval": 1}),
        Choice("interval", "update_interval = 50", {"accuracy.update_interval": 50}),
        Choice("interval", "wall_interval = 1", {"accuracy.wall_interval": 1}),
        Choice("interval", "wall_interval = 50", {"accuracy.wall_interval": 50}),
        Choice("interval", "wall_interval = 100", {"accuracy.wall_interval": 100}),
        Choice("interval", "wall_interval = 400", {"accuracy.wall_interval": 400}),
        Choice("interval", "heat_interval = 2", {"accuracy.heat_interval": 2}),
        Choice("interval", "heat_interval = 4", {"accuracy.heat_interval": 4}),
        Choice("interval", "solute_interval = 2", {"accuracy.solute_interval": 2}),
        Choice("interval", "solute_interval = 4", {"accuracy.solute_interval": 4}),
        Choice("interval", "exchange_interval = 2", {"accuracy.exchange_interval": 2}),
        Choice("interval", "exchange_interval = 4", {"accuracy.exchange_interval": 4}),
        Choice("interval", "exchange_interval = 8", {"accuracy.exchange_interval": 8}),
        Choice("steady flow", "flow_tolerance = 1e-4", {"accuracy.flow_tolerance": 1e-4}),
        Choice("steady flow", "flow_tolerance = 1e-3", {"accuracy.flow_tolerance": 1e-3}),
        Choice("steady flow", "flow_tolerance = 1e-2", {"accuracy.flow_tolerance": 1e-2}),
        Choice("mechanics", "critical_fraction = 0.1", {"mechanics.critical_fraction": 0.1}),
        Choice("mechanics", "critical_fraction = 0.5", {"mechanics.critical_fraction": 0.5}),
        Choice("mechanics", "mass_scaling = 4", {"mechanics.mass_scaling": 4}),
        Choice("mechanics", "mass_scaling = 16", {"mechanics.mass_scaling": 16}),
        Choice("mechanics", "mass_scaling = 64", {"mechanics.mass_scaling": 64}),
        Choice("mechanics", "rest_tolerance = 2e-3", {"mechanics.rest_tolerance": 2e-3}),
        Choice("mechanics", "rest_tolerance = 5e-3", {"mechanics.rest_tolerance": 5e-3}),
        Choice("mechanics", "rest_tolerance = 2e-2", {"mechanics.rest_tolerance": 2e-2}),
        Choice("wall", "reaction.wall = paper", {"reaction.wall": "paper"}),
        Choice("wall", "reaction.birth_fill = split", {"reaction.birth_fill": "split"}),
        Choice("wall", "reaction.surface_normal = false", {"reaction.surface_normal": "false"}),
        Choice("scalar velocities", "solute.velocity_set = d2q9", {"solute.velocity_set": "d2q9"}),
        Choice("scalar velocities", "heat.velocity_set = d2q9", {"heat.velocity_set": "d2q9"}),
        Choice("scalar velocities", "solute.advective_form = false", {"solute.advective_form": "false"}),
        Choice("scalar velocities", "solute.face_exchange = true", {"solute.face_exchange": "true"}),
    ]

    def prepare(self, once):
        directory, _ = once({"accuracy.preset": "reference", "mechanics.critical_fraction": 0.1})
        self.reference = self.state(directory)

    def remember(self, directory):
        self.default = self.state(directory)

    @staticmethod
    def state(directory):
        run = Run(directory)
        history = run.history()
        return {"dissolved": history["dissolved_volume_m3_per_m"][-1],
                "acid": history["L1_stored_mol_per_m"][-1],
                "temperature": np.nan_to_num(last(directory).field["temperature"]),
                "cracks": np.array([crack_length(run.snapshot(step)) for step in run.steps])}

    def errors(self, directory, _):
        found, exact = self.state(directory), self.reference
        return {"dissolved volume": abs(found["dissolved"] / exact["dissolved"] - 1),
                "to the default": abs(found["dissolved"] / self.default["dissolved"] - 1),
                "acid in place": abs(found["acid"] / exact["acid"] - 1),
                "temperature": float(np.abs(found["temperature"] - exact["temperature"]).max() / 200),
                "crack length": float(np.abs(found["cracks"] - exact["cracks"]).sum() / exact["cracks"].sum())}


ALL = [Wall(), Channel(), Cooling(), Receding(), Rock()]
