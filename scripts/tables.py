"""Tables of pages."""


def table(header, rows):
    """A Markdown table; its last line has no end."""
    return "\n".join("| " + " | ".join(map(str, row)) + " |" for row in (header, ["---"] * len(header), *rows))
