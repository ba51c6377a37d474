"""Flow: each entry takes (records, folder of figures) and returns its section, or None where its test was not run."""
import numpy as np

from .records import plt, save, section, table

# Ghia, Ghia and Shin, J. Comput. Phys. 48 (1982) 387, tables I and II: 129 x 129 nodes, by Reynolds number.
GHIA_Y = [0.0547, 0.0625, 0.0703, 0.1016, 0.1719, 0.2813, 0.4531, 0.5, 0.6172, 0.7344, 0.8516, 0.9531, 0.9609, 0.9688, 0.9766]
GHIA_X = [0.0625, 0.0703, 0.0781, 0.0938, 0.1563, 0.2266, 0.2344, 0.5, 0.8047, 0.8594, 0.9063, 0.9453, 0.9531, 0.9609, 0.9688]
GHIA_U = {
    100: [-0.03717, -0.04192, -0.04775, -0.06434, -0.10150, -0.15662, -0.21090, -0.20581, -0.13641, 0.00332, 0.23151,
          0.68717, 0.73722, 0.78871, 0.84123],
    1000: [-0.18109, -0.20196, -0.22220, -0.29730, -0.38289, -0.27805, -0.10648, -0.06080, 0.05702, 0.18719, 0.33304,
           0.46604, 0.51117, 0.57492, 0.65928],
}
GHIA_V = {
    100: [0.09233, 0.10091, 0.10890, 0.12317, 0.16077, 0.17507, 0.17527, 0.05454, -0.24533, -0.22445, -0.16914,
          -0.10313, -0.08864, -0.07391, -0.05906],
    1000: [0.27485, 0.29012, 0.30353, 0.32627, 0.37095, 0.33075, 0.32235, 0.02526, -0.31966, -0.42665, -0.51550,
           -0.39188, -0.33714, -0.27669, -0.21388],
}


def largest(rows, key="error"):
    return max(abs(row[key]) for row in rows)


def poiseuille(records, figures):
    exact, slip, single = (records[f"flow_poiseuille{name}"] for name in ("", "_slip", "_float"))
    profile = records["flow_poiseuille_profile"]
    if not (exact and slip and single and profile):
        return None
    figure, (left, right) = plt.subplots(1, 2, figsize=(8.4, 3.3))
    y = np.linspace(0, 1, 200)
    left.plot(4 * y * (1 - y), y, "k-", lw=1, label="exact")
    for collision, marker in (("trt", "o"), ("bgk", "x")):
        rows = [row for row in profile if row["collision"] == collision]
        left.plot([row["u"] for row in rows], [row["y"] for row in rows], marker, label=f"{collision}, 5 nodes")
    left.set(xlabel="velocity / largest velocity", ylabel="height / width of the channel", title="Profile, τ = 0.764")
    left.legend()
    widths = sorted({row["n"] for row in slip})
    for collision, marker in (("bgk", "x"), ("lallemand_luo", "s")):
        errors = [next(row["error"] for row in slip if row["collision"] == collision and row["n"] == n) for n in widths]
        right.loglog(widths, errors, marker + "--", label=collision)
    right.loglog(widths, [max(r["error"] for r in exact if r["n"] == n) for n in widths], "o-", label="trt, worst of all τ")
    rows = [max(r["error"] for r in single if r["n"] == n) for n in sorted({r["n"] for r in single})]
    right.loglog(sorted({r["n"] for r in single}), rows, "d-", label="trt in float, worst of all τ")
    right.set(xlabel="nodes across the channel", ylabel="relative L2 error of the velocity", title="Error")
    right.legend(fontsize=8)
    save(figure, figures / "poiseuille.png")
    widths = sorted({row["n"] for row in exact})
    rows = [[n, f"{largest([r for r in exact if r['n'] == n]):.1e}"] for n in widths]
    return section(
        "Poiseuille flow",
        "Poiseuille.ExactAtAnyWidthAndViscosityWithTwoRelaxationTimes",
        "Flow in a channel between two plates, driven by a body force, is compared with the parabola.",
        table(["nodes", "largest relative error, τ = 0.55 … 5"], rows), "poiseuille.png",
        "- With two relaxation times and Λ = 3/16 (Ginzburg and d'Humières), halfway bounce-back places the wall "
        "exactly half way. Channels of one node and more are therefore exact to round-off for τ from 0.55 to 5.\n"
        f"- In float the error stays below {largest(single):.0e} for speeds from 1e-2 down to 1e-12 lattice units, "
        "because populations are stored as deviations from rest.",
        "The other collisions have slip at the wall, by the amount that theory predicts (asserted to ten digits).",
        ("velocity between two plates", "the parabola",
         f"round-off, {largest(exact):.1e} at most (two relaxation times, Λ = 3/16)"))


