"""What the tests measured, and how a section of the page is put together."""
import json
import pathlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402 (the back end comes first)


class Records:
    """Rows that tests appended to NAME.jsonl, as lists of dictionaries; empty where a test was not run."""

    def __init__(self, folder: pathlib.Path):
        self.folder = folder

    def __getitem__(self, name):
        path = self.folder / f"{name}.jsonl"
        return [json.loads(line) for line in path.read_text().splitlines()] if path.exists() else []


def table(header, rows):
    """A Markdown table."""
    lines = ["| " + " | ".join(header) + " |", "| " + " | ".join("---" for _ in header) + " |"]
    return "\n".join(lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows])


def section(title, test, text, rows=None, figure=None):
    """One section: what is compared with what, the test's name, a table (Markdown) and a figure's file name."""
    parts = [f"### {title}", text, f"Test: `{test}`."]
    if rows:
        parts.append(rows)
    if figure:
        parts.append(f"![{title}](validation/{figure})")
    return "\n\n".join(parts)


def save(figure, path):
    """Writes a figure and frees it; without a date inside, so that the same numbers give the same file."""
    figure.tight_layout()
    figure.savefig(path, dpi=110, metadata={"Software": None})
    plt.close(figure)
