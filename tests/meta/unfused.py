"""No kernel and no coupling multiplies and adds with one rounding (cmake/compile_options.cmake): the last digits of a node
or a bond must not depend on the loop, the block or the rank that it is in.

  unfused.py LIBRARY ...   static libraries, disassembled by objdump; x86-64 and 64-bit ARM
"""
import re
import shutil
import subprocess
import sys

FUSED = re.compile(r"\t(vfn?m(?:add|sub)\w*|fn?m(?:add|sub|la|ls))\b")
# von Neumann's analysis by Eigen, which fuses by itself; it says where schemes are stable and is in no step
EXCEPTIONS = {"plane_waves.cpp.o"}

if not shutil.which("objdump"):
    sys.exit("unfused.py: objdump is missing (binutils)")
found, lines = {}, 0
for library in sys.argv[1:]:
    listing = subprocess.run(["objdump", "--disassemble", "--no-show-raw-insn", library], capture_output=True, text=True, check=True)
    member = function = ""
    for line in listing.stdout.splitlines():
        lines += 1
        if ":     file format" in line:
            member = line.split(":")[0]
        elif line.endswith(">:"):
            function = line.split("<", 1)[1][:-2]
        elif member not in EXCEPTIONS and (fused := FUSED.search(line)):
            found.setdefault(f"{member}: {function}", fused[1])
for place, instruction in sorted(found.items()):
    print(f"unfused.py: {instruction} in {place}")
if lines < 10000:
    sys.exit(f"unfused.py: {lines} lines of machine code in {len(sys.argv) - 1} libraries: what was built?")
sys.exit(1 if found else 0)
