"""Every mutant that scripts/mutation names stands in the code as it is now, every file of laws is there, and every file
that looks like one is listed as one or as none."""
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))
sys.dont_write_bytecode = True
from mutation.build import WITH_MUTANTS  # noqa: E402
from mutation.mutants import FEW, LAWS, NO_LAWS, all_mutants, equivalent, generated  # noqa: E402
from mutation.suite import SUITES  # noqa: E402

mutants, stale = all_mutants(ROOT)
names = [mutant.name for mutant in mutants]
faults = [f"named.txt: {name} does not stand in its file once" for name in stale]
faults += [f"named.txt or mutants.py: two mutants have the name {name}" for name in sorted(set(names)) if names.count(name) > 1]
faults += [f"equivalent.txt: there is no mutant {name}" for name in sorted(equivalent(ROOT) - set(names))]
faults += [f"mutants.py: there is no file src/{library}/{file}"
           for lists in (LAWS, NO_LAWS) for library, files in lists.items() for file in files.split()
           if not (ROOT / "src" / library / file).exists()]
faults += [f"mutants.py: {library}/{file} is in both lists" for library, files in NO_LAWS.items() for file in files.split()
           if file in LAWS[library].split()]
libraries = sorted({mutant.library for mutant in mutants} | set(LAWS))
faults += [f"build.py: mutants of src/{library} are built with all options" for library in libraries
           if f"src/{library}" not in WITH_MUTANTS]
faults += [f"suite.py: no tests look for mutants of src/{library}" for library in libraries if library not in SUITES]
for library, files in LAWS.items():
    folder, listed = ROOT / "src" / library, {*files.split(), *NO_LAWS[library].split()}
    for path in sorted(folder.rglob("*.[ch]pp")):
        file = path.relative_to(folder).as_posix()
        if file not in listed and len(list(generated(f"{library}/{file}", path.read_text()))) >= FEW:
            faults.append(f"mutants.py: src/{library}/{file} could be wrong on {FEW} lines and is in neither list")
if len(names) < 1000:
    faults.append("too few mutants found to be right")
sys.exit("\n".join(f"scripts/mutation/{fault}" for fault in faults) or 0)
