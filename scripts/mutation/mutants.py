"""The mutants: generated ones, at most one on a line, and those that somebody has named."""
import re
import zlib
from dataclasses import dataclass

from .source import Source

LAWS = {
    "kernels": """flow/equilibrium.hpp flow/face_flow.cpp flow/flow.cpp flow/flow_fields.cpp flow/guards.cpp
        flow/link_populations.cpp flow/mirrored_links.hpp flow/momentum_exchange.cpp flow/mrt.hpp flow/open_boundary.cpp
        flow/outflow.hpp flow/outflow_pieces.cpp flow/outflow_pressure.hpp flow/slit_drag.cpp flow/two_relaxation_times.hpp heat/heat.cpp heat/heat.hpp heat/heat_boundary.cpp
        heat/heat_conditions.hpp heat/heat_convection.hpp heat/heat_kernels.hpp heat/heat_openings.cpp
        heat/heat_step.cpp heat/heat_sums.cpp heat/thermal_flow.cpp nodes/mirror_links.cpp nodes/opening.cpp
        reaction/dissolution.cpp reaction/joint_fluxes.hpp reaction/joint_walls.cpp reaction/link_area.hpp
        reaction/reacting_solutes.cpp reaction/reaction.hpp reaction/reactive_links.cpp reaction/reactive_wall.cpp reaction/reactive_wall_kernel.hpp
        reaction/reactive_wall_step.hpp reaction/solid_share.hpp reaction/surface_normal.cpp scalar/advective_form.cpp
        scalar/rounding.hpp scalar/scalar_equilibrium.hpp scalar/turning.hpp solute/face_exchange.cpp
        solute/slit_diffusion.cpp solute/slit_diffusion.hpp solute/solute.cpp solute/solute_boundary.cpp
        solute/solute_sweep.hpp""",
    "dem": """accounts.hpp bond_elasticity.hpp bond_failure.hpp bond_kinematics.hpp bond_law.hpp bond_model.hpp
        bonds.cpp closest_point.hpp cohesion_fit.cpp contact_forces.hpp contact_law.hpp contacts.cpp crack_aperture.cpp
        critical_step.cpp
        dissolved_rock.hpp elastic_energy.hpp elasticity.hpp energy.cpp forces.cpp gauges.cpp heterogeneity.hpp
        integrate.cpp laboratory.cpp linear_rock.cpp loads.cpp mass_loss.cpp materials.cpp mean_stress.cpp mechanics.cpp
        mechanics_preload.cpp monitors.cpp outer_forces.cpp particles.cpp pieces.cpp push.hpp quench.cpp
        rest.cpp servo.cpp slab_cooling.cpp soundness.cpp splitting.hpp
        static_equilibrium.cpp support_growth.cpp thermal_strain.hpp timed_loads.cpp toughness.hpp triangle.hpp""",
    "coupling": """ageing.hpp ageing_looks.hpp ageing_module.cpp amount_share.hpp build_modules.cpp chemical_damage.cpp
        body_forces.cpp body_forces.hpp carried_steps.cpp carried_steps.hpp chemical_damage.hpp concerns.cpp
        corner_contacts.cpp corner_forces.cpp corner_forces.hpp
        driving_pressure.cpp error_bars.cpp events.cpp face_temperature.hpp far_pressures.cpp
        flow_accounts.cpp flow_boundaries.cpp flow_concerns.cpp
        flow_limits.cpp flow_module.cpp flow_paths.cpp force_change.cpp force_speed.cpp given_changes.cpp
        given_passages.cpp
        grid_convergence.hpp handed_push.cpp
        heat_accounts.cpp heat_intervals.cpp heat_module.cpp heat_ranks.cpp heat_setup.cpp history_difference.cpp
        initial_pathways.cpp interval_chooser.cpp intervals.hpp joint_reactions.cpp mechanics_accounts.cpp
        mechanics_module.cpp minerals.cpp mouths.cpp narrow_passages.cpp openings.cpp output_schedule.cpp
        pathway_nodes.cpp pathway_widths.hpp pathways.cpp pathways.hpp passages.cpp pore_runs.cpp weight_wave.cpp
        plane_waves.cpp pore_growth.cpp pore_width.cpp pressed_speed.cpp reaction_accounts.cpp reaction_intervals.cpp reaction_losses.cpp
        reaction_module.cpp reaction_setup.cpp read_fields.hpp rock.cpp rock_gauges.cpp rock_limits.cpp rock_loads.cpp
        rock_map.cpp rock_pathways.cpp simulation.cpp simulation_state.cpp slit.hpp slits.cpp solid_spread.cpp
        solute_intervals.cpp solute_limits.cpp solute_module.cpp specimen.cpp steady_flow.hpp step_times.hpp stretch_ends.cpp strip.cpp
        surfaces.cpp temperature_range.cpp thermal_exchange.cpp tuning.cpp twins.cpp velocity_profile.cpp ways_out.cpp
        wet_nodes.cpp""",
    "io": """detail/quantity.cpp narrow_cracks.hpp rock_inertia.cpp scene/boundaries.hpp scene/fluid.cpp scene/laboratory.hpp
        scene/reaction.hpp time_table.hpp units.hpp""",
    "study": "sampling.cpp",
}
# Files of those libraries with FEW or more lines that could be wrong, but no law: how numbers lie in memory, are spread
# over threads and ranks, read and written, or what is said of them. tests/meta/mutant_lists.py holds that every other
# such file is in LAWS.
FEW = 8
NO_LAWS = {
    "kernels": """heat/heat_bands.hpp launch/launch.hpp
        launch/launch_lists.hpp launch/own_items.hpp launch/row_launch.hpp nodes/fluid_nodes.cpp nodes/fluid_nodes.hpp
        nodes/fluid_rows.cpp nodes/fluid_surface.cpp nodes/source_windows.hpp nodes/streaming.hpp packs/portable.hpp""",
    "dem": """gather_contacts.hpp launch_in_turn.hpp mechanics.hpp neighbour_grid.cpp pair_candidates.hpp parameters.hpp require_edges.cpp
        require_parameters.cpp rock_share.cpp""",
    "coupling": """check.cpp check_text.cpp choices.cpp dimensionless.cpp explain.cpp flow_ranks.cpp fluid_picture.cpp
        fluid_picture.hpp geometry.cpp interval_warnings.cpp laboratory_report.cpp laboratory_run.cpp mechanics_ranks.cpp
        memory_need.cpp reaction_ranks.cpp recorded_run.cpp run.cpp run_book.cpp run_files.cpp run_sum.hpp shared_field.cpp solute_ranks.cpp split.cpp tasks.cpp""",
    "io": """assembly_quality.cpp case_reader.cpp case_tables_boundary.cpp case_tables_domain.cpp case_tables_fluid.cpp
        case_tables_gauge.cpp case_tables_rock.cpp checkpoint.cpp detail/check_boundaries.cpp detail/check_laboratory.cpp
        detail/check_minerals.cpp detail/check_names.cpp detail/check_places.cpp detail/check_scales.cpp
        detail/check_tables.cpp detail/check_times.cpp detail/circle.hpp detail/circle_outline.cpp
        detail/delaunay.cpp detail/disc_outline.cpp detail/element_size.cpp detail/hdf5_file.cpp
        detail/image_npy.cpp detail/image_nrrd.cpp detail/image_plain.cpp detail/image_png.cpp detail/image_tiff.cpp
        detail/input_file.cpp detail/line.hpp detail/mesh_sections.cpp detail/nearest_name.cpp
        detail/poisson_disc.cpp detail/rock_mesher.cpp detail/rock_outline.cpp detail/rock_snapshots.cpp detail/toml_cursor.cpp
        detail/toml_cursor_read.cpp detail/toml_document.cpp
        detail/toml_hazards.cpp detail/toml_hint.cpp detail/toml_override.cpp detail/warnings.cpp detail/warnings_of_pores.cpp detail/warnings_of_units.cpp
        form.cpp
        history_writer.cpp image_reader.cpp json_text.cpp mesh_reader.cpp message.cpp notch_remarks.cpp
        palette_picture.cpp progress.cpp rock_generator.cpp rock_regions.cpp run_folder.cpp
        run_summary.cpp""",
    "study": "pool.cpp study_reader.cpp sweep.cpp table.cpp",
}
# Lines on which a mutant says nothing about a law: text, layout of memory, loops, what a compiler must know.
NOT_A_LAW = re.compile(
    r"constexpr \w+ \w+ =|constexpr \w+ \w+\[|if constexpr|static_assert|template|^for \(|throw|Error\(|fmt::|"
    r"push_back\(\{\"|KOKKOS_ASSERT|assert\(|VUG_|prefetch|announce|View<|describ|View\(|view\(\"|_cast<std::size_t|"
    r"resize|Policy|operator|deep_copy|\"vug::|describe|using |enum |^#|std::ceil|std::to_string|name")
