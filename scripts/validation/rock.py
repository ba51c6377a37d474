"""Laws, motion and energy of bonded rock: each entry takes (records, folder of figures) and returns its section, or None
where its test was not run."""
import math

import numpy as np
from matplotlib import pyplot as plt

from . import rock_tests
from .records import section, table
from .rock_drawing import BLUE, GREEN, GREY, MPA, ORANGE, RED, column, groups, save


def bond_law(records, figures):
    curves, ellipse, energies = records["bond_curve"], records["bond_ellipse"], records["bond_energy"]
    if not curves or not ellipse:
        return None
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6))
    opening = np.linspace(0, 2.9e-6, 400)
    length = 0.659 * 2e-3 / math.sqrt(3)
    stiffness = 24.03e9 / length
    onset, end = 15e6 / stiffness, 2 * 20 / 15e6
    law = np.where(opening < onset, stiffness * opening, np.maximum(0, 15e6 * (end - opening) / (end - onset)))
    left.plot(1e6 * opening, law / MPA, color=GREY, label="mode I, closed form")
    for (angle, rows), colour in zip(groups(curves, "angle").items(), plt.get_cmap("viridis")(np.linspace(0, 0.9, 6))):
        stress = np.hypot(column(rows, "normal"), column(rows, "tangential"))
        left.plot(1e6 * column(rows, "opening"), stress / MPA, ".", ms=3, color=colour, label=f"{angle:g}°")
    left.set_xlabel("opening / µm")
    left.set_ylabel("stress / MPa")
    left.legend(fontsize=7, title="from the normal", title_fontsize=7)
    t = np.linspace(0, math.pi / 2, 200)
    right.plot(15 * np.cos(t), 95 * np.sin(t), color=GREY, label="Eq. 11")
    right.plot(column(ellipse, "normal") / MPA, column(ellipse, "tangential") / MPA, "o", color=RED, label="measured peaks")
    right.set_xlabel("normal stress / MPa")
    right.set_ylabel("shear stress / MPa")
    right.legend(fontsize=8)
    save(figure, figures / "rock_bond_law.png")
    rows = [(f"{r['angle']:g}°", f"{abs(r['energy'] - 1):.1e}", f"{abs(r['ellipse'] - 1):.1e}") for r in energies]
    return section(
        "One bond: traction, separation and energy", "OneBond, Degrees/MixedModeBond",
        "The faces of one bond are moved apart on straight paths. The stress must rise to the strength ellipse (paper, "
        "Eq. 11) and then fall linearly. The area under the curve must be the fracture energy, W_I/G_I + W_II/G_II = "
        "1.",
        table(["opening from the normal", "error of the energy", "error of the ellipse (one sample)"], rows),
        "rock_bond_law.png",
        limits="In pure sliding a bond of this length (0.76 mm) snaps: it stores more than G_II before it yields.",
        overview=("energy and strength of one bond", "fracture energies; the paper's Eq. 11",
                  f"energy within {max(abs(r['energy'] - 1) for r in energies):.1e}, "
                  f"strength within {max(abs(r['ellipse'] - 1) for r in energies):.1e}"))


