"""Couplings: the arrows between two physics (paper, Fig. 3)."""
import math

from .records import plt, save, section, table


def settling_disc(records, _):
    rows = records["settling_disc"]
    if not rows:
        return None
    against = [100 * (r["reynolds"] / 17.27 - 1) for r in rows]
    return section(
        "A settling disc", "SettlingDisc.SinksAtThePublishedSpeed",
        "A disc of 1.25 times the fluid's density sinks in a channel eight diameters wide. At its terminal speed the "
        "weight must equal the drag that momentum exchange gives. The channel moves and the disc keeps its place, as "
        "vug's rock does.\n\n"
        "Published largest Reynolds numbers, formed with the density of the disc: 17.15 to 17.31 (Glowinski et al. "
        "2001), 17.27 (Wan and Turek 2006).",
        table(["nodes per diameter", "Reynolds number", "to 17.27"],
              [[r["nodes"], f"{r['reynolds']:.2f}", f"{100 * (r['reynolds'] / 17.27 - 1):+.1f} %"] for r in rows]),
        overview=("Reynolds number of a settling disc", "17.27 (Wan and Turek 2006)",
                  f"{min(against):+.1f} % to {max(against):+.1f} %"))


def dissolved_cavity(records, _):
    rows, ledger = records["dissolved_cavity"], records["dissolved_ledger"]
    if not rows or not ledger:
        return None
    rings, thirds = ("1.3 a ... 1.6 a", "1.6 a ... 2 a", "2 a ... 2.5 a"), ("0 ... 30°", "30 ... 60°", "60 ... 90°")
    imbalance = table(["time step / 4e-8 s", "error of the energy"],
                      [[f"{r['fraction']:g}", f"{r['imbalance']:.1e}"] for r in ledger])
    return section(
        "A cavity that dissolves, and its energy",
        "DissolvedCavity.BearsTheStressOfKirschAndThatOfAHoleThatWasCut, DissolvedRock, DissolvedSeam",
        "Acid dissolves a hole of radius a = 10 mm from its middle outwards, in rock with elements of 1.5 mm under 5 "
        "and 7.5 MPa. The table has the hoop stress over that of Kirsch (1898) in rings of elements, from the "
        "direction of the smaller stress (0°) to that of the larger. Beside it stands the same rock with the hole cut "
        "out from the start, along whole triangles.",
        table(["ring", "from the smaller stress", "dissolved", "cut"],
              [[rings[r["ring"]], thirds[r["third"]], f"{r['dissolved']:.3f}", f"{r['cut']:.3f}"] for r in rows]), None,
        "No bond and no contact in the cavity carries a load. Momentum and energy that leave with the dissolved rock "
        "are accounted for: in a block that rings while its middle dissolves, momentum is conserved to 1e-12 and "
        f"energy to second order in the time step:\n\n{imbalance}",
        overview=("hoop stress around a cavity that dissolves", "Kirsch 1898",
                  f"{min(r['dissolved'] for r in rows):.3f} to {max(r['dissolved'] for r in rows):.3f} of it"))


