"""Couplings: the arrows between two physics (paper, Fig. 3)."""
import math

from .records import plt, save, section, table


def settling_disc(records, _):
    rows = records["settling_disc"]
    if not rows:
        return None
    return section(
        "A settling disc", "SettlingDisc.SinksAtThePublishedSpeed",
        "A disc of 1.25 times the fluid's density sinks in a channel eight diameters wide; its weight must be the drag that "
        "momentum exchange gives. The channel moves and the disc keeps its place, as vug's rock does. Published largest "
        "Reynolds numbers, formed with the density of the disc: 17.15 to 17.31 (Glowinski et al. 2001), 17.27 (Wan and "
        "Turek 2006).",
        table(["nodes per diameter", "Reynolds number", "to 17.27"],
              [[r["nodes"], f"{r['reynolds']:.2f}", f"{100 * (r['reynolds'] / 17.27 - 1):+.1f} %"] for r in rows]))


def dissolved_cavity(records, _):
    rows, ledger = records["dissolved_cavity"], records["dissolved_ledger"]
    if not rows or not ledger:
        return None
    rings, thirds = ("1.3 a ... 1.6 a", "1.6 a ... 2 a", "2 a ... 2.5 a"), ("0 ... 30°", "30 ... 60°", "60 ... 90°")
    return section(
        "A cavity that dissolves, and its energy",
        "DissolvedCavity.BearsTheStressOfKirschAndThatOfAHoleThatWasCut, DissolvedRock, DissolvedSeam",
        "Acid eats a hole of radius a = 10 mm from its middle outwards into rock with elements of 1.5 mm under 5 and 7.5 MPa. "
        "Hoop stress over that of Kirsch (1898) in rings of elements, from the smaller stress (0°) to the larger; beside it "
        "the same rock with the hole cut out from the start, along whole triangles. No bond and no contact in the cavity "
        "carries anything. What goes with the rock is booked: of a block that rings while its middle dissolves momentum is "
        "kept to 1e-12 and energy to second order in the time step, to " +
        ", ".join(f"{r['imbalance']:.1e} at {r['fraction']:g}" for r in ledger) + " of 4e-8 s.",
        table(["ring", "from the smaller stress", "dissolved", "cut"],
              [[rings[r["ring"]], thirds[r["third"]], f"{r['dissolved']:.3f}", f"{r['cut']:.3f}"] for r in rows]))


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
        "Each coupling of the paper's Fig. 3 by itself. A crack of n nodes conducts as the cubic law says, but for the share "
        "1/(2 n²) that the sum over the nodes of an exact parabola is larger than its integral: 5.6 % at three nodes.",
        table(["arrow", "test", "error"], rows), "coupling_arrows.png")


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
    return section(
        "Pathways in every direction",
        "PathwayStrip.ConductsAlikeInEveryDirection, PathwayStrip.CracksOfManyBondsConductAlikeInEveryDirection",
        "Stokes flow along a crack of four bonds that closes on itself on a periodic lattice, against the plane slot of its "
        "aperture in cells, (w³ + w/2)/12. Whole apertures along an axis are exact wherever the line lies "
        "(`PathwayStrip.ObeysTheCubicLawWhereverAnAxisParallelLineLies`). The narrowest strip that is one piece across faces "
        "of cells is wider than one cell in oblique directions. Between 1 and 3 cells a column of n + 1 nodes more or less "
        "counts for much in a bond of 20 columns. Along a crack that averages out: cracks of five bonds of random lengths at "
        f"random places, eight for each direction and each of {len({r['aperture'] for r in cracks})} apertures from "
        f"{min(r['aperture'] for r in cracks):g} to {max(r['aperture'] for r in cracks):g} cells, are off by "
        f"{100 * math.sqrt(sum(r['mean_square'] for r in cracks) / len(cracks)):.1f} % (root mean square over cracks); the mean "
        f"of a direction and aperture is within 5 % in {sum(m <= 0.05 for m in means)} of {len(means)} and off by "
        f"{100 * max(means):.1f} % at most.",
        errors_by_direction(rows))


def slits(records, _):
    rows, gaps, diffusion = records["slit"], records["gaping_crack"], records["slit_diffusion"]
    if not rows or not gaps or not diffusion:
        return None
    return section(
        "Cracks narrower than a cell", "SlitFlow, SlitDiffusion, GapingCrack, Slits",
        "The narrowest strip of nodes with the drag of `damage.aperture = \"opening\"`, and from 1.2 cells on wider strips, "
        "against the cubic law w³/12, by direction. Between walls the drag follows Brinkman's solution to second order "
        "(2e-4 at 40 nodes; 9e-4 with lallemand_luo), without walls Darcy's law to 1e-8. In a coupled run the upper half of a cracked "
        "block is lifted by so many cells: flow rate over that of the cubic law "
        + ", ".join(f"{r['ratio']:.4f} at {r['gap']:g}" for r in gaps) + " (from 1.6 on columns of n and n + 1 nodes in turn). "
        "The force and torque of the fluid on the rock are those of the pressure at the inlet to 0.2 %. "
        "What diffuses along a row of slits of 0.01 to 1 cells is w D times the gradient to 1e-6; a wave of concentration along a crack of 0.3 "
        f"cells decays at the rate of the slit within {100 * max(abs(r['error']) for r in diffusion):.1f} % in all of "
        f"{len(diffusion)} directions.",
        errors_by_direction(rows))


def cracked_slab(records, _):
    rows = records["cracked_slab"]
    if not rows:
        return None
    return section(
        "A front of acid in cracked rock", "CrackedSlab",
        "A slab of 60 x 24 cells that acid dissolves from one side, with two bonds of three open as pathways of three cells; "
        "the solid of the opened cells is still there, in the nodes beside them, never more than two cells' worth in one. "
        "Times over those of the same rock uncracked, means of five rocks: until half of the slab's solid is gone, and until 1 % is left of its "
        "first half (no stones stay behind). Where diffusion decides, k h/D = 100 with h the cell, cracks must not matter, "
        "but for acid that goes ahead in those that are open before it comes. Where the reaction decides, they do: the walls of open pathways are reactive surface.",
        table(["k h/D", "cracks", "half gone", "first half gone", "most in a node, cells"],
              [[f"{r['k']:g}", r["cracks"], f"{r['half']:.3f}", f"{r['passed']:.3f}", f"{r['most']:.2f}"] for r in rows]))


entries = [settling_disc, dissolved_cavity, arrows, strips, slits, cracked_slab]