NOT_A_VALUE = re.compile(r"\b(capacity|plane|pitch|stride|offset|extent|block\w*|slot|root|capacity_|at|later|ahead|"
                         r"item|first|last|begin|end|row|count|size|nx|ny|plane_|far|near|lattice|node|index)\b")


@dataclass(frozen=True)
class Mutant:
    name: str  # stays as long as its line does
    path: str  # below src
    line: int
    start: int  # what is replaced
    end: int
    kind: str  # flip, invert, twice, swap, deny, zero, or replace
    text: str = ""  # for replace

    @property
    def library(self):
        return self.path.split("/")[0]


def candidates(source):
    """(line, start, end, kind) of all that could be wrong."""
    tokens = source.tokens

    def span(first, last):
        return None if last is None or last < first else (tokens[first].start, tokens[last].end)

    for k, token in enumerate(tokens):
        found = []
        if token.text in ("+", "-") and source.is_binary(k):
            found = [(span(k + 1, source.term_end(k + 1)), "flip")]
        elif token.text in ("*", "/") and source.is_binary(k):
            found = [(span(k + 1, source.unary_end(k + 1)), kind) for kind in ("invert", "twice")]
        elif token.text in ("+=", "-="):
            found = [(span(k + 1, source.statement_end(k + 1)), kind) for kind in ("flip", "twice")]
        elif token.text in ("*=", "/="):
            found = [(span(k + 1, source.statement_end(k + 1)), "invert")]
        elif token.text == "-" and not source.is_operand_end(k - 1):
            found = [(span(k + 1, source.unary_end(k + 1)), "flip")]
        elif token.text == "if" and tokens[k + 1].text == "(":
            found = [(span(k + 2, source.closing(k + 1) - 1), "deny")]
        elif token.text == "?":
            found = [(span(source.condition_start(k), k - 1), "deny")]
        elif token.text in ("0", "1") and tokens[k - 1].text == "," and tokens[k + 1].text == ")":
            opening = source.opening(k)
            if opening > 0 and tokens[opening].text == "(" and tokens[opening - 1].text not in ("pair", "along", "closed"):
                found = [(span(k, k), "swap")]
        elif (token.text == "time" and tokens[k - 1].text in (",", "(") and tokens[k + 1].text == ")"
              and tokens[k - 2].text != "move"):
            found = [(span(k, k), "zero")]  # what is given over time stays as it begins
        elif token.kind == "number" and ("." in token.text) and not token.text.startswith("0x"):
            found = [(span(k, k), "twice")]
        for where, kind in found:
            if where and not (kind == "deny" and "auto" in source.text[where[0]:where[1]] or ";" in source.text[where[0]:where[1]]):
                yield token.line, *where, kind


