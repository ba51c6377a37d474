"""Solutes, reaction and dissolution: each entry takes (records, folder of figures) and returns its section, or None where its test was not run."""
import numpy as np

from .records import plt, save, section, table


def carried_wave(records, figures):
    rows = records["solute_carried_wave"]
    if not rows:
        return None
    figure, axes = plt.subplots(figsize=(5.2, 3.6))
    cells = []
    for peclet, style in zip(sorted({r["Pe"] for r in rows}), ("-", "--")):
        points = sorted((r["n"], r["D2Q5"], r["D2Q9"]) for r in rows if r["Pe"] == peclet)
        n, five, nine = np.array(points).T
        for name, error, colour in (("D2Q5", five, "C0"), ("D2Q9", nine, "C1")):
            axes.loglog(n, error, colour + "o" + style, ms=4, label=f"{name}, Pe = {peclet:g}")
            cells.append([name, f"{peclet:g}", f"{error[-1]:.1e}", f"{np.log2(error[-2] / error[-1]):.2f}"])
    axes.loglog(n, 2 / n**2, "k:", label="second order")
    axes.set(xlabel="nodes per wavelength", ylabel="relative L2 error")
    axes.set_xticks(n, [f"{k:.0f}" for k in n])
    axes.minorticks_off()
    axes.legend(fontsize=8)
    save(figure, figures / "carried_wave.png")
    return section(
        "A wave carried by a uniform flow", "CarriedWave.IsOfSecondOrder",
        "A plane wave of concentration diffuses while a uniform flow carries it obliquely. It is compared with the "
        "exact solution, at rest and at Peclet number 20.",
        table(["set", "Pe", "error at 64 nodes", "order"], cells), "carried_wave.png",
        overview=("a wave of concentration, at rest and carried", "exact solution",
                  f"order {min(float(row[3]) for row in cells):.2f} to {max(float(row[3]) for row in cells):.2f}"))


def face_exchange(records, figures):
    rows = records["face_exchange"]
    if not rows:
        return None
    cells = [[f"{r['peclet']:.2g}", f"{100 * r['without']:+.2f} %", f"{100 * r['with']:+.4f} %", f"{100 * r['reaction']:+.2f} %"] for r in rows]
    return section(
        "Acid between reacting discs", "FaceExchange.KeepsWhatTheAdvectiveFormCreates, "
        "FaceExchange.LeavesWhatIsUniform",
        "Steady flow between three discs of four cells radius that react at once. The table has the share of the "
        "reaction that the advective form creates (+) or takes (-), without and with an exchange between nodes through "
        "their faces (`solute.face_exchange`), and the change of the reaction by the exchange.",
        table(["u_max h/D", "created", "with the exchange", "reaction"], cells), None,
        "Acid that is uniform and does not react stays uniform while waves of pressure cross the channel.",
        "In the paper's rock, whose pathways are three cells wide, the advective form takes up to 8.5 % of the injected "
        "acid (`acid-fracturing.md`, \"Acid that the advective form takes\").",
        overview=("acid that the advective form creates between reacting discs", "*itself*: none created",
                  f"{100 * max(abs(r['without']) for r in rows):.2f} % of the reaction; "
                  f"{100 * max(abs(r['with']) for r in rows):.4f} % with `solute.face_exchange`"))