def arrows(records, figures):
    cubic, stress, rate = (records[name] for name in
                           ("coupling_cubic_law", "coupling_thermal_stress", "coupling_arrhenius"))
    if not (cubic and stress and rate):
        return None
    figure, (left, middle, right) = plt.subplots(1, 3, figsize=(10.5, 3.4))
    left.loglog([r["nodes"] for r in cubic], [r["exact"] for r in cubic], "k-", lw=1, label="w³/(12 µ)")
    left.loglog([r["nodes"] for r in cubic], [r["flow"] for r in cubic], "o", label="measured")
    left.set(xlabel="aperture, nodes", ylabel="flow per gradient / m³/(Pa s) per m", title="crack → flow")
    left.set_xticks([r["nodes"] for r in cubic], [str(r["nodes"]) for r in cubic])
    left.minorticks_off()
    middle.plot([1e3 * r["depth"] for r in stress], [r["exact"] / 1e6 for r in stress], "k-", lw=1, label="closed form")
    middle.plot([1e3 * r["depth"] for r in stress], [r["stress"] / 1e6 for r in stress], "o", label="measured")
    middle.set(xlabel="depth below the cold face / mm", ylabel="lateral stress / MPa", title="heat → stress")
    right.semilogy([r["temperature"] for r in rate], [r["exact"] for r in rate], "k-", lw=1, label="Arrhenius and diffusion")
    right.semilogy([r["temperature"] for r in rate], [r["flux"] for r in rate], "o", label="measured")
    right.set(xlabel="temperature of the wall / K", ylabel="acid / mol/(m² s)", title="heat → reaction")
    for axes in (left, middle, right):
        axes.legend(fontsize=8)
    save(figure, figures / "coupling_arrows.png")
    worst = max(abs(r["flux"] / r["exact"] - 1) for r in rate)
    off = max(abs(r["stress"] - r["exact"]) for r in stress) / (27.8e9 * 8e-6 * 100)
    rows = [
        ["flow → rock: force of the fluid", "`HydrodynamicForce`, `HydrostaticForce`, `SettlingDisc`", "above; momentum to 1e-14"],
        ["flow → heat, flow → solutes", "`ConvectedTwoLayers`, `CarriedWave`", "above"],
        ["rock ↔ fluid: conjugate heat", "`TwoLayerEigenmode`, `TwoHalfSpaces`", "above"],
        ["heat → rock: thermal strain", "`CooledSlab`", f"{100 * off:.1f} % of E α ΔT"],
        ["heat → reaction: rate", "`HotWall`", f"{worst:.0e}"],
        ["rock → flow: pathway of a crack", "`CrackedBond`",
         "w³/(12 µ), and 1/(2 n²) more on n nodes, to 1e-4: " +
         ", ".join(f"{r['flow'] / r['exact']:.4f} at {r['nodes']}" for r in cubic)],
        ["reaction → rock: mass and d_c", "`DissolvedTriangle`", "1e-12 per triangle and bond"],
        ["rock → solid: an opened node's volume goes to its triangle, then its neighbours", "`PathwayOpener`, `SolidSpread`, `Balances`", "1e-12"],
        ["reaction → flow: births", "`AwkwardBirths`", "balances 1e-12"],
    ]
    return section(
        "The arrows between the physics", "coupling_*_test.cpp",
        "Each coupling of the paper's Fig. 3 by itself.",
        table(["arrow", "test", "error"], rows), "coupling_arrows.png",
        "A crack of n nodes conducts as the cubic law says, except for the share 1/(2 n²) by which the sum over the "
        "nodes of an exact parabola is larger than its integral: 5.6 % at three nodes.",
        overview=("each coupling of the paper's Fig. 3 by itself", "closed forms, balances",
                  f"thermal stress {100 * off:.1f} % of E α ΔT; rate {worst:.0e}; cubic law (sum over n nodes) 1e-4; "
                  "balances 1e-12"))


def errors_by_direction(rows):
    """A row for each direction of a crack, a column for each aperture in cells; empty where none was measured."""
    apertures = sorted({r["aperture"] for r in rows})
    error = {(r["degrees"], r["aperture"]): r["error"] for r in rows}
    cell = lambda degrees, w: f"{100 * error[degrees, w]:+.1f} %" if (degrees, w) in error else ""
    return table(["direction"] + [f"w = {w:g}" for w in apertures],
                 [[f"{d}°"] + [cell(d, w) for w in apertures] for d in sorted({r["degrees"] for r in rows})])


def strips(records, _):
    rows, cracks = records["pathway_strip"], records["pathway_strip_cracks"]
    if not rows or not cracks:
        return None
    means = [abs(r["mean"]) for r in cracks]
    worst = f"{100 * max(means):.1f} %"
    return section(
        "Pathways in every direction",
        "PathwayStrip.ConductsAlikeInEveryDirection, PathwayStrip.CracksOfManyBondsConductAlikeInEveryDirection",
        "Stokes flow along a crack of four bonds that closes on itself on a periodic lattice is compared with the "
        "plane slot of its aperture in cells, (w³ + w/2)/12. The table has the error by direction and aperture.",
        errors_by_direction(rows), None,
        "- Whole apertures along an axis are exact wherever the line lies "
        "(`PathwayStrip.ObeysTheCubicLawWhereverAnAxisParallelLineLies`).\n"
        "- Along a crack of many bonds the errors average out. The test has cracks of five bonds of random lengths at "
        f"random places, eight for each direction and each of {len({r['aperture'] for r in cracks})} apertures from "
        f"{min(r['aperture'] for r in cracks):g} to {max(r['aperture'] for r in cracks):g} cells. They are off by "
        f"{100 * math.sqrt(sum(r['mean_square'] for r in cracks) / len(cracks)):.1f} % (root mean square over cracks). "
        f"The mean of a direction and aperture is within 5 % in {sum(m <= 0.05 for m in means)} of {len(means)} "
        f"combinations and off by {worst} at most.",
        "- The narrowest strip that is one piece across faces of cells is wider than one cell in oblique directions.\n"
        "- Between 1 and 3 cells a column of n + 1 nodes more or less has a large effect in a bond of 20 columns.",
        ("flow along a crack of many bonds, in every direction", "plane slot, (w³ + w/2)/12",
         f"mean of a direction and aperture within {worst}; a single bond more, see the table"))


