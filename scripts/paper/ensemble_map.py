"""The types of dissolution over pressure and Damkohler number, with how sure each is."""
import collections

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

TYPES = {"permeation": "#2166ac", "permeation-cavity": "#f4a582", "cavity": "#b2182b", "none": "#cccccc"}


def draw(rows, lattice, path):
    """rows: members with pressure_MPa, Da, type, cavity_share; a pie of types for each condition, below it their number."""
    conditions = collections.defaultdict(list)
    for row in rows:
        conditions[float(row["pressure_MPa"]), float(row["Da"])].append(row)
    pressures = sorted({p for p, _ in conditions})
    numbers = sorted({da for _, da in conditions})
    figure, axes = plt.subplots(figsize=(1.5 + 1.3 * len(pressures), 1.2 + 1.1 * len(numbers)), layout="constrained")
    for (pressure, da), members in conditions.items():
        x, y = pressures.index(pressure), numbers.index(da)
        counts = [sum(m["type"] == kind for m in members) for kind in TYPES]
        axes.pie(counts, colors=TYPES.values(), radius=0.3, center=(x, y), frame=True, startangle=90)
        shares = [float(m["cavity_share"]) for m in members]
        axes.text(x, y - 0.42, f"{len(members)}: {100 * min(shares):.0f} to {100 * max(shares):.0f} %", ha="center", va="center",
                  fontsize=7)
    axes.set_xlim(-0.6, len(pressures) - 0.4)
    axes.set_ylim(-0.6, len(numbers) - 0.4)
    axes.set_xticks(range(len(pressures)), [f"{p:g}" for p in pressures])
    axes.set_yticks(range(len(numbers)), [f"{da:g}" for da in numbers])
    axes.set_xlabel("injection pressure, MPa")
    axes.set_ylabel("Da")
    axes.set_title(f"types of dissolution at 0.16 s, {lattice}; below: members and shares in cavities", fontsize=9)
    shown = {m["type"] for members in conditions.values() for m in members}
    axes.legend(handles=[plt.Rectangle((0, 0), 1, 1, color=c, label=kind) for kind, c in TYPES.items() if kind in shown],
                loc="upper center", bbox_to_anchor=(0.5, -0.12), ncols=3, fontsize=8, frameon=False)
    figure.savefig(path, dpi=110)
    plt.close(figure)
