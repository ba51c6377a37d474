"""Rock between platens and under a cold face: each entry takes (records, folder of figures) and returns its section, or
None where its test was not run."""
import math

import numpy as np
from matplotlib import pyplot as plt

from .records import section, table
from .rock_drawing import BLUE, GPA, GREEN, GREY, MPA, ORANGE, RED, column, cracks, groups, save


def confined(records, figures):
    elastic, broken, curves = records["confined_elastic"], records["triaxial"], records["triaxial_curves"]
    if not elastic:
        return None
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.4))
    strain = column(elastic, "strain")
    free, pressure = column(elastic, "free"), elastic[0]["confinement"]
    left.plot(1e3 * strain, (free + elastic[0]["poisson"] * pressure) / MPA, color=GREY, label="E ε₁ + ν σ₃")
    left.plot(1e3 * strain, column(elastic, "stress") / MPA, "o", ms=3, color=RED, label="σ₁ at σ₃ = 10 MPa, membrane")
    servo = records["servo_elastic"]
    if servo:
        left.plot(1e3 * column(servo, "strain")[5::10], column(servo, "stress")[5::10] / MPA, "s", ms=3, color=GREEN, label="the same, servo platens")
    left.plot(1e3 * strain, free / MPA, ".", ms=3, color=BLUE, label="σ₁ at σ₃ = 0")
    left.set_xlabel("axial strain / 10⁻³")
    left.set_ylabel("axial stress / MPa")
    left.legend(fontsize=8)
    rows, strengths = None, ""
    if broken:
        strengths = (f"; strength {broken[0]['strength'] / MPA:.1f} to {broken[-1]['strength'] / MPA:.1f} MPa at "
                     f"{broken[0]['confinement'] / MPA:g} to {broken[-1]['confinement'] / MPA:g} MPa")
        for (pressure, points), colour in zip(groups(curves, "parameter").items(), (GREY, BLUE, ORANGE, RED)):
            right.plot(100 * column(points, "strain"), column(points, "stress") / MPA, color=colour, lw=1.2,
                       label=f"σ₃ = {pressure / MPA:g} MPa")
        right.set_xlabel("axial strain / %")
        right.set_ylabel("axial stress / MPa")
        right.legend(fontsize=8)
        rows = table(["confinement", "strength", "failed in tension", "in shear"],
                     [(f"{r['confinement'] / MPA:g} MPa", f"{r['strength'] / MPA:.1f} MPa", int(r["tension"]), int(r["shear"]))
                      for r in broken])
    else:
        right.set_axis_off()
    save(figure, figures / "rock_confined.png")
    return section(
        "Compression under confinement", "ConfinedCompression, PaperCompressionLong.ConfinementStrengthensTheRock",
        "A pressure on the flanks is raised while the platens stand still; then the platens move. The elastic branch "
        "must be σ₁ = E ε₁ + ν σ₃ (Hooke, plane stress) with E and ν of the unconfined test, whether the pressure is "
        "the dead load of a membrane or that of servo platens (left in the figure). The table and the right of the "
        "figure are under a membrane.",
        rows, "rock_confined.png",
        overview=("elastic branch under confinement", "Hooke, σ₁ = E ε₁ + ν σ₃", "follows it (figure)" + strengths))