def eq28(records, figures):
    errors, wall, profile = (records[f"solute_eq28{name}"] for name in ("", "_wall", "_profile"))
    smooth, reversible = records["solute_corner_free"], records["solute_reversible"]
    if not (errors and wall and profile and smooth and reversible):
        return None
    figure, (left, right) = plt.subplots(1, 2, figsize=(7.8, 3.0))
    for k, da in enumerate(sorted({r["Da"] for r in errors})):
        rows = [r for r in profile if r["Da"] == da and r["form"] == "default"]
        for y in sorted({r["y"] for r in rows}):
            line = [r for r in rows if r["y"] == y]
            left.plot([r["x"] for r in line], [r["exact"] for r in line], f"C{k}-", lw=1)
            left.plot([r["x"] for r in line[::8]], [r["psi"] for r in line[::8]], f"C{k}o", ms=3,
                      label=f"Da = {da:g}" if y < 0.1 else None)
        line = [r for r in wall if r["Da"] == da and r["form"] == "default"]
        right.semilogy([r["x"] for r in line], [r["exact"] for r in line], f"C{k}-", lw=1)
        right.semilogy([r["x"] for r in line[::6]], [r["flux"] for r in line[::6]], f"C{k}o", ms=3, label=f"Da = {da:g}")
        line = [r for r in wall if r["Da"] == da and r["form"] == "paper"]
        right.semilogy([r["x"] for r in line[3::6]], [r["flux"] for r in line[3::6]], f"C{k}x", ms=4,
                       label=f"Da = {da:g}, paper's form")
    left.set(xlabel="x / L", ylabel="Ψ", title="Lowest row, middle, row beside the wall")
    right.set(xlabel="x / L", ylabel="flux into the wall, D C_in / L", title="Wall flux")
    left.legend(fontsize=8)
    right.legend(fontsize=8)
    save(figure, figures / "diffusion_reaction.png")
    rows = [[r["form"], f"{r['Da']:g}", f"{r['L2']:.1e}", f"{r['wall_flux']:+.1e}", f"{r['local_wall_flux']:.1e}",
             f"{r['acid_over_solid']:+.1e}"] for r in errors]
    orders = []
    for da in sorted({r["Da"] for r in smooth}):
        e = {r["n"]: r["L2"] for r in smooth if r["Da"] == da}
        orders.append(f"{np.log2(e[25] / e[50]):.2f} and {np.log2(e[50] / e[100]):.2f} at Da = {da:g}")
    turned = table(["K_eq", "L2 of the field", "wall flux"],
                   [[f"{r['K_eq']:g}", f"{r['L2']:.1e}", f"{r['wall_flux']:+.1e}"] for r in reversible])
    default = max(r["L2"] for r in errors if r["form"] == "default")
    return section(
        "Diffusion to a reactive wall (Eq. 28)", "DiffusionReaction.*",
        "The paper's first validation, on 100 x 80 nodes, is compared with the series of its Eq. 28: the field, and "
        "the flux into the wall. A correct field alone does not show that the flux is right.",
        table(["form", "Da", "L2 of the field", "flux over the last 9/10", "largest at one node there",
               "acid taken over solid dissolved - 1"], rows), "diffusion_reaction.png",
        "- The boundary data jump in the corner where the inlet meets the wall, and this jump sets the error.\n"
        "- With an inlet profile that makes the solution smooth the order is " + ", ".join(orders) + ".\n\n"
        f"A reversible reaction is Eq. 28 at Da (1 + 1/K_eq). Errors on 50 x 40 nodes:\n\n{turned}",
        overview=("concentration and wall flux at a reactive wall", "the paper's Eq. 28",
                  f"L2 of the field {default:.1e} at most (default form), second order without the jump in the corner"))


