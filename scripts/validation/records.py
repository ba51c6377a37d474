"""What the tests measured, and how a section of the page is put together."""
import json
import pathlib
import re
import textwrap
from typing import NamedTuple

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402 (the back end comes first)
from tables import table  # noqa: E402


class Records:
    """Rows that tests appended to NAME.jsonl, as lists of dictionaries; empty where a test was not run."""

    def __init__(self, folder: pathlib.Path):
        self.folder = folder

    def __getitem__(self, name):
        path = self.folder / f"{name}.jsonl"
        return [json.loads(line) for line in path.read_text(encoding="utf-8").splitlines()] if path.exists() else []


class Section(NamedTuple):
    """A section of the page, and its line in the overview: what is compared, with what, the result."""

    title: str
    text: str
    overview: tuple = ()


def wrap(text):
    """Paragraphs and lists of Markdown in lines of at most 120 columns. Lines break at spaces outside of `code`, not
    before a sign or a number that would begin a list there, nor between a number and its unit. Tables stay."""
    stick = "\0"

    def fill(line):
        line = re.sub(r"`[^`]+`", lambda code: code[0].replace(" ", stick), line)
        line = re.sub(r"(?<=\S) (?=([-+*=]|\d+[.)]) )|(?<= =) |(?<=\d) (?=%|[kMG]Pa|[cm]?m\b|K\b|µ)|"
                      r"((?<=Table)|(?<=Eq\.)|(?<=Fig\.)) (?=\d)", stick, line)
        lines = textwrap.fill(line, 120, subsequent_indent="  " if line.startswith("- ") else "",
                              break_long_words=False, break_on_hyphens=False)
        return lines.replace(stick, " ")

    return "\n".join(line if line.startswith("|") else fill(line) for line in text.split("\n"))


def section(title, test, setup, rows=None, figure=None, result="", limits="", overview=()):
    """One section: what is compared with what, a table (Markdown) and a figure's file name, what they show, the names
    of the tests, and what limits the result. `overview`: what is compared, with what, and the result, in few words."""
    parts = [f"### {title}", wrap(setup)]
    if rows:
        parts.append(rows)
    if figure:
        parts.append(f"![{title}](validation/{figure})")
    if result:
        parts.append(wrap(lead("Result", result)))
    names = test.split(", ")
    parts.append(wrap(f"Test{'s' if len(names) > 1 else ''}: " + ", ".join(f"`{name}`" for name in names) + "."))
    if limits:
        parts.append(wrap(lead("Limits", limits)))
    return Section(title, "\n\n".join(parts), overview)


def lead(word, text):
    """A bold word before a paragraph, or before a list."""
    return f"**{word}.**" + ("\n\n" if text.startswith("- ") else " ") + text


def anchor(title):
    """The name that a heading has as the target of a link."""
    return re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")


def overview(sections):
    """The table at the top of the page."""
    return table(["what is compared", "with", "result", "section"],
                 [[*of.overview, f"[{of.title}](#{anchor(of.title)})"] for of in sections if of.overview])


def save(figure, path):
    """Writes a figure and frees it; without a date inside, so that the same numbers give the same file."""
    figure.tight_layout()
    figure.savefig(path, dpi=110, metadata={"Software": None})
    plt.close(figure)
