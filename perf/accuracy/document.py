"""docs/accuracy.md and its picture."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.ticker import FuncFormatter, LogLocator  # noqa: E402
from tables import table  # noqa: E402

# What the table of the paper's rock says.
ROCK = """The coarse rock at 30 MPa, Da = 1.5e-3, first 12 ms. Errors are against `preset = "reference"` with a third of the
mechanical sub-step. The columns are errors of

- the dissolved volume, then its difference from the default's;
- the acid in place;
- the temperature (largest, over 200 K);
- the length of the cracks (in the mean over every millisecond).

**Crack length.** The error is 0.03 to 0.10 where one or two of the eight bonds fail some microseconds to 0.2 ms later
than in the reference computation, on the other side of a moment at which the cracks are looked at.

**Rounding.** Rounding alone, from one build to another, lets a bond fail a mechanical step later. From then on two runs
of the same equations differ by 1e-5 to 4e-5 in the dissolved volume. An error below 5e-5 is therefore as good as none.

`accuracy.tolerance = 1e-2` computes this rock with 64 times its mass (docs/model.md).

**Age of the rows.** `preset = careful` and the rows with `single` are newer than the others, in which the default's
bonds failed on the reference's side of such a moment (8e-8). Since `trt` keeps the momentum in single precision (CHANGELOG),
`precision = single` costs 0.92 and is off by 2.1e-5, `balanced` with `single` 0.53 and 3.2e-4 (medians of three).

**Transport.** The last two rows are differences, not errors. They conserve the acid that the default's advective form
takes (docs/acid-fracturing.md, "Acid that the advective form takes"). `advective_form = false` also lets acid pile up
beside staircases, `face_exchange` does not.

**Held flow.** The rows of `flow_tolerance` were measured before a flow had to be balanced, and slow pores steady by their
own measure, to be held (CHANGELOG). It is held later now, which costs more and errs less."""

TITLES = {
    "wall": ("Diffusion to a reactive wall (Eq. 28)", "Relative L2 error of the steady concentration, 100 x 80 cells, Da = 4.8."),
    "channel": ("Flow through a pathway of three nodes",
                "Relative L2 error of the velocity, at the paper's relaxation time 0.764."),
    "cooling": ("Rock cooled from one side", "Largest error of the temperature over its step, 400 cells."),
    "receding": ("A wall that recedes slowly",
                 "Error of the recession against the limit of slow dissolution. A volume of acid dissolves 0.012 volumes of\n"
                 "rock, times the factor."),
    "rock": ("The paper's rock", ROCK),
}

INTRODUCTION = """# Speed against accuracy

This page lists what the choices of a case file gain and what they cost, measured together. `perf/accuracy_cost` runs
every row and writes this page ({machine}).

- **Cost** is processor time as a ratio to the default of the same problem, which is run beside it.
- **Errors** are against an analytic solution for the first four problems, and against the most careful computation for
  the rock.

![error against cost](accuracy.png)

"""

# What the table of scenes says.
SCENES = """## Only what a scene requires

Physics that a case does not name has neither memory nor kernels (`tests/meta`). The table shows this for the paper's
rock, coarse, 400 x 280 nodes of which 15 % are fluid, with physics left out of its case. It has the bytes per node of
the lattice, and the processor time of a step at the start of the run. Mechanics alone takes so little because rock that
rests under its loads sleeps.

"""


def number(value):
    return f"{value:.1e}" if value else "0"


def errors_table(rows):
    names = list(rows[0]["errors"])
    errors = [[number(row["errors"].get(name, 0)) for name in names] for row in rows]
    return table(["choice", "cost", *names], [[row["choice"], f"{row['cost']:.2f}", *of_row] for row, of_row in zip(rows, errors)])


def draw(results, path):
    problems = [name for name in TITLES if any(row["problem"] == name for row in results["rows"])]
    rows = -(-len(problems) // 3)
    figure, axes = plt.subplots(rows, 3, figsize=(13, 4 * rows), squeeze=False, layout="constrained")
    for axis in axes.flat[len(problems):]:
        axis.set_axis_off()
    for axis, name in zip(axes.flat, problems):
        rows = [row for row in results["rows"] if row["problem"] == name]
        first = next(iter(rows[0]["errors"]))
        groups = list(dict.fromkeys(row["group"] for row in rows))
        floor = min([row["errors"][first] for row in rows if row["errors"][first] > 0], default=1) / 3
        for group in groups:
            chosen = [row for row in rows if row["group"] == group]
            axis.plot([row["cost"] for row in chosen], [max(row["errors"][first], floor) for row in chosen],
                      "k*" if group == "default" else "o", markersize=12 if group == "default" else 6, label=group)
        axis.set_yscale("log")
        axis.set_xscale("log")
        plain = FuncFormatter(lambda x, _: f"{x:g}")
        axis.xaxis.set_minor_locator(LogLocator(subs=(2, 5)))
        axis.xaxis.set_major_formatter(plain)
        axis.xaxis.set_minor_formatter(plain)
        axis.set_xlabel("processor time / default")
        axis.set_ylabel(f"error of the {first}")
        axis.set_title(TITLES[name][0], fontsize=10)
        axis.legend(fontsize=7)
        axis.grid(alpha=0.3, which="both")
    figure.savefig(path, dpi=90, metadata={"Software": None})
    plt.close(figure)


def write(results, page, picture):
    if not results["rows"]:
        return
    draw(results, picture)
    machines = dict.fromkeys(row.get("machine", results.get("machine", "machine not recorded"))
                             for row in [*results["rows"], *results.get("scenes", [])])
    text = INTRODUCTION.format(machine="; ".join(machines))
    for name, (title, what) in TITLES.items():
        rows = [row for row in results["rows"] if row["problem"] == name]
        if rows:
            text += f"## {title}\n\n{what}\n\n{errors_table(rows)}\n\n"
    if "scenes" in results:
        whole = results["scenes"][0]
        text += SCENES + table(["scene", "bytes per node", "ms per step", "share"],
                               [[row["scene"], f"{row['bytes_per_node']:.0f}", f"{row['milliseconds']:.2f}",
                                 f"{row['milliseconds'] / whole['milliseconds']:.2f}"] for row in results["scenes"]]) + "\n"
    page.write_text(text)