def stefan(records, figures):
    results, front, balance = (records[f"solute_stefan{name}"] for name in ("", "_front", "_balance"))
    if not (results and front and balance):
        return None
    figure, axes = plt.subplots(figsize=(5.6, 3.8))
    fine = max(r["s0"] for r in results)
    t = np.linspace(1, 4, 200)
    axes.plot(t - 1, np.sqrt(t), "k-", lw=1, label="exact")
    for k, a in enumerate(sorted({r["a"] for r in front if r["s0"] == fine})):
        points = [r for r in front if r["a"] == a and r["s0"] == fine][k::8]
        axes.plot([r["tau"] for r in points], [r["s"] for r in points], f"C{k}o", ms=4, mfc="none", label=f"a = {a:g}")
    axes.set(xlabel="4 λ² D t / s₀²", ylabel="position of the wall / s₀")
    axes.legend(fontsize=8)
    save(figure, figures / "stefan.png")
    rows = [[f"{r['a']:g}", f"{r['s0']:g}", f"{r['measured']:.6f}", f"{r['exact']:.6f}",
             f"{100 * (r['measured'] / r['exact'] - 1):+.2f} %"] for r in sorted(results, key=lambda r: (r["a"], r["s0"]))]
    finest = [r for r in results if r["s0"] == fine]
    return section(
        "Stefan problem", "StefanProblem.ConvergesToTheExactFront, StefanProblem.HoldsOverThreeDecadesOfTheStefanNumber",
        "A wall that dissolves as fast as acid diffuses to it recedes as 2 λ √(D t), √π λ exp(λ²) erf(λ) = a, with a the "
        "rock dissolved by the acid in one volume of fluid. The run starts from the exact profile at a distance of s₀ "
        "nodes and ends at 2 s₀.",
        table(["a", "s₀", "λ measured", "λ exact", "error"], rows), "stefan.png",
        f"Acid and rock together are conserved to {max(abs(r['drift']) for r in balance):.0e} over up to "
        f"{max(r['steps'] for r in balance)} steps.",
        "The wall moves pixel by pixel and is half a pixel ahead on average. The error is therefore of first order in "
        "1/s₀.",
        ("position of a wall that dissolves as fast as acid diffuses to it", "Stefan's solution",
         f"λ within {100 * max(abs(r['measured'] / r['exact'] - 1) for r in finest):.2f} % at s₀ = {fine:g}; first "
         "order"))


def receding_wall(records, figures):
    results, front = records["solute_receding_wall"], records["solute_receding_front"]
    if not (results and front):
        return None
    figure, axes = plt.subplots(figsize=(5.4, 3.6))
    for k, number in enumerate(sorted({r["k_s_over_D"] for r in front})):
        s = np.linspace(1, 2, 100)
        t = (s - 1 + number * (s**2 - 1) / 2) / (1 + 1.5 * number)
        axes.plot(t, s, f"C{k}-", lw=1)
        points = [r for r in front if r["k_s_over_D"] == number]
        axes.plot([r["t"] for r in points], [r["s"] for r in points], f"C{k}o", ms=3, label=f"k s₀/D = {number:.3g}")
    axes.set(xlabel="time / exact time to 2 s₀", ylabel="position of the wall / s₀")
    axes.legend(fontsize=8)
    save(figure, figures / "receding_wall.png")
    rows = [[f"{r['k_s_over_D']:.3g}", f"{100 * r['error']:+.2f} %"] for r in results]
    return section(
        "A wall that recedes slowly, from reaction to diffusion", "RecedingWall.FollowsTheQuasiSteadyLawInBothLimits",
        "While a given amount of acid dissolves little rock, the concentration is in equilibrium with the wall, and "
        "s + k s²/(2D) grows in proportion to time: s grows linearly where the reaction limits, and as a square root "
        "where diffusion does. s₀ = 20 nodes.",
        table(["k s₀/D", "error of the time to 2 s₀"], rows), "receding_wall.png",
        overview=("time in which a wall recedes, from reaction to diffusion", "quasi-steady law",
                  f"within {100 * max(abs(r['error']) for r in results):.2f} %"))