def slits(records, _):
    rows, gaps, diffusion = records["slit"], records["gaping_crack"], records["slit_diffusion"]
    if not rows or not gaps or not diffusion:
        return None
    wave = f"{100 * max(abs(r['error']) for r in diffusion):.1f} %"
    lifted = table(["lifted by, cells", "flow rate over that of the cubic law"],
                   [[f"{r['gap']:g}", f"{r['ratio']:.4f}"] for r in gaps])
    narrow = 100 * max(abs(r["error"]) for r in rows if r["aperture"] <= 1)
    return section(
        "Cracks narrower than a cell", "SlitFlow, SlitDiffusion, GapingCrack, Slits",
        "The narrowest strip of nodes with the drag of `damage.aperture = \"opening\"`, and from 1.2 cells on wider "
        "strips, is compared with the cubic law w³/12. The table has the error by direction and width in cells.",
        errors_by_direction(rows), None,
        "- Between walls the drag follows Brinkman's solution to second order (2e-4 at 40 nodes; 9e-4 with "
        "lallemand_luo). Without walls it follows Darcy's law to 1e-8.\n"
        "- The force and torque of the fluid on the rock are those of the pressure at the inlet to 0.2 %.\n"
        "- Diffusion along a row of slits of 0.01 to 1 cells is w D times the gradient to 1e-6. A wave of "
        f"concentration along a crack of 0.3 cells decays at the rate of the slit within {wave} in all of "
        f"{len(diffusion)} directions.\n\nIn a coupled run the upper half of a cracked block is lifted by a given "
        f"number of cells (from 1.6 on, columns of n and n + 1 nodes alternate):\n\n{lifted}",
        overview=("flow and diffusion along cracks narrower than a cell", "w³/12; w D",
                  f"flow within {narrow:.1f} % up to one cell; decay of a wave within {wave}"))


def cracked_slab(records, _):
    rows = records["cracked_slab"]
    if not rows:
        return None
    diffusive = [r["passed"] for r in rows if r["k"] > 1]
    return section(
        "A front of acid in cracked rock", "CrackedSlab",
        "Acid dissolves a slab of 60 x 24 cells from one side. Two of every three bonds are open as pathways of three "
        "cells. The solid of the opened cells is still there, in the nodes beside them, never more than two cells' "
        "worth in one node.\n\n"
        "The table has times over those of the same rock uncracked, means of five rocks: until half of the slab's "
        "solid is gone, and until 1 % is left of its first half (no stones stay behind).",
        table(["k h/D", "cracks", "half gone", "first half gone", "most in a node, cells"],
              [[f"{r['k']:g}", r["cracks"], f"{r['half']:.3f}", f"{r['passed']:.3f}", f"{r['most']:.2f}"]
               for r in rows]), None,
        "- Where diffusion decides, k h/D = 100 with h the cell, cracks must not matter. The exception is acid that "
        "goes ahead in cracks that are open before it comes.\n"
        "- Where the reaction decides, cracks do matter: the walls of open pathways are reactive surface.",
        overview=("time in which acid dissolves cracked rock", "the same rock uncracked",
                  "where diffusion decides, first half of the slab: " + " and ".join(f"{x:.3f}" for x in diffusive)
                  + " of it"))


entries = [settling_disc, dissolved_cavity, arrows, strips, slits, cracked_slab]
