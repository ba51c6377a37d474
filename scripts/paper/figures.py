"""The counterparts of the paper's Figs. 8-13, nine conditions side by side."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection

from .regimes import CAVITY, dissolved_of, share_in_pores
from .run_data import DAMAGED, FAILED, NOTCH
from vug.plot import cracks as of_bonds  # run_data has made the package known

CM = 100  # per m
ROCK = "#d9d5cc"
WIDTHS = [w * 1e-3 for w in (0.3, 0.45, 0.6, 0.8, 1, 1.25, 1.5, 1.75, 2, 2.25, 2.5, 3, 3.5, 4)]  # m


def concentration(snapshot):
    return np.ma.masked_where(snapshot.solid, snapshot.field["concentration_L1"] / 1000), "viridis"


def pressure(snapshot):
    return np.ma.masked_where(snapshot.solid, snapshot.field["pressure"] / 1e6), "turbo"


def temperature(snapshot):
    return np.ma.asarray(snapshot.field["temperature"] - 288.15), "inferno"


def rock(snapshot):
    return np.ma.masked_where(snapshot.solid, np.ones(snapshot.solid.shape)), "Greys"


# file, title, unit, field, limits, cracks drawn
PANELS = [
    ("fig08_concentration", "reactant L1", "mol/L", concentration, (0, 3), False),
    ("fig09_fractures", "fractures", None, rock, (0, 4), True),
    ("fig10_pressure", "pressure", "MPa", pressure, None, False),
    ("fig11_temperature", "temperature above the injected fluid's", "K", temperature, (0, 200), False),
]


def draw(axes, snapshot, field, limits, cracks):
    values, colours = field(snapshot)
    colours = matplotlib.colormaps[colours].copy()
    colours.set_bad(ROCK)
    left, right, bottom, top = (CM * v for v in snapshot.extent)
    image = axes.imshow(values, origin="lower", extent=(left, right, bottom, top), cmap=colours,
                        vmin=limits[0], vmax=limits[1], interpolation="nearest")
    if cracks:
        for states, colour, width in (((NOTCH,), of_bonds.START, 1.2), (DAMAGED, of_bonds.DAMAGED, 0.8),
                                      (FAILED, of_bonds.FAILED, 1.2)):
            axes.add_collection(LineCollection(snapshot.bonds(states) * CM, colors=colour, linewidths=width))
    axes.set_xlim(left, right)
    axes.set_ylim(bottom, top)
    axes.set_xticks([])
    axes.set_yticks([])
    return image


def nine_panels(snapshots, folder):
    """Figs. 8-11: snapshots[(pressure in MPa, Da)]; Da down, pressure across."""
    pressures = sorted({p for p, _ in snapshots})
    numbers = sorted({da for _, da in snapshots})
    for name, title, unit, field, limits, cracks in PANELS:
        figure, grid = plt.subplots(len(numbers), len(pressures), squeeze=False, constrained_layout=True,
                                    figsize=(4.2 * len(pressures), 3.1 * len(numbers)))
        for row, da in zip(grid, numbers):
            for axes, p in zip(row, pressures):
                axes.set_title(f"{p} MPa, Da = {da:g}", fontsize=10)
                if (p, da) not in snapshots:
                    axes.set_axis_off()
                    continue
                # one scale of pressure per column: what the injection sets
                scale = limits or (0.1, p)
                image = draw(axes, snapshots[p, da], field, scale, cracks)
                if unit and not limits:
                    figure.colorbar(image, ax=axes, label=unit, shrink=0.8)
        if unit and limits:
            figure.colorbar(image, ax=grid, label=unit, shrink=0.6)
        figure.suptitle(title if unit else "failed bonds orange-red, damaged light blue, from the start black", fontsize=11)
        figure.savefig(folder / f"{name}.png", dpi=110)
        plt.close(figure)


def closer_look(snapshots, folder, reach=0.025):
    """Reactant and fractures within `reach` (m) of the hole, snapshots as above; what fine lattices hide in Fig. 8."""
    columns = min(3, len(snapshots))
    rows = -(-len(snapshots) // columns)
    figure, grid = plt.subplots(rows, columns, squeeze=False, constrained_layout=True, figsize=(1.2 + 4.4 * columns, 4.2 * rows))
    for axes in grid.flat:
        axes.set_axis_off()
    for axes, ((p, da), snapshot) in zip(grid.flat, sorted(snapshots.items(), key=lambda item: (item[0][1], item[0][0]))):
        image = draw(axes, snapshot, concentration, (0, 3), True)
        middle = CM * sum(snapshot.extent[2:]) / 2
        axes.set_xlim(0, CM * reach)
        axes.set_ylim(middle - CM * reach / 2, middle + CM * reach / 2)
        axes.set_title(f"{p} MPa, Da = {da:g}, t = {snapshot.time:.3g} s", fontsize=10)
    figure.colorbar(image, ax=grid, label="reactant L1 / (mol/L)", shrink=0.6)
    figure.suptitle("at the hole: failed bonds orange-red, damaged light blue, from the start black", fontsize=10)
    figure.savefig(folder / "closer_look.png", dpi=110)
    plt.close(figure)


def reactive_area(curves, folder):
    """Fig. 12: surface that acid has reached over time, curves[(pressure in MPa, Da)] = (time, area); a panel per Da."""
    numbers = sorted({da for _, da in curves})
    figure, row = plt.subplots(1, len(numbers), squeeze=False, constrained_layout=True, figsize=(4.4 * len(numbers), 3.4))
    for axes, da in zip(row[0], numbers):
        for (p, _), (time, area) in sorted((key, curve) for key, curve in curves.items() if key[1] == da):
            axes.plot(1000 * time, 100 * area, label=f"{p} MPa")
        axes.set_title(f"Da = {da:g}")
        axes.set_xlabel("time / ms")
        axes.set_ylim(bottom=0)
        axes.legend(frameon=False)
    row[0][0].set_ylabel("surface that acid has reached / cm")
    figure.savefig(folder / "fig12_reactive_area.png", dpi=110)
    plt.close(figure)


def pore_widths(snapshots, folder):
    """How much of what has dissolved lies in pores of a width and more, snapshots[(pressure in MPa, Da)]; a panel per Da."""
    numbers = sorted({da for _, da in snapshots})
    figure, row = plt.subplots(1, len(numbers), squeeze=False, constrained_layout=True, sharey=True, figsize=(4.4 * len(numbers), 3.4))
    for axes, da in zip(row[0], numbers):
        for (p, _), s in sorted((key, s) for key, s in snapshots.items() if key[1] == da):
            widths = [w for w in WIDTHS if w >= 4 * s.dx]
            shares = [share_in_pores(s.solid, dissolved_of(s), w / s.dx) for w in widths]
            axes.plot([1000 * w for w in widths], shares, "o-", markersize=3, label=f"{p} MPa")
        axes.axvline(1000 * CAVITY, color="grey", linewidth=0.8)
        axes.axhline(0.5, color="grey", linewidth=0.8)
        axes.set_title(f"Da = {da:g}")
        axes.set_xlabel("width of pore / mm")
        axes.set_xlim(0, 1000 * max(WIDTHS))
        axes.set_ylim(0, 1)
        axes.legend(frameon=False)
    row[0][0].set_ylabel("share of what has dissolved")
    figure.savefig(folder / "pore_widths.png", dpi=110)
    plt.close(figure)


def evolution(snapshots, path, name):
    """Fig. 13: reactant and fractures of one condition as it goes on."""
    figure, grid = plt.subplots(-(-len(snapshots) // 2), 2, squeeze=False, constrained_layout=True, figsize=(9.6, 6.4))
    for axes in grid.flat[len(snapshots):]:
        axes.set_axis_off()
    for axes, snapshot in zip(grid.flat, snapshots):
        image = draw(axes, snapshot, concentration, (0, 3), True)
        axes.set_title(f"t = {snapshot.time:.3g} s", fontsize=10)
    figure.colorbar(image, ax=grid, label="reactant L1 / (mol/L)", shrink=0.6)
    figure.suptitle(name)
    figure.savefig(path, dpi=110)
    plt.close(figure)