def generated(path, text):
    """At most one mutant on a line of law, chosen by what stands on it."""
    source = Source(text)
    by_line = {}
    for line, start, end, kind in candidates(source):
        if NOT_A_LAW.search(source.line_text(line)):
            continue
        if kind in ("flip", "invert") and NOT_A_VALUE.search(text[start:end]):
            continue
        by_line.setdefault(line, []).append((start, end, kind))
    seen = {}
    for line, choices in sorted(by_line.items()):
        choices = [choice for choice in choices if choice[2] == "zero"] or choices
        key = zlib.crc32(source.line_text(line).encode())
        start, end, kind = choices[key % len(choices)]
        stem = path.rsplit("/", 1)[1].replace(".", "_").removesuffix("_cpp").removesuffix("_hpp")
        name = f"{stem}.{kind}.{key & 0xFFFF:04x}"
        seen[name] = seen.get(name, 0) + 1
        if seen[name] > 1:
            name += f".{seen[name]}"
        yield Mutant(name, path, line, start, end, kind)


def named(list_text, read):
    """Those of the list: blocks of `name path`, what stands there once, `=>`, what is wrong. Returns mutants, stale names."""
    mutants, stale = [], []
    for block in re.split(r"\n\s*\n", re.sub(r"^#[^\n]*\n", "", list_text, flags=re.MULTILINE).strip()):
        head, body = block.split("\n", 1)
        name, path = head.split()
        old, new = (part.strip("\n").strip() for part in body.split("=>"))
        text = read(path)
        if text is None or text.count(old) != 1:
            stale.append(name)
            continue
        start = text.index(old)
        mutants.append(Mutant(name, path, text.count("\n", 0, start) + 1, start, start + len(old), "replace", new))
    return mutants, stale


def equivalent(root):
    """Names of those that change no number (scripts/mutation/equivalent.txt)."""
    lines = (root / "scripts/mutation/equivalent.txt").read_text().splitlines()
    return {line.split()[0] for line in lines if line and not line.startswith("#")}


def all_mutants(root):
    """(mutants, stale names), named ones first."""
    sources = root / "src"

    def read(path):
        return (sources / path).read_text() if (sources / path).exists() else None

    mutants, stale = named((root / "scripts/mutation/named.txt").read_text(), read)
    left_out = [(m.path, m.start, m.end) for m in mutants if "@ON" in m.text]  # nothing wakes in there
    for library, files in LAWS.items():
        for file in files.split():
            text = read(f"{library}/{file}")
            if text is not None:
                mutants += [m for m in generated(f"{library}/{file}", text)
                            if not any(m.path == path and m.start < end and start < m.end for path, start, end in left_out)]
    return mutants, stale