def servo(records, figures):
    hold, rows, curves = records["servo_hold"], records["servo_strength"], records["servo_curves"]
    if not hold or not rows or not curves:
        return None
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.4))
    for (pressure, points), colour in zip(groups(curves, "parameter").items(), (BLUE, ORANGE, RED)):
        left.plot(100 * column(points, "strain"), column(points, "confinement") / MPA, color=colour, lw=1.1)
        left.axhline(pressure / MPA, color=GREY, ls="--", lw=0.7)
    left.set_xlabel("axial strain / %")
    left.set_ylabel("pressure of the flank platens / MPa")
    for (pressure, points), colour in zip(groups(rows, "confinement").items(), (BLUE, ORANGE, RED)):
        right.plot(column(points, "membrane") / MPA, column(points, "servo") / MPA, "o", color=colour, label=f"σ₃ = {pressure / MPA:g} MPa")
    line = np.array([95, 155])
    right.plot(line, line, color=GREY, lw=0.8)
    right.set_xlabel("strength under a membrane / MPa")
    right.set_ylabel("strength between servo platens / MPa")
    right.legend(fontsize=8)
    save(figure, figures / "rock_servo.png")
    h = hold[-1]
    ratio = column(rows, "servo") / column(rows, "membrane") - 1
    more = f"{100 * ratio.mean():.1f} ± {100 * ratio.std(ddof=1):.1f} %"
    return section(
        "Servo platens", "ServoConfinement, ServoConfinementLong",
        "Rigid frictionless flank platens move at v = G (p - p_wanted), the servo of granular mechanics. Rock that "
        "widens at v by its Poisson effect presses v/G too hard. A small block is compressed at 0.25 m/s, and whole "
        "specimens (10 cm × 5 cm) at 0.5 m/s.",
        table(["confinement", "membrane", "servo", "held within, elastic", "through failure"],
              [(f"{p / MPA:g} MPa", f"{column(r, 'membrane').mean() / MPA:.1f} MPa", f"{column(r, 'servo').mean() / MPA:.1f} MPa",
                f"{max(column(r, 'elastic_error')) / MPA:.2f} MPa", f"{max(column(r, 'failure_error')) / MPA:.1f} MPa")
               for p, r in groups(rows, "confinement").items()]), "rock_servo.png",
        f"- Small block: the pressure is too high by {h['offset'] / 1e3:.0f} kPa, with {h['expected'] / 1e3:.0f} kPa "
        f"expected (at most {100 * h['worst']:.1f} % of 10 MPa).\n"
        f"- Whole tests: the pressure is held within {max(column(rows, 'elastic_error')) / MPA:.2f} MPa while the rock "
        "is elastic. Rock that bursts out when it breaks pushes the platens with up to "
        f"{max(column(rows, 'failure_error')) / MPA:.0f} MPa.\n"
        f"- Strengths are {more} higher than under a membrane, because rigid platens, from which the rock cannot part, "
        f"hold flakes back. This is within the scatter of specimens ({scatter(records)}).",
        overview=("strength between servo platens", "*itself*: strength under a membrane", f"{more} higher"))


