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
        "The slowest mode of two insulated layers in contact, fluid and solid, against its closed form: cosines of equal "
        "decay rate, joined by continuous temperature and flux. σ and λ are the ratios of volumetric heat capacity and "
        "conductivity, solid to fluid. Second order at every contrast, energy kept to round-off. In one dimension D2Q9 and "
        "D2Q5 are the same three velocities, and the results agree to round-off.",
        table(["set", "σ", "λ", "error at 32 nodes", "order", "energy drift"], cells), "two_layer_mode.png")


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
    return section(
        "Two half-spaces brought into contact", "TwoHalfSpaces.MeetAtTheContactTemperature",
        "Cold fluid and hot solid take the contact temperature (e_f T_f + e_s T_s)/(e_f + e_s), e = √(λ ρ c_p), at once and "
        "keep it (Carslaw and Jaeger, Conduction of Heat in Solids): a wrong ratio of heat capacities shows here and in no "
        "steady state. Lines are the error functions of the exact solution.",
        table(["set", "σ", "diffusivity ratio", "steps", "measured", "exact"], rows), "half_spaces.png")


def convection(records, figures):
    layers, carried, disc = (records[f"heat_{name}"] for name in ("convected_layers", "carried_diffusivity", "disc"))
    if not (layers and carried and disc):
        return None
    pixels = "; ".join(f"λ = {r['conductivity']:g}: {r['error']:.1e}" for r in disc if r["set"] == "D2Q5")
    pixels9 = "; ".join(f"{r['error']:.1e}" for r in disc if r["set"] == "D2Q9")
    rows = [[r["set"], f"{r['sigma']:g}", f"{r['error_16']:.1e}", f"{r['error_32']:.1e}", f"{r['order']:.2f}"] for r in layers]
    speeds = ", ".join(f"{100 * (r['D2Q5'] - 1):+.2f} % and {100 * (r['D2Q9'] - 1):+.2f} % at u = {r['u']:g}" for r in carried)
    return section(
        "Convection past a solid layer; D2Q5 or D2Q9", "ConvectedTwoLayers.ConvergeWithSecondOrderAtPeclet20, "
        "CarriedTemperature.DiffusesOnD2Q9AsAtRestAndOnD2Q5LessByThreeTimesTheSquareOfTheSpeed",
        "A fluid layer that flows at Peclet number 20 past a solid layer between walls of wavy temperature, against the "
        "closed form (complex hyperbolic sines). And the diffusivity of a wave that a uniform flow carries: D2Q5 has "
        f"1 - 3 u² of it, D2Q9 all of it (measured {speeds}, D2Q5 and D2Q9), and its error in the layers is smaller. "
        "Its diagonal links, which walls turn back, are of first order where heat flows along a wall, so that its order is "
        "lower; and beside stair-steps, on a disc in a uniform gradient, it is no better "
        f"(largest error over the difference applied: {pixels} on D2Q5; {pixels9} on D2Q9).",
        table(["set", "σ", "error, 16 nodes per layer", "32 nodes", "order"], rows))


def heated_slab(records, figures):
    rows, sides = records["heat_heated_slab"], records["heat_adiabatic_side"]
    if not (rows and sides):
        return None
    return section(
        "A slab with a given heat flux", "HeatedSlab.HasTheGradientOfItsFluxExactly",
        "Fluid and rock in series, a heat flux given on one side and a temperature on the other, in all four directions "
        "and with both velocity sets: the steady gradients are q/λ in each layer to round-off (largest relative deviation "
        f"{max(abs(r['error']) for r in rows):.0e}), and the heat that entered is the given flux times the time. "
        "Along adiabatic sides, corners included, a profile stays one-dimensional to "
        f"{max(row['across'] for row in sides):.0e} of its largest value with both sets "
        "(`AdiabaticSide.LeavesAProfileAlongItOneDimensional`).")


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
        "Left: steady conduction and diffusion in the ring between two discs that are openings (R₂ = 2.5 R₁), against the "
        "logarithmic profile. The surface of an opening lies half way along its links, up to half a cell from the circle: "
        "first order in the cell over the radius. Right: a well that feeds a given speed, against the radial flow "
        f"that continuity asks for; the well lets in its speed times its true circumference, the drain takes all of it "
        f"(to {abs(well['left_over_fed']):.0e}), and two cells from either staircase the speed is right within {well['radial']:.1%}. "
        "Beside flat ends an opening gives the fields of a side of the lattice to 1e-14.",
        table(["physics", "set", "R₁, cells", "largest error of the profile", "error of the flux", "balance"], cells),
        "openings.png")


def natural_convection(records, figures):
    rows = sorted(records["natural_convection"], key=lambda row: row["rayleigh"])
    if not rows:
        return None
    published = {1e3: 1.118, 1e4: 2.243, 1e5: 4.519, 1e6: 8.800}
    return section(
        "Natural convection in a square cavity", "NaturalConvection.*, NaturalConvectionLong.*",
        "Air (Prandtl number 0.71) between a warm and a cold wall, the benchmark of de Vahl Davis (1983): mean Nusselt number "
        "of the warm wall, from the heat flow through it in the `history.csv` of `cases/heated_cavity.toml`, run by the program "
        "with the gravity of each Rayleigh number.",
        table(["Ra", "nodes", "measured", "de Vahl Davis", "deviation"],
              [[f"{row['rayleigh']:.0e}", f"{row['cells']} x {row['cells']}", f"{row['nusselt']:.4f}",
                f"{published[row['rayleigh']]:.3f}", f"{100 * (row['nusselt'] / published[row['rayleigh']] - 1):+.2f} %"]
               for row in rows]))


def film(records, figures):
    slabs, couette = records["heat_film"], records["thermal_viscosity"]
    if not (slabs and couette):
        return None
    decay = next(row for row in slabs if row["what"] == "decay")
    steady = max(abs(row["error"]) for row in slabs if row["what"] == "steady")
    return section(
        "Heat transfer at a side, and viscosity that depends on the temperature",
        "HeatFlow.ThroughASlabWithAFilm, HeatFlow.OfACoolingSlabDecaysAtTheRateOfItsBiotNumber, ThermalViscosity.*",
        "Newton's law of cooling at a side: the resistances of a slab and of the film beyond it add up, in fluid and rock and with "
        f"both velocity sets (largest relative error of the heat flow {steady:.0e}); a slab of Biot number 1.5 cools at the "
        f"rate ζ², ζ tan ζ = Bi (Carslaw and Jaeger), within {abs(decay['error']):.0e} on 40 nodes. Plane Couette flow across a "
        "linear temperature profile, whose shear stress is the same everywhere, so that u is the integral of 1/ν(T): largest error "
        "over the speed of the wall, viscosities between the walls in a ratio of 3.9 (Arrhenius) and 4 (table).",
        table(["law", "nodes", "largest error"], [[row["law"], row["cells"], f"{row['error']:.1e}"] for row in couette]))


entries = [two_layer_mode, half_spaces, convection, heated_slab, film, natural_convection, openings]