def couette(records, figures):
    rows = records["flow_couette"]
    if not rows:
        return None
    figure, axes = plt.subplots(figsize=(4.6, 3.4))
    axes.plot([0, 1], [0, 1], "k-", lw=1, label="exact")
    axes.plot([row["u"] for row in rows], [row["y"] for row in rows], "o", label="trt, 7 nodes")
    axes.set(xlabel="velocity / velocity of the wall", ylabel="height / width of the channel")
    axes.legend()
    save(figure, figures / "couette.png")
    error = max(abs(row["u"] - row["y"]) for row in rows)
    return section(
        "Couette flow", "Couette.LinearProfileIsExactInEveryCollision",
        "A sliding wall drags the fluid along. The exact profile is linear.",
        None, "couette.png",
        "The linear profile is exact to round-off for each of the four collisions and for walls that move on any side "
        f"of the lattice. The largest deviation here is {error:.0e} of the wall's speed.",
        overview=("velocity beside a sliding wall", "the linear profile",
                  f"round-off, {error:.0e} of the wall's speed"))


def taylor_green(records, figures):
    rows = records["flow_taylor_green"]
    if not rows:
        return None
    figure, axes = plt.subplots(figsize=(5.4, 3.8))
    lines = sorted({(row["carrier"], row["collision"]) for row in rows})
    results = []
    for carrier, collision in lines:
        points = sorted((r["n"], r["error"]) for r in rows if (r["carrier"], r["collision"]) == (carrier, collision))
        n, error = np.array(points).T
        label = collision if carrier == 0 else f"{collision} on a flow of {carrier:g} U"
        axes.loglog(n, error, "o-" if carrier == 0 else "s--", ms=4, label=label)
        results.append([collision, f"{carrier:g} U", f"{error[-1]:.1e} at {n[-1]:.0f}",
                        f"{np.log(error[-2] / error[-1]) / np.log(n[-1] / n[-2]):.2f}"])
    n = np.array([32, 128])
    axes.loglog(n, 1.5 / n**2, "k:", label="second order")
    axes.set(xlabel="nodes per side", ylabel="relative L2 error of the velocity")
    axes.set_xticks([32, 64, 128], ["32", "64", "128"])
    axes.minorticks_off()
    axes.legend(fontsize=8)
    save(figure, figures / "taylor_green.png")
    return section(
        "Taylor-Green vortices, at rest and carried", "TaylorGreen.SecondOrderInEveryCollision, "
        "TaylorGreen.SecondOrderAlsoOnAUniformFlow",
        "Periodic vortices at Reynolds number 100 decay until their speed U has halved. They are compared with the "
        "exact solution of the Navier-Stokes equations, both at rest and carried obliquely by a uniform flow of U and "
        "2 U. By Galilean invariance the uniform flow must change nothing.",
        table(["collision", "uniform flow", "error at nodes", "order"], results), "taylor_green.png",
        "The error falls with the square of the resolution in both cases. What remains is an error of the phase, a "
        "share of order (k dx)² of the distance travelled.",
        overview=("decaying vortices, at rest and carried by a uniform flow", "exact solution of Navier-Stokes",
                  f"order {min(float(row[3]) for row in results):.2f} to {max(float(row[3]) for row in results):.2f}"))