def compression(records, figures):
    specimens, curves = records["compression_specimens"], records["compression_profiles"]
    if not specimens or not curves:
        return None
    profiles = ("paper-literal", "calibrated", "weibull-scale")
    names = [name for name in profiles if records[f"compression_cracks_{name}"]]
    figure, axes = plt.subplots(1, 1 + len(names), figsize=(4 + 2 * len(names), 3.8),
                                gridspec_kw={"width_ratios": [2.2] + len(names) * [1]})
    for (number, points), colour in zip(sorted(groups(curves, "parameter").items()), (BLUE, RED, GREEN)):
        name = profiles[int(number)]
        axes[0].plot(100 * column(points, "strain"), column(points, "stress") / MPA, color=colour, label=name)
    axes[0].plot([0.328], [91.1], "k*", ms=10, label="printed: 91.1 MPa, on a line of 27.8 GPa")
    axes[0].set_xlabel("axial strain / %")
    axes[0].set_ylabel("axial stress / MPa")
    axes[0].legend(fontsize=7)
    for panel, profile in zip(axes[1:], names):
        cracks(panel, records[f"compression_cracks_{profile}"])
        panel.set_xlim(-0.3, 5.3)
        panel.set_ylim(-0.3, 10.3)
        panel.set_title(profile, fontsize=9)
    axes[1].set_ylabel("y / cm")
    axes[1].legend(fontsize=7, loc="upper right")
    save(figure, figures / "rock_compression.png")
    rows = []
    for profile, of_profile in groups(specimens, "profile").items():
        for element, five in groups(of_profile, "element").items():
            strength, modulus = column(five, "strength") / MPA, column(five, "modulus") / GPA
            rows.append((profile, f"{1e3 * element:g} mm", f"{modulus.mean():.2f} ± {modulus.std(ddof=1):.2f} GPa",
                         f"{column(five, 'poisson').mean():.3f}", f"{strength.mean():.1f} ± {strength.std(ddof=1):.1f} MPa",
                         f"{strength.min():.1f} ... {strength.max():.1f}", f"{100 * column(five, 'peak_strain').mean():.3f} %"))
    calibrated = groups([r for r in specimens if r["profile"] == "calibrated"], "element").values()
    return section(
        "Uniaxial compression of the paper's sandstone", "PaperCompressionLong",
        "Specimens of 10 cm × 5 cm are compressed between frictionless platens at 0.5 m/s, as in section 3.5.2 of the "
        "paper: 27.8 GPa, 91.1 MPa (the star, drawn where a straight line of 27.8 GPa reaches it: the paper prints no "
        "strain). Each row is of five specimens with different elements and bond strengths. The path ratio "
        "is the default of 1.2, as in all tests of such specimens and of the disc unless "
        "stated otherwise. In the figure blue bonds failed in tension, red ones in shear (seed 1, elements of 2 mm).",
        table(["profile", "elements", "modulus", "Poisson", "strength (± of a specimen)", "range / MPa", "strain at peak"], rows),
        "rock_compression.png",
        "- `paper-literal`: Table 1 as printed, but for the fracture energies (over the path ratio), gives the printed "
        "modulus but not the printed strength.\n"
        "- `calibrated` differs in the cohesion alone, 58 MPa (`vug lab --fit-cohesion`). It gives the printed "
        "strength within 3 % for both sizes of elements.\n"
        "- `weibull-scale` reads the printed strengths and energies as scale parameters of their Weibull distributions "
        "(means 6.5 % lower), leaves f₁ and f₂ unnormalised and takes the internal friction out of the bonds' "
        "strength. With nothing fitted to them it comes within 4 % of modulus and strength.",
        overview=("modulus and strength of the paper's sandstone", "the paper, section 3.5.2",
                  "calibrated cohesion: "
                  + " and ".join(f"{column(five, 'strength').mean() / MPA:.1f}" for five in calibrated)
                  + " MPa of 91.1 MPa; Table 1 as printed: modulus only"))


def scatter(records):
    """How much the strength of single specimens scatters: elements of 3 mm, calibrated cohesion, no confinement."""
    strength = column([r for r in records["compression_specimens"]
                       if r["profile"] == "calibrated" and abs(r["element"] - 3e-3) < 1e-9], "strength")
    return f"{100 * strength.std(ddof=1) / strength.mean():.0f} %" if len(strength) > 1 else "not measured"


def platen_speed(records, figures):
    rows = records["platen_speed"]
    if not rows:
        return None
    usual = [r["strength"] for r in rows if abs(r["speed"] - 0.5) < 1e-9]
    return section(
        "Speed of the platens", "PaperCompressionLong.StrengthHardlyDependsOnThePlatensSpeed",
        "The same specimen (elements of 3 mm, calibrated) is strained at four speeds.",
        table(["platen speed", "modulus", "strength"],
              [(f"{r['speed']:g} m/s", f"{r['modulus'] / GPA:.2f} GPa", f"{r['strength'] / MPA:.2f} MPa")
               for r in rows]), None,
        "The modulus does not depend on the speed. The strength rises with the speed, at 0.5 m/s by less than "
        f"specimens scatter ({scatter(records)}). The tests use that speed.",
        overview=("strength at the platens' usual speed", f"*itself*: strength at {rows[0]['speed']:g} m/s",
                  " ".join(f"{100 * (strength / rows[0]['strength'] - 1):+.1f} % at 0.5 m/s" for strength in usual)))


