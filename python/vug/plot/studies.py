"""What a study has found: curves over one key, maps over two."""
import numpy as np
from matplotlib import pyplot as plt

from .style import BLUE, save, tidy


def _is_logarithmic(values):
    positive = values[values > 0]
    return len(positive) == len(values) and len(values) > 1 and positive.max() > 30 * positive.min()


def _axis(axes, which, key, values):
    getattr(axes, f"set_{which}label")(key)
    if _is_logarithmic(values):
        getattr(axes, f"set_{which}scale")("log")


def _borders(values):
    """Between the values of a key, and as far beyond the first and the last: on the axis that `_axis` gives it."""
    places = np.log(values) if _is_logarithmic(values) else values
    middles = (places[1:] + places[:-1]) / 2
    borders = np.concatenate([[2 * places[0] - middles[0]], middles, [2 * places[-1] - middles[-1]]])
    return np.exp(borders) if _is_logarithmic(values) else borders


def keys_of(study):
    """The two keys with most values, or the only one; seeds where nothing else differs. Results are averaged over the
    others."""
    differing = [key for key in study.keys if len(np.unique(study[key])) > 1] or study.keys
    of_physics = [key for key in differing if not key.endswith("seed")] or differing
    return sorted(of_physics, key=lambda key: -len(np.unique(study[key])))[:2]


def _title(study, results):
    """How many runs and results there are, and over which keys the results are averaged, or which differ as well."""
    failed = len(study.failures)
    parts = [f"{study.name}: {len(study)} of {len(study) + failed} runs done" if failed else
             f"{study.name}: {len(study)} runs"]
    if len(results) < len(results_of(study)):
        parts.append(f"{len(results)} of {len(results_of(study))} results")
    axes = keys_of(study)
    others = [key for key in study.keys if key not in axes and len(np.unique(study[key])) > 1]
    if others:
        shared = len(set(zip(*(study[key] for key in axes)))) < len(study)
        done = " (of runs that are done)" if failed and shared else ""
        parts.append(("means over " if shared else "differing as well: ") + ", ".join(others) + done)
    return "; ".join(parts)


def _places(study, key):
    """(where the runs lie on the axis of a key, names of the places): finite numbers themselves and None. Others stand
    one beside the other: infinity behind the largest number, text, as quantities with units are, in the order of the
    study, which runs that failed are part of."""
    values = study[key]
    if np.issubdtype(values.dtype, np.number):
        if np.isfinite(values).all():
            return values, None
        marks = np.unique(values)
        return np.searchsorted(marks, values).astype(float), [f"{mark:.12g}" for mark in marks]
    runs = list(zip(study.runs, values)) + [(failed["run"], failed[key]) for failed in study.failures]
    in_order = dict.fromkeys(value for _, value in sorted(runs, key=lambda run: (len(run[0]), run[0])))
    names = [value for value in in_order if value in values]
    return np.array([float(names.index(value)) for value in values]), [name.strip('"') for name in names]


def _labels(marks):
    """Numbers with as many digits as tell them apart."""
    gap = np.diff(marks).min() if len(marks) > 1 else np.inf
    for digits in range(6, 17):
        labels = [f"{mark:.{digits}g}" for mark in marks]
        if all(abs(float(label) - mark) < 0.01 * gap for label, mark in zip(labels, marks)):
            break
    return labels


def _ticks(axis, marks, labels):
    """Labels at the marks, at a slant where side by side they would overlap."""
    axis.set_ticks(marks, labels=labels)
    axis.set_ticks([], minor=True)
    if axis.axis_name == "x" and sum(len(label) + 2 for label in labels) > 36:
        axis.set_tick_params(rotation=30)
        for label in axis.get_ticklabels():
            label.set_horizontalalignment("right")


def _mean(values):
    """Over the runs that have one; NaN where none has."""
    finite = values[np.isfinite(values)]
    return finite.mean() if len(finite) else np.nan


def results_of(study):
    """The results that differ between runs; the errors of balances are none, and time and steps only where all else is
    equal."""
    def differs(values):
        return np.issubdtype(values.dtype, np.number) and len(np.unique(values[np.isfinite(values)])) > 1

    of_time = ("time_s", "step_1")
    names = [name for name in study.results if "balance_error" not in name and differs(study[name])]
    return [name for name in names if name not in of_time] or names


def draw_result(axes, study, result):
    """One result over the keys; every run is a point, and where two runs share a place their mean is shown."""
    keys, values = keys_of(study), study[result]
    x, x_names = _places(study, keys[0])
    if len(keys) == 1:
        axes.plot(x, values, "o", color=BLUE, markersize=4)
        places = np.unique(x)
        axes.plot(places, [_mean(values[x == place]) for place in places], "-", color=BLUE, linewidth=1)
        _axis(axes, "x", keys[0], x)
        if x_names:
            _ticks(axes.xaxis, range(len(x_names)), x_names)
        _axis(axes, "y", result, values[np.isfinite(values)])
        tidy(axes)
        return
    y, y_names = _places(study, keys[1])
    places = np.unique(np.column_stack([x, y]), axis=0)
    means = np.array([_mean(values[(x == place[0]) & (y == place[1])]) for place in places])
    norm = "log" if _is_logarithmic(means[np.isfinite(means)]) else "linear"
    columns, lines = np.unique(x), np.unique(y)
    is_grid = min(len(columns), len(lines)) > 1 and 2 * len(places) > len(columns) * len(lines)
    if is_grid:
        # a grid, of which some runs may have failed: cells that adjoin
        cells = np.ma.masked_all((len(lines), len(columns)))
        cells[np.searchsorted(lines, places[:, 1]), np.searchsorted(columns, places[:, 0])] = means
        cells = np.ma.masked_invalid(cells)
        image = axes.pcolormesh(_borders(columns), _borders(lines), cells, norm=norm, cmap="viridis",
                                edgecolors="white", linewidth=0.5)
    else:
        image = axes.scatter(places[:, 0], places[:, 1], c=means, cmap="viridis", norm=norm,
                             s=max(30, 5000 / len(places)), marker="s", edgecolors="white", linewidths=0.5)
        axes.margins(0.12)
    for which, key, along, names, marks in (("x", keys[0], x, x_names, columns), ("y", keys[1], y, y_names, lines)):
        _axis(axes, which, key, along)
        if names or (is_grid and len(marks) <= 7):  # the places of samples would lie one upon the other
            _ticks(getattr(axes, f"{which}axis"), marks, names or _labels(marks))
    axes.figure.colorbar(image, ax=axes, label="")
    axes.set_title(result, fontsize=9)


def regime_map(study, path, results=None):
    """Results of a study over its keys, the first six unless `results` names others; writes a PNG. None where no run is
    done or nothing differs."""
    results = results or results_of(study)[:6]
    if not results or not keys_of(study):
        return None
    columns = min(3, len(results))
    rows = -(-len(results) // columns)
    figure, grid = plt.subplots(rows, columns, squeeze=False, layout="constrained",
                                figsize=(4.8 * columns if columns > 1 else 6, 3.8 * rows + 0.4))
    for axes, result in zip(grid.flat, results):
        draw_result(axes, study, result)
    for axes in grid.flat[len(results):]:
        axes.set_visible(False)
    figure.suptitle(_title(study, results), fontsize=12)
    return save(figure, path)
