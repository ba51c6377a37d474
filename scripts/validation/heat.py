"""Heat: each entry takes (records, folder of figures) and returns its section, or None where its test was not run."""
import math

import numpy as np

from .records import plt, save, section, table


def two_layer_mode(records, figures):
    rows = records["heat_two_layer_mode"]
    if not rows:
        return None
    figure, axes = plt.subplots(figsize=(5.6, 3.9))
    n = np.array([8, 16, 32])
    # equal diffusivities (σ = λ) make the mode one cosine, whose error nearly vanishes: in the table only
    for row in (r for r in rows if r["set"] == "D2Q5" and r["error_32"] > 1e-5):
        axes.loglog(n, [row[f"error_{k}"] for k in n], "o-", ms=4,
                    label=f"σ = {row['sigma']:g}, λ = {row['conductivity']:g}")
    axes.loglog(n, 0.05 / n**2, "k:", label="second order")
    axes.set(xlabel="nodes per layer", ylabel="largest error / amplitude")
    axes.set_xticks(n, [str(k) for k in n])
    axes.minorticks_off()
    axes.legend(fontsize=7)
    save(figure, figures / "two_layer_mode.png")
    cells = [[r["set"], f"{r['sigma']:g}", f"{r['conductivity']:g}", f"{r['error_32']:.1e}", f"{r['order']:.2f}",
              f"{abs(r['drift']):.0e}"] for r in rows]
    return section(
        "Conjugate heat: a decaying mode of two layers", "TwoLayerEigenmode.DecaysWithSecondOrderAtAnyContrast",
        "The slowest mode of two insulated layers in contact, one fluid and one solid, is compared with its closed "
        "form: cosines of equal decay rate, joined by continuous temperature and flux. σ and λ are the ratios of "
        "volumetric heat capacity and conductivity, solid to fluid.",
        table(["set", "σ", "λ", "error at 32 nodes", "order", "energy drift"], cells), "two_layer_mode.png",
        "The scheme is of second order at every contrast and conserves energy to round-off. In one dimension D2Q9 and "
        "D2Q5 are the same three velocities, and their results agree to round-off.",
        overview=("decay of heat in a fluid and a solid layer in contact", "closed form",
                  f"second order; error at 32 nodes {max(r['error_32'] for r in rows):.1e} at most"))


def half_spaces(records, figures):
    contact, profile = records["heat_half_spaces_contact"], records["heat_half_spaces_profile"]
    if not (contact and profile):
        return None
    figure, axes = plt.subplots(figsize=(6, 3.8))
    for k, sigma in enumerate(sorted({r["sigma"] for r in profile})):
        rows = [r for r in profile if r["sigma"] == sigma]
        for steps, marker in zip(sorted({r["steps"] for r in rows}), "ox"):
            points = [r for r in rows if r["steps"] == steps]
            d_f, d_s = points[0]["d_f"], points[0]["d_s"]
            e_f, e_s = math.sqrt(d_f), sigma * math.sqrt(d_s)
            meet = e_s / (e_f + e_s)
            x = np.linspace(-80, 80, 400)
            exact = [meet * math.erfc(-at / (2 * math.sqrt(d_f * steps))) if at < 0 else
                     1 - (1 - meet) * math.erfc(at / (2 * math.sqrt(d_s * steps))) for at in x]
            axes.plot(x, exact, f"C{k}-", lw=1)
            axes.plot([r["x"] for r in points], [r["theta"] for r in points], f"C{k}{marker}", ms=4,
                      label=f"σ = {sigma:g}, {steps} steps")
    axes.axvline(0, color="0.7", lw=0.8)
    axes.set(xlabel="distance from the contact, nodes (fluid left, solid right)", ylabel="temperature, cold 0, hot 1")
    axes.legend(fontsize=8)
    save(figure, figures / "half_spaces.png")
    rows = [[r["set"], f"{r['sigma']:g}", f"{r['diffusivity']:g}", r["steps"], f"{r['measured']:.5f}", f"{r['exact']:.5f}"]
            for r in contact]
    same = all(row[4] == row[5] for row in rows)
    return section(
        "Two half-spaces brought into contact", "TwoHalfSpaces.MeetAtTheContactTemperature",
        "Cold fluid and hot solid are brought into contact. At once they take the contact temperature (e_f T_f + e_s "
        "T_s)/(e_f + e_s), e = √(λ ρ c_p), and keep it (Carslaw and Jaeger, Conduction of Heat in Solids). The table "
        "has the contact temperature; the lines of the figure are the error functions of the exact solution.",
        table(["set", "σ", "diffusivity ratio", "steps", "measured", "exact"], rows), "half_spaces.png",
        "A wrong ratio of heat capacities shows in this test and in no steady state.",
        overview=("temperature where cold fluid meets hot solid", "Carslaw and Jaeger",
                  "equal to five decimals" if same else
                  f"within {max(abs(r['measured'] - r['exact']) for r in contact):.0e}"))