def soaking(records, figures):
    rows = records["soaking"]
    if not rows or "profile" not in rows[0]:
        return None
    profiles = groups(rows, "profile")
    figure, panels = plt.subplots(1, 3, figsize=(11, 3.5))
    colours = plt.get_cmap("viridis")(np.linspace(0, 0.9, 8))
    for axes, profile in zip(panels, profiles):
        for (d_c, points), colour in zip(groups(records[f"soaking_curves_{profile}"], "parameter").items(), colours):
            axes.plot(100 * column(points, "strain"), column(points, "stress") / MPA, color=colour, lw=1, label=f"{d_c:g}")
        axes.set_xlabel("axial strain / %")
        axes.set_ylabel("axial stress / MPa")
        axes.set_title(profile, fontsize=9)
        axes.legend(fontsize=6, title="d_c", title_fontsize=7, loc="upper left")
    d = np.linspace(0, 0.36, 100)
    right = panels[2]
    right.plot(d, 1 - d, color=BLUE, label="1 - d_c (Eq. 12)")
    right.plot(d, (-0.83 * d**2 + 0.017 * d + 0.98) / 0.98, color=RED, label="f₁ (Eq. 29)")
    for (profile, points), hollow in zip(profiles.items(), ("none", None)):
        damage, fresh = column(points, "d_c"), points[0]
        right.plot(damage, column(points, "modulus") / fresh["modulus"], "o", color=BLUE, mfc=hollow, label=f"modulus, {profile}")
        right.plot(damage, column(points, "strength") / fresh["strength"], "s", color=RED, mfc=hollow, label=f"strength, {profile}")
    right.set_xlabel("chemical damage d_c")
    right.set_ylabel("over that of fresh rock")
    right.set_ylim(0.5, 1.05)
    right.legend(fontsize=6, loc="lower left")
    save(figure, figures / "rock_soaking.png")
    shares = [r["modulus"] / points[0]["modulus"] / (1 - r["d_c"]) for points in profiles.values() for r in points]
    printed = {round(r["d_c"], 2): 1 - r["strength"] / profiles["paper-literal"][0]["strength"]
               for r in profiles["paper-literal"]}
    return section(
        "Soaked in acid", "PaperCompressionLong.SoakingLowersTheModulusByTheDissolvedShare",
        "One specimen (elements of 2 mm) with uniform chemical damage d_c, as in the paper's Fig. 7b, with Table 1 as "
        "printed (but for the fracture energies) and with the calibrated cohesion. The strength of the bonds falls as "
        "f₁ and their fracture energy as f₂.",
        table(["profile", "d_c", "modulus", "over 1 - d_c", "strength", "strain at peak"],
              [(profile, f"{r['d_c']:g}", f"{r['modulus'] / GPA:.2f} GPa", f"{r['modulus'] / points[0]['modulus'] / (1 - r['d_c']):.4f}",
                f"{r['strength'] / MPA:.1f} MPa", f"{100 * r['strain']:.3f} %") for profile, points in profiles.items() for r in points]),
        "rock_soaking.png",
        "- The modulus falls as 1 - d_c, as it must where Eq. 12 multiplies the stiffness of every bond by that. The "
        "paper estimates d_c of its experiments from the modulus.\n"
        "- The strength of the one specimen lies below f₁ and falls in steps, where another cascade of cracks begins. "
        "With Table 1 as printed it falls by more than a quarter at 0.1 and from 0.2 on "
        f"({100 * max(printed.values()):.0f} % at most), but only by {100 * printed[0.15]:.0f} % at 0.15.",
        "- It is one specimen: one cascade decides, and with the scatter of specimens above the steps say little.\n"
        "- No measured strengths of soaked rock are used. The paper has them in a figure only (its Fig. 7b).",
        overview=("modulus of soaked rock", "*itself*: 1 - d_c, which Eq. 12 gives all bonds",
                  f"within {100 * max(abs(share - 1) for share in shares):.2f} %"))