def cavity(records, figures):
    extremes, profile = records["flow_cavity"], records["flow_cavity_profile"]
    if not (extremes and profile):
        return None
    reynolds = sorted({row["reynolds"] for row in profile})
    figure, panels = plt.subplots(1, 2, figsize=(8, 3.3))
    for k, re in enumerate(reynolds):
        n = max(row["n"] for row in profile if row["reynolds"] == re)
        rows = sorted((r["at"], r["u"], r["v"]) for r in profile if r["reynolds"] == re and r["n"] == n)
        at, u, v = np.array(rows).T
        for axes, values, where, ghia in ((panels[0], u, GHIA_Y, GHIA_U), (panels[1], v, GHIA_X, GHIA_V)):
            axes.plot(at, values, f"C{k}-", label=f"Re {re:g}, {n} nodes")
            axes.plot(where, ghia[int(re)], f"C{k}o", mfc="none", ms=4, label=f"Ghia et al., Re {re:g}")
    panels[0].set(xlabel="y, on the line x = 1/2", ylabel="u / speed of the lid")
    panels[1].set(xlabel="x, on the line y = 1/2", ylabel="v / speed of the lid")
    panels[0].legend(fontsize=8)
    save(figure, figures / "cavity.png")
    rows = [[f"{r['reynolds']:g}", r["n"], r["name"], f"{r['measured']:.5f}",
             f"{r['converged']:.5f} ({100 * (r['measured'] / r['converged'] - 1):+.2f} %)",
             f"{r['ghia']:.5f} ({100 * (r['measured'] / r['ghia'] - 1):+.2f} %)"] for r in extremes]
    return section(
        "Lid-driven cavity", "LidCavity.Reynolds100, LidCavity.Reynolds1000",
        "The velocity on the centre lines is compared with the table of Ghia, Ghia and Shin (J. Comput. Phys. 48, "
        "1982, 387). Its extremes are also compared with values that are converged to six digits:\n\n"
        "- Re 100: Marchi, Suero and Araki (2009);\n"
        "- Re 1000: the spectral solution of Botella and Peyret (Comput. Fluids 27, 1998, 421).",
        table(["Re", "nodes", "extreme", "measured", "converged (deviation)", "Ghia et al. (deviation)"], rows),
        "cavity.png",
        limits="The table of 1982 is itself 1.5 to 3.4 % below the converged values, so that a converged result cannot "
        "agree with it better than that.",
        overview=("extremes of the velocity in a cavity, Re 100 and 1000",
                  "converged tables (Marchi; Botella and Peyret)",
                  f"within {100 * max(abs(r['measured'] / r['converged'] - 1) for r in extremes):.2f} %"))


