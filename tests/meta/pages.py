"""Every link of every page leads somewhere, and the site (packaging/mkdocs.yml) has every page of docs/."""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDERS = [ROOT] + [ROOT / name for name in ("docs", "cases", "src", "python", "perf", "packaging", "tests")]


def anchor(heading):
    """The name that a heading has as the target of a link."""
    plain = re.sub(r"[^\w\- ]", "", heading.strip().lower().replace("`", ""))
    return plain.replace(" ", "-")


def text_of(page):
    """A page without its blocks of code."""
    return re.sub(r"^```.*?^```", "", page.read_text(), flags=re.M | re.S)


pages = sorted({page for folder in FOLDERS for page in (folder.glob("*.md") if folder == ROOT else folder.rglob("*.md"))})
anchors = {page: {anchor(h) for h in re.findall(r"^#+ (.*)$", text_of(page), flags=re.M)} for page in pages}
faults = []
for page in pages:
    for target in re.findall(r"\]\(([^)\s]+)\)", text_of(page)):
        if re.match(r"[a-z]+:", target):
            continue
        name, _, place = target.partition("#")
        file = (page.parent / name).resolve() if name else page
        if not file.exists():
            faults.append(f"{page.relative_to(ROOT)}: {target} leads nowhere")
        elif place and file in anchors and place not in anchors[file]:
            faults.append(f"{page.relative_to(ROOT)}: {target} names no heading")

named = re.findall(r": (\S+\.md)$", (ROOT / "packaging/mkdocs.yml").read_text(), flags=re.M)
faults += [f"packaging/mkdocs.yml: {name} is no page" for name in named if not (ROOT / name).exists()]
faults += [f"packaging/mkdocs.yml: {page.relative_to(ROOT)} is missing"
           for page in (ROOT / "docs").glob("*.md") if str(page.relative_to(ROOT)) not in named]
if len(pages) < 20 or not named:
    faults.append("too few pages found to be right")
sys.exit("\n".join(faults) or 0)