def shrinking_disc(records, figures):
    results, shape = records["solute_disc"], records["solute_disc_shape"]
    if not (results and shape):
        return None
    figure, panels = plt.subplots(1, 2, figsize=(7.6, 3.7))
    for axes, form in zip(panels, ("default", "paper")):
        rows = sorted((r for r in shape if r["form"] == form), key=lambda r: r["y"])
        left = np.array([[int(c) for c in r["row"]] for r in rows]) / 9
        cx, cy, r0, r1 = (rows[0][key] for key in ("cx", "cy", "r0", "r1"))
        axes.imshow(left, origin="lower", extent=(0, left.shape[1], 0, left.shape[0]), cmap="Greys", vmin=0, vmax=1.4)
        angle = np.linspace(0, 2 * np.pi, 300)
        axes.plot(cx + r0 * np.cos(angle), cy + r0 * np.sin(angle), "C0--", lw=1, label="at the start")
        axes.plot(cx + r1 * np.cos(angle), cy + r1 * np.sin(angle), "C3-", lw=1.2, label="circle of the same area")
        result = next(r for r in results if r["form"] == form and r["R"] == 20 and r["offset"] == 0 and not r["hollow"])
        axes.set(title=f"{form} form: rate {result['rate']:.3f} of the true one", xlabel="x, nodes", ylabel="y, nodes")
        axes.legend(fontsize=7, loc="lower left")
    save(figure, figures / "shrinking_disc.png")
    cells = [[r["form"], f"{r['R']:g}", "hollow" if r["hollow"] else "disc", f"{r['offset']:g}", f"{r['rate']:.4f}",
              "-" if r["hollow"] else f"{r['r_axis']:.4f}", "-" if r["hollow"] else f"{r['r_diagonal']:.4f}"] for r in results]
    off = max(abs(r["rate"] - 1) for r in results if r["form"] == "default")
    paper = [r["rate"] for r in results if r["form"] == "paper"]
    return section(
        "A shrinking disc", "ShrinkingDisc.*",
        "In uniform acid a disc loses radius at the constant rate V_m k C. The table has the rate, and the radii along "
        "axes and diagonals over that of the circle of the same area, when half of the disc is left.",
        table(["form", "R, nodes", "shape", "offset of the centre", "rate / true", "r along axes", "r along diagonals"], cells),
        "shrinking_disc.png",
        "- The outline of pixels is a staircase. Its faces add up to 4/π of the circumference at any resolution (Tong "
        "et al., Adv. Aerodyn. 6:9, 2024). Eq. 24 counts faces: it dissolves the disc a third too fast and into a "
        "diamond.\n- The default form counts each link by the true surface that it represents.",
        overview=("rate at which a disc dissolves in uniform acid", "V_m k C",
                  f"default form within {100 * off:.1f} %"
                  + (f"; the paper's form {max(paper):.2f} times the true rate" if paper else "")))


def minerals(records, figures):
    slabs, fluxes, heat = records["mineral_slabs"], records["mineral_flux"], [
        dict(r, layers=layers) for layers in ("series", "parallel") for r in records[f"mineral_heat_{layers}"]]
    if not (slabs and fluxes and heat):
        return None

    def error(r, what):
        return f"{r[what] / r['exact'] - 1:+.1e}"

    rows = [[f"slab recedes, rate constant {r['rate']:g} m/s", f"t = {r['time']:.2g} s", error(r, "receded")] for r in slabs]
    rows += [[f"flux into the wall: {r['what']}", f"{r['value']:g}", error(r, "flux")] for r in fluxes]
    rows += [[f"heat through layers in {r['layers']}", f"D2Q{r['set']:g}", error(r, "flow")]
             for r in sorted(heat, key=lambda r: (r["layers"], r["set"]))]
    worst = max(abs(r["flux"] / r["exact"] - 1) for r in fluxes)
    receded = max(abs(r["receded"] / r["exact"] - 1) for r in slabs)
    return section(
        "Minerals", "Minerals.*, TwoAcids.*, MineralHeat.*",
        "Two minerals, each with its own parameters, lie at the ends of channels between inert walls. They are "
        "compared with diffusion and reaction in series:\n\n"
        "- flux at a first-order rate: D C / (d + D/k);\n"
        "- flux of order n: with the concentration at the wall by bisection;\n"
        "- flux to an equilibrium: with the resistance of the product as well;\n"
        "- receding slabs: (d s + s²/2)/D + s/k = V C t, where pixels vanish one by one.\n\n"
        "Heat through layers of two minerals is compared with their conductivities in series and side by side.",
        table(["what", "", "error"], rows), None,
        "The walls between the channels do not change by a single bit.",
        overview=("two minerals: flux into the wall, receding slabs", "diffusion and reaction in series",
                  f"flux within {worst:.0e}; slabs within {100 * receded:.2f} %"))


entries = [carried_wave, face_exchange, eq28, stefan, receding_wall, shrinking_disc, minerals]