def convection(records, figures):
    layers, carried, disc = (records[f"heat_{name}"] for name in ("convected_layers", "carried_diffusivity", "disc"))
    if not (layers and carried and disc):
        return None
    by_set = {name: {r["conductivity"]: f"{r['error']:.1e}" for r in disc if r["set"] == name}
              for name in ("D2Q5", "D2Q9")}
    pixels = table(["λ", "D2Q5", "D2Q9"],
                   [[f"{ratio:g}", error, by_set["D2Q9"].get(ratio, "")] for ratio, error in by_set["D2Q5"].items()])
    rows = [[r["set"], f"{r['sigma']:g}", f"{r['error_16']:.1e}", f"{r['error_32']:.1e}", f"{r['order']:.2f}"] for r in layers]
    speeds = table(["u", "D2Q5", "D2Q9"],
                   [[f"{r['u']:g}"] + [f"{100 * (r[name] - 1):+.2f} %" for name in ("D2Q5", "D2Q9")] for r in carried])
    return section(
        "Convection past a solid layer; D2Q5 or D2Q9", "ConvectedTwoLayers.ConvergeWithSecondOrderAtPeclet20, "
        "CarriedTemperature.DiffusesOnD2Q9AsAtRestAndOnD2Q5LessByThreeTimesTheSquareOfTheSpeed",
        "A fluid layer flows at Peclet number 20 past a solid layer, between walls of wavy temperature. The "
        "temperature is compared with the closed form (complex hyperbolic sines). In a second test a uniform flow "
        "carries a wave of temperature, and its diffusivity is measured.",
        table(["set", "σ", "error, 16 nodes per layer", "32 nodes", "order"], rows), None,
        "The error of D2Q9 in the layers is smaller. The diffusivity of a carried wave is 1 - 3 u² of the given one "
        f"with D2Q5, and all of it with D2Q9. Measured deviation of the diffusivity:\n\n{speeds}",
        "The diagonal links of D2Q9, which walls turn back, are of first order where heat flows along a wall, so that "
        "its order is lower. Beside stair-steps D2Q9 is no better than D2Q5: for a disc in a uniform gradient the "
        f"largest error over the difference applied is\n\n{pixels}",
        ("heat in a fluid that flows past a solid layer", "closed form",
         f"error at 32 nodes: D2Q5 {max(r['error_32'] for r in layers if r['set'] == 'D2Q5'):.1e}, "
         f"D2Q9 {max(r['error_32'] for r in layers if r['set'] == 'D2Q9'):.1e}"))


def heated_slab(records, figures):
    rows, sides = records["heat_heated_slab"], records["heat_adiabatic_side"]
    if not (rows and sides):
        return None
    worst = max(abs(r["error"]) for r in rows)
    return section(
        "A slab with a given heat flux", "HeatedSlab.HasTheGradientOfItsFluxExactly",
        "Fluid and rock in series, with a given heat flux on one side and a given temperature on the other, in all "
        "four directions and with both velocity sets.",
        result="- The steady gradients are q/λ in each layer to round-off (largest relative deviation "
        f"{worst:.0e}).\n"
        "- The heat that entered is the given flux times the time.\n"
        "- Along adiabatic sides, corners included, a profile stays one-dimensional to "
        f"{max(row['across'] for row in sides):.0e} of its largest value with both sets "
        "(`AdiabaticSide.LeavesAProfileAlongItOneDimensional`), and through layers of fluid and rock to 1e-13 "
        "(`AdiabaticSide.LeavesAProfileThroughLayersOneDimensional`).",
        overview=("gradients in fluid and rock under a given heat flux", "q/λ", f"round-off, {worst:.0e}"))


