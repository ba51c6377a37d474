"""history.csv as a few figures that each answer a question: acid, rock, heat, cracks, balances."""
import numpy as np
from matplotlib import pyplot as plt

from .style import DASHES, LINES, readable, save, tidy


class Curve:
    """A line: its label, its values over time."""

    def __init__(self, label, values):
        self.label, self.values = label, values


def _named(history, *wanted):
    """Curves of those columns that are there and are not zero throughout."""
    return [Curve(label, sign * history[name]) for name, label, sign in wanted
            if name in history and np.any(history[name] != 0)]


def species_of(history):
    """Names of the species in a history."""
    ending = "_gain_injected"
    return [name[:-len(ending)] for name in history if name.endswith(ending)]


GAINS = {"births": "new pores", "advective_form": "advective form"}  # how the others are named


def _rest_of_budget(history, amount, drawn):
    """What the gains in `drawn` leave out of an amount: what was there at the start, each opening, others in one curve."""
    start, opening = f"{amount}_gain_", f"{amount}_gain_shape_"
    gains = [name for name in history if name.startswith(start) and name not in drawn and np.any(history[name] != 0)]
    curves = _named(history, (f"{amount}_initial", "at the start", 1))
    curves += _named(history, *((name, f"through {name[len(opening):]}", 1)
                                for name in gains if name.startswith(opening)))
    others = [name[len(start):] for name in gains if not name.startswith(opening)]
    if others:
        label = ", ".join(GAINS.get(name, name.replace("_", " ")) for name in others)
        curves.append(Curve(label, sum(history[start + name] for name in others)))
    return curves


def acid(history):
    """Where each species has gone, mol/m: in the pores is the sum of the others, less what was spent or flowed out."""
    axes = []
    ages = np.any(history.get("dissolution_factor", 1) != 1)  # a slow scene: rock ages faster than acid flows and reacts
    for name in species_of(history):
        by_reaction = [column for column in history  # with rock, and of what each further reactant did
                       if column == f"{name}_gain_reaction" or column.startswith(f"{name}_gain_reaction_of_")]
        reacted = sum(history[column] for column in by_reaction)
        curves = _named(history, (f"{name}_gain_injected", "injected", 1))
        if np.any(reacted):
            made = np.sum(reacted) > 0
            curves.append(Curve("made by reaction", reacted) if made else Curve("spent on rock", -reacted))
        curves += _named(history, (f"{name}_gain_outflow", "flowed out", -1))
        curves += _rest_of_budget(history, name, [*by_reaction, f"{name}_gain_injected", f"{name}_gain_outflow"])
        title = f"{name}, of the lattice steps taken" if ages else name
        axes.append((title, "mol/m", curves + _named(history, (f"{name}_stored", "in the pores", 1))))
    return axes


def rock(history):
    """What dissolves: volume, surface, and how many cells."""
    return [("dissolved rock", "m²", _named(history, ("dissolved_volume", "volume per metre", 1))),
            ("reactive surface", "m", _named(history, ("reactive_area", "area per metre", 1))),
            ("new pores", "nodes", _named(history, ("nodes_dissolved", "dissolved", 1),
                                          ("nodes_opened_by_damage", "opened by damage", 1)))]


def heat(history):
    """What heat has come and gone, J/m (stored is the sum of the others), and the largest change of temperature."""
    curves = _named(history, ("heat_gain_injection", "injected", 1), ("heat_gain_sides", "through the sides", 1))
    curves += _rest_of_budget(history, "heat", ["heat_gain_injection", "heat_gain_sides"])
    return [("heat", "J/m", curves + _named(history, ("heat_stored", "stored", 1))),
            ("largest change of temperature", "K", _named(history, ("largest_temperature_change", "", 1)))]


def crack_counts(history):
    """Bonds by what has become of them, and energies, J/m."""
    return [("bonds", "bonds", _named(history, ("bonds_damaged", "damaged", 1), ("bonds_failed_in_tension", "failed in tension", 1),
                                      ("bonds_failed_in_shear", "failed in shear", 1), ("bonds_failed", "failed", 1),
                                      ("bonds_dissolved", "dissolved", 1))),
            ("energy", "J/m", _named(history, ("elastic_energy", "elastic", 1), ("kinetic_energy", "kinetic", 1)))]


