"""Tables of pages and files."""
import csv


def table(header, rows):
    """A Markdown table; its last line has no end."""
    return "\n".join("| " + " | ".join(map(str, row)) + " |" for row in (header, ["---"] * len(header), *rows))


def write_csv(path, rows):
    """A file of rows, dictionaries; a cell that a row does not have is empty."""
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, dict.fromkeys(name for row in rows for name in row), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