def bar_pulse(records, figures):
    rows, speed = records["bar_pulse"], records["bar_speed"]
    if not rows or not speed:
        return None
    figure, axes = plt.subplots(figsize=(6.4, 3.2))
    exact = speed[-1]["exact"]
    for (place, points), colour in zip(groups(rows, "place").items(), (BLUE, RED)):
        axes.plot(1e6 * column(points, "time"), 100 * column(points, "velocity"), color=colour,
                  label=f"gauge at {100 * place:g} cm")
        axes.axvline(1e6 * place / exact, color=colour, ls="--", lw=1)
    axes.axhline(1, color=GREY, lw=0.7)
    axes.set_xlabel("time / µs")
    axes.set_ylabel("velocity / cm/s")
    axes.legend(fontsize=8, title="dashed: place / sqrt(E/ρ)", title_fontsize=8)
    save(figure, figures / "rock_pulse.png")
    apart = f"{100 * abs(speed[-1]['speed'] / exact - 1):.1f} %"
    return section(
        "Pulse in a bar", "ElasticBar.CarriesAPulseAtTheSpeedOfItsModulus",
        "A free bar of bonded triangles is struck at one end, and the front of the pulse is timed from gauge to gauge.",
        None, "rock_pulse.png",
        f"The front travels at {speed[-1]['speed']:.0f} m/s. The bar velocity sqrt(E/ρ) of this mesh's modulus is "
        f"{exact:.0f} m/s ({apart} apart).",
        overview=("speed of a pulse in a bar", "sqrt(E/ρ)", f"{apart} apart"))


def energy(records, figures):
    rows, whole, hit, crushed = (records[f"energy_{n}"] for n in ("ledger", "compression", "collision", "crushed"))
    if not rows or not hit or not crushed:
        return None
    figure, axes = plt.subplots(figsize=(7.4, 3.4))
    tests = (("oblique collision", hit, GREEN), ("small block, broken fast", rows, BLUE),
             ("three small specimens, crushed", crushed, ORANGE), ("whole compression test", whole, RED))
    for name, points, colour in tests:
        if points:
            axes.loglog(column(points, "fraction"), column(points, "imbalance"), "o", color=colour, label=name)
    for number, start in enumerate((hit[0], rows[0])):
        x = start["fraction"] * np.array([0.12, 1.4])
        axes.loglog(x, start["imbalance"] * (x / start["fraction"]) ** 2, "--", color=GREY, lw=1,
                    label="second order" if number == 0 else None)
    axes.set_xlabel("time step / critical step")
    axes.set_ylabel("|missing energy| / work")
    axes.legend(fontsize=8, loc="center left", bbox_to_anchor=(1.01, 0.5), frameon=False)
    save(figure, figures / "rock_energy.png")
    return section(
        "Energy ledger through breaking", "EnergyLedger, EnergyLedgerLong",
        "External work must equal kinetic + elastic + fracture + friction + damping energy. Each of these is summed by "
        "a formula of its own, elastic energy and losses in the form that the leapfrog conserves "
        "(`src/dem/accounts.hpp`). The missing energy is measured in three kinds of test:\n\n"
        "- an oblique collision with dashpots and friction: root mean square over sixteen places of the impact within "
        "a step, over the initial energy; here few steps resolve the contact's own period;\n"
        "- a block that is broken fast;\n"
        "- compression tests until the specimen is crushed: cracks that open, close and rub, rubble that rolls from "
        "corners to edges.",
        table(["test", "step / critical step", "missing / work"],
              [(name, f"{r['fraction']:g}", f"{r['imbalance']:.1e}") for name, points, _ in tests for r in points]),
        "rock_energy.png",
        "In all of them the missing energy falls with the square of the step.",
        overview=("energy of rock that collides and breaks", "external work",
                  "second order in the time step; missing in crushed specimens "
                  f"{max(r['imbalance'] for r in crushed):.1e} of the work at most"))


