"""Every mutant that scripts/mutation names stands in the code as it is now, and every file of laws is there."""
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))
sys.dont_write_bytecode = True
from mutation.mutants import LAWS, all_mutants, equivalent  # noqa: E402

mutants, stale = all_mutants(ROOT)
names = [mutant.name for mutant in mutants]
faults = [f"named.txt: {name} does not stand in its file once" for name in stale]
faults += [f"named.txt or mutants.py: two mutants have the name {name}" for name in sorted(set(names)) if names.count(name) > 1]
faults += [f"equivalent.txt: there is no mutant {name}" for name in sorted(equivalent(ROOT) - set(names))]
faults += [f"mutants.py: there is no file src/{library}/{file}"
           for library, files in LAWS.items() for file in files.split() if not (ROOT / "src" / library / file).exists()]
if len(names) < 1000:
    faults.append("too few mutants found to be right")
sys.exit("\n".join(f"scripts/mutation/{fault}" for fault in faults) or 0)