def brazilian(records, figures):
    centre, strength, curve = records["brazilian_centre"], records["brazilian_strength"], records["brazilian_curve"]
    lines, tensile = records["brazilian_cracks"], records["tensile_strengths"]
    if not centre or not strength or not curve:
        return None
    figure, (left, right) = plt.subplots(1, 2, figsize=(8, 3.8))
    left.plot(100 * column(curve, "strain"), column(curve, "stress") / MPA, color=BLUE)
    left.axvline(100 * strength[-1]["first_strain"], color=GREY, ls="--", lw=1)
    left.annotate("ten bonds failed", (100 * strength[-1]["first_strain"], 1), rotation=90, fontsize=8, ha="right")
    left.set_xlabel("approach of the platens over their distance / %")
    left.set_ylabel("splitting stress / MPa")
    cracks(right, lines)
    half = math.asin(0.174)
    for start in (-math.pi / 2 + half, math.pi / 2 + half):
        t = np.linspace(start, start + math.pi - 2 * half, 100)
        right.plot(2.5 + 2.5 * np.cos(t), 2.5 * math.cos(half) + 2.5 * np.sin(t), color=GREY, lw=0.8)
    for y in (0, 5 * math.cos(half)):
        right.plot([2.5 - 2.5 * 0.174, 2.5 + 2.5 * 0.174], [y, y], color="black", lw=2.5)
    right.set_ylabel("y / cm")
    right.legend(fontsize=8, loc="upper right")
    save(figure, figures / "rock_brazilian.png")
    s = strength[-1]
    rows = []
    for c in centre:
        degrees = f"flats of {2 * math.degrees(math.asin(c['flats'])):.0f}°"
        rows += [(f"across the load, centre, {degrees}", "2P/(πD) (sin 2a - a)/sin a", f"{c['across']:.3f} of it"),
                 (f"along the load, centre, {degrees}", "-2P/(πD) (sin 2a + a)/sin a", f"{c['along'] / c['along_exact']:.3f} of it")]
    rows += [("first ten failures off the loaded diameter (at random 0.42)", "", f"{s['first_off_axis']:.2f} of the radius"),
             ("strength, Table 1", "", f"{s['strength'] / MPA:.1f} MPa")]
    for r in tensile:
        rows.append((f"five specimens, c = {r['cohesion'] / MPA:g} MPa, path ratio {r['path_ratio']:g}", "",
                     f"splitting {r['brazilian'] / MPA:.2f} ± {r['brazilian_deviation'] / MPA:.2f} MPa, "
                     f"direct tension {r['direct'] / MPA:.2f} ± {r['direct_deviation'] / MPA:.2f} MPa"))
    off = [c["across"] for c in centre if 2 * math.degrees(math.asin(c["flats"])) < 15]
    return section(
        "Brazilian disc", "BrazilianDisc, BrazilianDiscLong",
        "A disc of 5 cm is pressed between flats of 20 degrees of arc, which keep it from crushing at the platens. The "
        "strength is the tension at the centre of an elastic disc under an even pressure on two arcs of 2a (Hondros "
        "1959). At 20 degrees it is 0.964 of the point load's 2P/(πD).",
        table(["quantity", "closed form", "measured"], rows), "rock_brazilian.png",
        "Between flats of 10 degrees the disc has this tension. It breaks first along the loaded diameter and splits.",
        "Rigid platens press more at the ends of wider flats. This takes 5 % more off the tension at 20 degrees and 8 "
        "% at 35.",
        overview=("tension at the centre of a disc", "Hondros 1959",
                  "".join(f"{across:.3f} of it between flats of 10°" for across in off[:1])))


