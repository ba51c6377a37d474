"""Every link of every page leads somewhere, every test and file of the tests that a page names is there, and the site
(packaging/mkdocs.yml) has every page of docs/."""
import fnmatch
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


def tests_there():
    """The names of all tests, by suite."""
    there = {}
    for source in (ROOT / "tests").rglob("*.[ch]pp"):
        for suite, name in re.findall(r"\bTEST(?:_F|_P)?\(\s*(\w+),\s*(\w+)\)", source.read_text().replace("TYPED_", "")):
            there.setdefault(suite, set()).add(name)
    for name in re.findall(r"add_test\(NAME (\w+)", (ROOT / "tests/CMakeLists.txt").read_text()):
        there.setdefault(name, set())
    return there


def tests_named(text):
    """What stands for a suite or test: behind "Tests:", in the column "test" of a table, and Suite.Name anywhere."""
    stretches = re.findall(r"^(?:- )?Tests?: (.*?)(?=\n\n|\n- |\Z)", text, flags=re.M | re.S)
    for table in re.findall(r"(?:^\|.*\n)+", text, flags=re.M):
        rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in table.splitlines()]
        stretches += [row[k] for row in rows for k, head in enumerate(rows[0]) if head in ("test", "tests", "Test(s)")]
    names = {name for stretch in stretches for name in re.findall(r"`([^`]+)`", stretch)}
    return names | set(re.findall(r"`([A-Z]\w*[a-z]\w*\.(?:[A-Z]\w*|\*))`", text))


def is_there(name, there):
    if name.endswith(".cpp"):
        return any((ROOT / "tests").rglob(name))
    suite, _, test = name.split("/")[-1].partition(".")  # an instance stands before the name of its suite
    return any(fnmatch.fnmatchcase(s, suite) and (test in ("", "*") or test in names) for s, names in there.items())


pages = sorted({page for folder in FOLDERS for page in (folder.glob("*.md") if folder == ROOT else folder.rglob("*.md"))})
anchors = {page: {anchor(h) for h in re.findall(r"^#+ (.*)$", text_of(page), flags=re.M)} for page in pages}
faults = []
tests, named_tests = tests_there(), 0
for page in pages:
    names = tests_named(text_of(page))
    named_tests += len(names)
    faults += [f"{page.relative_to(ROOT)}: there is no test {name}" for name in sorted(names) if not is_there(name, tests)]
    faults += [f"{page.relative_to(ROOT)}: there is no {name}" for name in re.findall(r"`(tests/[\w/.*-]+)`", text_of(page))
               if not any(ROOT.glob(name.rstrip("/")))]
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
if len(pages) < 20 or not named or named_tests < 100:
    faults.append("too few pages found to be right")
sys.exit("\n".join(faults) or 0)
