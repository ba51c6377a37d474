"""Says which tests of a run of ctest were skipped, and why: skipped.py JUNIT.xml SKIPS.txt.

Ends with 1 where SKIPS.txt ("Name: where", a line each) does not have one of them.
"""
import pathlib
import re
import sys
import xml.etree.ElementTree


def reason(case):
    """What the test said of it: GoogleTest on the line after "Skipped", others with a word of their own."""
    said = case.findtext("system-out") or ""
    found = re.search(r": Skipped\n(.+)", said) or re.search(r"(?i)\bskipped: (.+)", said)
    return found[1].strip() if found else "without a word"


def main(junit, skips):
    allowed = {line.split(":")[0] for line in pathlib.Path(skips).read_text().splitlines() if not line.startswith("#")}
    skipped = {case.get("name"): reason(case) for case in xml.etree.ElementTree.parse(junit).iter("testcase")
               if case.find("skipped") is not None}
    for name, why in skipped.items():
        print(f"skipped: {name} ({why})" + ("" if name in allowed else f", which {skips} does not have"))
    return int(not skipped.keys() <= allowed)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