def balances(history):
    """Errors of all balances, relative; drawn on a log scale."""
    ending = "_balance_error"
    return [("errors of the balances", "", [Curve(name[:-len(ending)].replace("_", " "), np.abs(history[name]))
                                            for name in history if name.endswith(ending)])]


TOPICS = {"acid": acid, "rock": rock, "heat": heat, "cracks": crack_counts, "balances": balances}


def topics_of(history):
    """{topic: [(title, unit, curves)]} of what the history can show."""
    shown = {}
    for topic, describe in TOPICS.items():
        axes = [entry for entry in describe(history) if entry[2]]
        if axes:
            shown[topic] = axes
    if not shown:  # another kind of history: its columns by unit
        units = {}
        for name in list(history)[1:]:
            units.setdefault(history.units[name], []).append(Curve(name.replace("_", " "), history[name]))
        shown["all"] = [(unit, unit, curves) for unit, curves in units.items()]
    return shown


def draw_curves(axes, time, title, unit, curves, logarithmic=False):
    """Lines over time, each with a colour and a dash of its own."""
    largest = max((np.nanmax(np.abs(curve.values), initial=0) for curve in curves), default=0)
    factor, unit = (1, unit) if logarithmic else readable(unit, largest)
    per_second, time_unit = readable("s", time[-1])
    time = per_second * time
    for k, curve in enumerate(curves):
        style = {"color": LINES[k % len(LINES)], "linestyle": DASHES[k % len(DASHES)], "linewidth": 1.5}
        values = np.where(curve.values > 0, curve.values, np.nan) if logarithmic else factor * curve.values
        axes.plot(time, values, label=curve.label, **style)
    axes.set_title(title, fontsize=10)
    axes.set_xlabel(f"time / {time_unit}")
    axes.set_ylabel(unit if unit != "1" else "")
    if logarithmic:
        axes.set_yscale("log")
        axes.axhline(np.finfo(float).eps, color="#888888", linewidth=0.8)
        axes.text(0.01, np.finfo(float).eps, "rounding", transform=axes.get_yaxis_transform(), fontsize=8, va="center",
                  color="#444444", bbox={"facecolor": "white", "edgecolor": "none", "pad": 1}, zorder=5)
    else:
        axes.ticklabel_format(axis="y", scilimits=(-3, 4), useOffset=False)
    tidy(axes)
    if logarithmic:
        axes.legend(fontsize=8, frameon=False, loc="upper left", bbox_to_anchor=(1, 1))
    elif len(curves) > 1 or curves[0].label:
        axes.legend(fontsize=8, frameon=False)


def topic(history, name, path, heading=""):
    """One figure of a history: "acid", "rock", "heat", "cracks" or "balances"; writes a PNG."""
    topics = topics_of(history)
    if name not in topics:
        raise KeyError(f"this history has no {name!r}; there are {', '.join(topics)}")
    entries = topics[name]
    columns = min(3, len(entries))
    rows = -(-len(entries) // columns)
    width = 7 if columns == 1 else 4.6 * columns
    figure, grid = plt.subplots(rows, columns, squeeze=False, layout="constrained", figsize=(width, 3.2 * rows + 0.4))
    for axes, (title, unit, curves) in zip(grid.flat, entries):
        draw_curves(axes, history["time"], title, unit, curves, logarithmic=name == "balances")
    for axes in grid.flat[len(entries):]:
        axes.set_visible(False)
    figure.suptitle(f"{heading}{name}", fontsize=12)
    return save(figure, path)


def histories(history, folder, heading=""):
    """All figures of a history, history_<topic>.png; returns their paths. None for fewer than two rows."""
    if len(history) < 2:
        return []
    return [topic(history, name, f"{folder}/history_{name}.png", heading) for name in topics_of(history)]