def open_channel(records, figures):
    channel, profile, vortex = (records[f"flow_{name}"] for name in ("pressure_channel", "outflow_profile", "outflow_vortex"))
    mirror, itself = ([row for row in channel if row["rule"] == rule] for rule in ("mirror", "itself"))
    if not (mirror and itself and profile and vortex):
        return None
    widths = sorted({row["n"] for row in channel})

    def line(name, rows):
        rate = {row["n"]: f"{100 * row['flow_rate']:+.3f} %" for row in rows}
        return [name] + [rate.get(n, "") for n in widths]

    names = ["trt"] + sorted({row["collision"] for row in mirror} - {"trt"})
    rows = [line(name, [row for row in mirror if row["collision"] == name]) for name in names]
    rows.append(line("trt, each link its own image", itself))
    without_pressure = {0.2: "0.09 %", 0.5: "0.55 %", 1: "2.4 %"}  # measured once, without the pressure along the side
    echoes = table(["largest speed in the vortex", "energy that comes back", "without the pressure along the side"],
                   [[f"{row['speed']:g} U", f"{100 * row['echo']:.3f} %", without_pressure.get(row["speed"], "")]
                    for row in sorted(vortex, key=lambda row: row["speed"])])
    return section(
        "Channels between open sides",
        "PressureDrivenChannel, Outflow.DevelopedProfileLeavesUnchangedInEveryDirectionAndCollision, "
        "Outflow.AVortexLeavesWithoutAnEcho, Outflow.AVortexLeavesAlikeThroughEverySideAndAnywhereOnIt",
        "**Pressure sides.** Creeping flow in a channel of length 4 H between two pressures. The table shows the error "
        "of the flow rate (sum over the cells of a cross-section) against G H³/(12 ν), with the gradient G over the "
        "whole length from side to side. Its last line is for the rule that the mirror image replaces: "
        "anti-bounce-back of each link by itself, which leaves the shear along a side free.\n\n"
        "**Outflow.** Behind an inlet with plug flow the profile develops, and must leave through the outflow "
        "unchanged. A vortex carried by a flow U must leave without sending energy back.",
        table(["collision"] + [f"{n} cells" for n in widths], rows), None,
        "Pressure sides: the flow rate converges with second order in every collision. None of its error comes from "
        "the sides.\n\n"
        "- The slip of the walls and the sum together give (8 Λ - 1)/n², with Λ the product of the collision.\n"
        "- With `trt`, Λ = 3/16, the walls have no slip: every node has the speed of the parabola. The table then "
        "shows the midpoint sum of an exact parabola, 1/(2 n²).\n"
        f"- No node from side to side deviates by more than {largest(mirror, 'field'):.0e} of the mean speed from the "
        "parabola with the slip that theory predicts. The speed along the sides is at most "
        f"{largest(mirror, 'along_side'):.0e} of the mean speed. These two are for an outlet on the right. With the "
        "outlet on any of the four sides and in every collision, the test requires on 5 cells that velocities deviate "
        "by less than 1e-6 of the mean speed, and pressures by less than 1e-6 of the difference applied.\n"
        "- Anti-bounce-back of each link by itself carries too much on any lattice, with speeds along the sides of up "
        f"to {largest(itself, 'along_side'):.2f} of the mean.\n\n"
        f"Outflow: the developed profile leaves unchanged to {largest(profile):.0e} of the mean speed, with the "
        "pressure at its reference on the side. The share of a vortex's energy that comes back, with and without the "
        f"pressure along the side through which it leaves:\n\n{echoes}",
        overview=("flow rate between two pressures", "G H³/(12 ν)",
                  "second order, no error from the sides; `trt` "
                  f"{rows[0][-1]} at {widths[-1]} cells"))


def cylinder(records, figures):
    rows = sorted(records["cylinder"], key=lambda row: row["cells"])
    if not rows:
        return None

    def against(value, exact):
        return f"{value:.5f} ({100 * (value / exact - 1):+.2f} %)"

    finest = rows[-1]
    return section(
        "Drag and lift of a cylinder", "Cylinder.*, CylinderLong.*",
        "The benchmark 2D-1 of Schäfer and Turek (1996): a cylinder a little below the middle of a channel, at "
        "Reynolds number 20. The program runs `cases/cylinder.toml`, and drag and lift are read from its "
        "`history.csv`.\n\n- Published bounds: C_D 5.57 to 5.59, C_L 0.0104 to 0.0110.\n"
        "- Converged values (Nabh 1998): 5.57954 and 0.010619. Deviations are given against these.",
        table(["cells per diameter", "C_D", "C_L"],
              [[row["cells"], against(row["drag"], 5.57953523384), against(row["lift"], 0.010618948146)]
               for row in rows]),
        limits="The circle is a staircase on the lattice. Its error is of first order in the cell over the diameter, "
        "and not smooth (the lift is a five-hundredth of the drag). A time step half as long changes the drag by 2e-4.",
        overview=("drag and lift of a cylinder, Re 20", "Schäfer and Turek 1996, Nabh 1998",
                  f"{100 * (finest['drag'] / 5.57953523384 - 1):+.2f} % and "
                  f"{100 * (finest['lift'] / 0.010618948146 - 1):+.2f} % at {finest['cells']} cells per diameter"))


entries = [poiseuille, couette, open_channel, taylor_green, cavity, cylinder]