def openings(records, figures):
    rings, rows = records["opening_ring"], records["opening_ring_profile"]
    wells, speeds = records["opening_well"], records["opening_well_profile"]
    if not (rings and rows and wells and speeds):
        return None
    figure, (left, right) = plt.subplots(1, 2, figsize=(8.4, 3.7))
    r = np.linspace(1, 2.5, 200)
    left.plot(r, np.log(2.5 / r) / np.log(2.5), "k-", lw=1, zorder=3, label="ln(R₂/r)/ln(R₂/R₁)")
    for first, physics, name, marker in ((0, "heat", "temperature", "o"), (7, "A", "concentration", "x")):
        points = [row for row in rows if row["physics"] == physics][first::15]
        left.plot([p["r"] for p in points], [p["value"] for p in points], marker, ms=3.5, mfc="none", lw=0,
                  label=f"{name}, R₁ = 16 cells")
    left.set(xlabel="r / R₁", ylabel="value over the difference applied")
    right.plot(r, 1 / r, "k-", lw=1, zorder=3, label="R₁/r")
    right.plot([p["r"] for p in speeds[::3]], [p["u"] for p in speeds[::3]], "o", ms=3, mfc="none", label="well, R₁ = 12 cells")
    right.set(xlabel="r / R₁", ylabel="radial speed / speed at the well")
    for axes in (left, right):
        axes.legend(fontsize=8)
    save(figure, figures / "openings.png")
    names = {"heat": "heat", "A": "solute"}
    cells = [[names[row["physics"]], row["set"].upper(), f"{row['inner']:g}", f"{row['field']:.3f}",
              f"{row['flux']:+.3f}", f"{row['balance']:.0e}"] for row in rings]
    well = wells[-1]
    return section(
        "Openings inside the lattice", "RingBetweenOpenings, Well, HeatedPipe, ShapeAsSide",
        "- Left in the figure, and in the table: steady conduction and diffusion in the ring between two discs that "
        "are openings (R₂ = 2.5 R₁), compared with the logarithmic profile.\n"
        "- Right: a well that feeds a given speed, compared with the radial flow that continuity requires.",
        table(["physics", "set", "R₁, cells", "largest error of the profile", "error of the flux", "balance"], cells),
        "openings.png",
        "- The well lets in its speed times its true circumference. The drain takes all of it "
        f"(to {abs(well['left_over_fed']):.0e}). Two cells from either staircase the speed is right within "
        f"{well['radial']:.1%}.\n"
        "- Beside flat ends an opening gives the fields of a side of the lattice to 1e-14.",
        "The surface of an opening lies half way along its links, up to half a cell from the circle. The error is of "
        "first order in the cell over the radius.",
        ("heat and solute between round openings; flow from a well", "logarithmic profile; continuity",
         f"profile within {max(row['field'] for row in rings if row['inner'] == max(r['inner'] for r in rings)):.3f} "
         f"at R₁ = {max(row['inner'] for row in rings):g} cells; speed within {well['radial']:.1%}"))


def natural_convection(records, figures):
    rows = sorted(records["natural_convection"], key=lambda row: row["rayleigh"])
    if not rows:
        return None
    published = {1e3: 1.118, 1e4: 2.243, 1e5: 4.519, 1e6: 8.800}
    worst = max(abs(row["nusselt"] / published[row["rayleigh"]] - 1) for row in rows)
    return section(
        "Natural convection in a square cavity", "NaturalConvection.*, NaturalConvectionLong.*",
        "Air (Prandtl number 0.71) between a warm and a cold wall, the benchmark of de Vahl Davis (1983). The program "
        "runs `cases/heated_cavity.toml` with the gravity of each Rayleigh number. The mean Nusselt number of the warm "
        "wall comes from the heat flow through it in `history.csv`.",
        table(["Ra", "nodes", "measured", "de Vahl Davis", "deviation"],
              [[f"{row['rayleigh']:.0e}", f"{row['cells']} x {row['cells']}", f"{row['nusselt']:.4f}",
                f"{published[row['rayleigh']]:.3f}", f"{100 * (row['nusselt'] / published[row['rayleigh']] - 1):+.2f} %"]
               for row in rows]),
        overview=(f"Nusselt number of a heated cavity, Ra {rows[0]['rayleigh']:.0e} to {rows[-1]['rayleigh']:.0e}",
                  "de Vahl Davis 1983", f"within {100 * worst:.2f} %"))


def film(records, figures):
    slabs, couette = records["heat_film"], records["thermal_viscosity"]
    if not (slabs and couette):
        return None
    decay = next(row for row in slabs if row["what"] == "decay")
    steady = max(abs(row["error"]) for row in slabs if row["what"] == "steady")
    finest = max(row["cells"] for row in couette)
    return section(
        "Heat transfer at a side, and viscosity that depends on the temperature",
        "HeatFlow.ThroughASlabWithAFilm, HeatFlow.OfACoolingSlabDecaysAtTheRateOfItsBiotNumber, ThermalViscosity.*",
        "- Newton's law of cooling at a side: the resistances of a slab and of the film beyond it must add up, in "
        "fluid and rock and with both velocity sets.\n"
        "- A slab of Biot number 1.5 must cool at the rate ζ², ζ tan ζ = Bi (Carslaw and Jaeger).\n"
        "- Plane Couette flow across a linear temperature profile: the shear stress is the same everywhere, so that u "
        "is the integral of 1/ν(T). The table has the largest error over the speed of the wall. The viscosities "
        "between the walls are in a ratio of 3.9 (Arrhenius) and 4 (table).",
        table(["law", "nodes", "largest error"],
              [[row["law"], row["cells"], f"{row['error']:.1e}"] for row in couette]), None,
        f"The largest relative error of the heat flow through slab and film is {steady:.0e}. The rate of cooling is "
        f"right within {abs(decay['error']):.0e} on 40 nodes.",
        overview=("heat through a film; Couette flow with a thermal viscosity",
                  "Carslaw and Jaeger; integral of 1/ν(T)",
                  f"heat flow {steady:.0e}; speed {max(row['error'] for row in couette if row['cells'] == finest):.1e} "
                  f"at {finest} nodes"))


entries = [two_layer_mode, half_spaces, convection, heated_slab, film, natural_convection, openings]