def toughness(records, figures):
    straight, generated = records["toughness_straight"], records["toughness"]
    if not straight:
        return None
    rows = [(f"{1e3 * r['edge']:g} mm", "straight", 1, f"{r['ratio']:.3f}") for r in straight]
    rows += [(f"{1e3 * r['edge']:g} mm", "generated", f"{r['path_ratio']:g}",
              f"{r['mean']:.3f} ± {r['deviation']:.3f} ({r['least']:.3f} ... {r['largest']:.3f})") for r in generated]
    return section(
        "Toughness", "Toughness, ToughnessLong",
        "A plate with a crack in its middle is pulled until it breaks, without scatter among the bonds. Its load is "
        "compared with that of Griffith in a plate of finite width (Feddersen 1966), with the crack longer by 0.42 E "
        "G_I/σ² for its softening zone (Planas and Elices 1992). The size in the table is that of the edges at the "
        "tips of the crack.",
        table(["edge", "path", "path ratio", "strength over that of fracture mechanics (± of a seed)"], rows), None,
        "- Straight path (rows of equilateral triangles): the load converges to that of fracture mechanics.\n"
        "- Generated triangles (five seeds) have crooked paths. At a path ratio of 1 the given energy is that of the "
        "bonds; at 1.2, the same for every seed, it is that of the rock.",
        overview=("strength of a plate with a crack", "Griffith, Feddersen 1966",
                  "; ".join(f"{r['mean']:.3f} ± {r['deviation']:.3f} of it (path ratio {r['path_ratio']:g})"
                            for r in generated if abs(r["path_ratio"] - 1.2) < 1e-9)
                  or f"{straight[-1]['ratio']:.3f} of it (straight path)"))


def quench(records, figures):
    rows, lines = records["quench"], records["quench_cracks"]
    if not rows or not lines:
        return None
    figure = plt.figure(figsize=(9, 4.2))
    grid = figure.add_gridspec(2, 3, height_ratios=[1, 1.8])
    drops = sorted({r["drop"] for r in rows})
    for place, drop in zip(((0, 0), (0, 1), (0, 2)), (drops[0], drops[len(drops) // 2], drops[-1])):
        axes = figure.add_subplot(grid[place])
        cracks(axes, [r for r in lines if r["drop"] == drop])
        axes.set_xlim(0, 6)
        axes.set_ylim(0, 1.5)
        axes.set_title(f"ΔT = {drop:g} K", fontsize=9)
    axes = figure.add_subplot(grid[1, :])
    axes.plot(column(rows, "drop"), 1e3 * column(rows, "spacing"), "o-", color=BLUE, label="spacing")
    axes.plot(column(rows, "drop"), 1e3 * column(rows, "mean_depth"), "s-", color=RED, label="mean depth")
    axes.set_xlabel("fall of the surface temperature / K")
    axes.set_ylabel("mm")
    axes.set_ylim(0)
    axes.legend(fontsize=8)
    save(figure, figures / "rock_quench.png")
    return section(
        "Cracks of a quenched slab", "QuenchLong.CracksStandCloserTheHarderTheShockAndEndInTheCompressedCore",
        "The upper half of a slab with a face that is suddenly cold is computed until it is cold throughout. Its "
        "trends are compared with the water quench of ceramics (Jiang et al. 2012, Acta Materialia 60, 4540; Bourdin et "
        "al. 2014, Phys. Rev. Lett. 112, 014301). Unlike the rock that is compressed above, this one has a path ratio of 1: its "
        "bonds take the energies of Table 1.",
        table(["ΔT", "spacing two elements deep", "mean depth", "deepest"],
              [(f"{r['drop']:g} K", f"{1e3 * r['spacing']:.1f} mm", f"{1e3 * r['mean_depth']:.1f} mm", f"{1e3 * r['deepest']:.1f} mm")
               for r in rows]), "rock_quench.png",
        "As in the experiments the cracks stand closer the larger the temperature drop, and their mean depth hardly "
        "changes well above the critical drop (here 50 to 70 K).",
        "- Only trends are compared: alumina itself has not been computed, and whether every other crack stops with "
        "depth (period doubling) has not been looked at.\n"
        "- The decrease in depth just above the critical drop, seen in the brittler alumina, is not seen here: the "
        "softening zone, E G_I/σ² = 2.5 mm, is a sixth of the half thickness.",
        ("cracks of a quenched slab", "*trend* of Jiang et al. 2012, Bourdin et al. 2014",
         f"spacing falls from {1e3 * rows[0]['spacing']:.1f} to {1e3 * rows[-1]['spacing']:.1f} mm from "
         f"ΔT = {rows[0]['drop']:g} to {rows[-1]['drop']:g} K"))


entries = [confined, servo, compression, platen_speed, soaking, brazilian, toughness, quench]