def thermal(records, figures):
    heated, slope, clamped = records["restrained_heating"], records["restrained_heating_slope"], records["clamped_heating"]
    layers, asleep = records["quench_stress"], records["resting_rock"]
    if not heated or not slope or not clamped or not layers or not asleep:
        return None
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.4))
    strain = column(heated, "strain")
    left.plot(strain / 8e-6, slope[-1]["pressed"] * strain / MPA, color=GREY, label="E α ΔT, E from compression")
    left.plot(strain / 8e-6, column(heated, "stress") / MPA, ".", ms=4, color=RED, label="measured")
    left.set_xlabel("ΔT / K")
    left.set_ylabel("stress between the platens / MPa")
    left.legend(fontsize=8)
    depth = column(layers, "depth")
    right.plot(1e3 * depth, column(layers, "exact") / MPA, color=GREY, label="-E α (ΔT - mean)")
    right.plot(1e3 * depth, column(layers, "stress") / MPA, "o", color=RED, label="measured, layers of 2 mm")
    right.set_xlabel("depth z / mm")
    right.set_ylabel("lateral stress / MPa")
    right.legend(fontsize=8)
    save(figure, figures / "rock_thermal.png")
    c, s, r = clamped[-1], slope[-1], asleep[-1]
    worst = np.max(np.abs(column(layers, "stress") - column(layers, "exact"))) / (27.8e9 * 8e-6 * 100)
    return section(
        "Thermal stress", "RestrainedHeating, ThermalExpansion, Quench",
        "- A block between fixed platens is heated: the stress must be E α ΔT.\n"
        "- A block clamped on all sides must have the stress M_n/χ α ΔT of its bonds.\n"
        "- Under a face that is suddenly cold the lateral stress must follow the temperature of Carslaw and Jaeger, "
        "less its mean.",
        table(["test", "closed form", "error"],
              [("heated between platens", "E α ΔT", f"{100 * abs(s['heated'] / s['pressed'] - 1):.2f} %"),
               ("clamped on all sides", "M_n α ΔT / χ", f"{100 * abs(c['left'] / c['exact'] - 1):.2f} %"),
               ("the same, asleep before and after", "M_n α ΔT / χ", f"{100 * abs(r['left'] / r['exact'] - 1):.2f} %"),
               ("cold face, before it cracks", "-E α (ΔT - mean)", f"{100 * worst:.1f} % of E α ΔT")]),
        "rock_thermal.png",
        overview=("stress of rock that is heated, and under a cold face", "closed forms",
                  f"within {100 * max(abs(c['left'] / c['exact'] - 1), abs(s['heated'] / s['pressed'] - 1)):.2f} %; "
                  f"cold face {100 * worst:.1f} % of E α ΔT"))


def accuracy(records, figures):
    scaled, stepped, pulses, preloads = (records[n] for n in ("mass_scaling", "sub_step", "sub_step_pulse", "preload"))
    if not scaled or not stepped or not pulses or not preloads:
        return None
    figure, (left, middle, right) = plt.subplots(1, 3, figsize=(10.5, 3.3))

    def against(rows, base):
        """(value, mean and deviation over the seeds of strength over that at `base`, rows) for every value."""
        reference = {r["seed"]: r for r in rows if r["value"] == base}
        for value, of_value in groups(rows, "value").items():
            more = np.array([r["strength"] / reference[r["seed"]]["strength"] - 1 for r in of_value])
            yield value, more.mean(), more.std(ddof=1), of_value

    of_mass, of_step = list(against(scaled, 1)), list(against(stepped, 0.05))
    left.errorbar([m[0] for m in of_mass], [100 * m[1] for m in of_mass], [100 * m[2] for m in of_mass], fmt="o-", color=BLUE, capsize=3, label="strength")
    left.plot([m[0] for m in of_mass], [100 * (column(m[3], "modulus").mean() / column(of_mass[0][3], "modulus").mean() - 1) for m in of_mass], "s-", color=GREEN, label="modulus")
    left.set_xscale("log")
    left.set_xlabel("mass scaling")
    left.set_ylabel("error / %")
    left.legend(fontsize=8)
    middle.errorbar([m[0] for m in of_step], [100 * m[1] for m in of_step], [100 * m[2] for m in of_step], fmt="o-", color=BLUE, capsize=3, label="strength, three seeds")
    middle.set_xlabel("sub-step / critical step")
    middle.set_ylabel("strength, against 0.05 / %")
    twin = middle.twinx()
    twin.loglog(column(pulses, "fraction"), column(pulses, "error"), "s-", color=RED)
    twin.set_xscale("linear")
    twin.set_ylabel("error of a pulse's speed", color=RED)
    same = [r for r in preloads if abs(r["damping"] - 0.7) < 1e-9]
    right.loglog(1e6 * column(same, "ramp"), column(same, "error"), "o-", color=BLUE, label="displacement")
    right.loglog(1e6 * column(same, "ramp"), np.sqrt(column(same, "kinetic")), "s--", color=ORANGE, label="(E_kin / E_el)$^{1/2}$")
    right.set_xlabel("preload_time / µs")
    right.set_ylabel("error of the static state")
    right.legend(fontsize=8)
    save(figure, figures / "rock_accuracy.png")
    first, base = of_mass[0][3], of_step[0][3]
    rows = [(f"mass scaling {v:g}", f"{100 * (column(r, 'modulus').mean() / column(first, 'modulus').mean() - 1):+.2f} %", f"{100 * m:+.1f} ± {100 * d:.1f} %",
             f"{column(r, 'tension').mean() + column(r, 'shear').mean():.0f}", f"{100 * column(r, 'kinetic').mean():.1f} %", f"{column(r, 'steps').mean():.0f}",
             f"{column(r, 'wall').sum() / column(first, 'wall').sum():.2f}") for v, m, d, r in of_mass]
    rows += [(f"sub-step {v:g} of the critical", f"{100 * (column(r, 'modulus').mean() / column(base, 'modulus').mean() - 1):+.2f} %", f"{100 * m:+.1f} ± {100 * d:.1f} %",
              f"{column(r, 'tension').mean() + column(r, 'shear').mean():.0f}", f"{100 * column(r, 'kinetic').mean():.1f} %", f"{column(r, 'steps').mean():.0f}",
              f"{column(r, 'wall').sum() / column(first, 'wall').sum():.2f}") for v, m, d, r in of_step]
    rest = table(["preload_time", "preload_damping", "sub-steps", "E_kin / E_el", "error of the displacement"],
                 [(f"{1e6 * r['ramp']:.0f} µs", f"{r['damping']:g}", f"{r['steps']:.0f}", f"{r['kinetic']:.1e}", f"{r['error']:.1e}") for r in preloads])
    return section(
        "What cheaper mechanics costs", "MassScalingLong, SubStep, SubStepLong, PreloadAccuracyLong",
        "**Mass scaling and sub-step.** Three specimens (10 cm × 5 cm, elements of 3 mm, calibrated) are compressed at "
        "0.5 m/s, and each is compared with itself. The kinetic share is that of the elastic energy at the peak.\n\n"
        "**Preload** (second table). Rock of 5 cm × 3.5 cm under 5 and 7.5 MPa. The error is the largest difference of "
        "the displacements from those after a ramp of 1 ms, over the largest displacement.",
        table(["choice", "modulus", "strength", "failed bonds", "kinetic share", "sub-steps", "time, relative"], rows) + "\n\n" + rest,
        "rock_accuracy.png",
        "- With s times the mass the press acts as if √s times as fast. The modulus stays; inertia adds to the "
        "strength and to the cracks.\n"
        "- Up to 0.9 of the critical step strengths stay within 0.3 %, while the rubble after the peak is different "
        "with every step. The error of a pulse in a bar is of second order.\n"
        "- A preload comes to rest at the same displacements whatever its ramp and damping; they decide how many "
        "sub-steps it takes.",
        "A ramp lasts two crossings of sound at least: 15 µs are too short for that.",
        ("strength with larger masses and longer sub-steps", "*itself*: the same specimen without",
         f"mass × {of_mass[1][0]:g}: {100 * of_mass[1][1]:+.1f} %; up to 0.9 of the critical step within "
         f"{100 * max(abs(m[1]) for m in of_step):.1f} %"))


entries = [bond_law, bar_pulse, energy, thermal, accuracy] + rock_tests.entries
