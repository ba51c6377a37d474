"""A copy of the project in which every mutant sleeps until the environment names it: one build for all."""
import os
import pathlib
import re
import shutil
import subprocess

HEADER = """\
#pragma once
// Mutants: what is wrong where VUG_MUTANT says so.
#include <Kokkos_Core.hpp>
#include <cstdlib>
#include <type_traits>
namespace vug::mutants {
inline int named() {
  const char* text = std::getenv("VUG_MUTANT");
  return text ? std::atoi(text) : 0;
}
inline const int active = named();
KOKKOS_FORCEINLINE_FUNCTION constexpr bool on(int n) { return !std::is_constant_evaluated() && active == n; }
template <class V>
KOKKOS_FORCEINLINE_FUNCTION constexpr V flip(int n, V v) {
  if constexpr (requires { V(-v); }) return on(n) ? V(-v) : v;
  else return on(n) ? V(-1.0 * v) : v;
}
template <class V>
KOKKOS_FORCEINLINE_FUNCTION constexpr V invert(int n, V v) {
  if constexpr (requires { V(v / (v * v)); }) return on(n) ? V(v / (v * v)) : v;
  else return flip(n, v);
}
template <class V>
KOKKOS_FORCEINLINE_FUNCTION constexpr V twice(int n, V v) { return on(n) ? V(v + v) : v; }
template <class V>
KOKKOS_FORCEINLINE_FUNCTION constexpr V zero(int n, V v) { return on(n) ? V(0) : v; }
KOKKOS_FORCEINLINE_FUNCTION constexpr int swap(int n, int v) { return on(n) ? 1 - v : v; }
template <class C>
KOKKOS_FORCEINLINE_FUNCTION constexpr bool deny(int n, const C& c) { return on(n) != static_cast<bool>(c); }
}  // namespace vug::mutants
"""

# Where mutants may be: half the time of a build with -O3, and the small functions of Kokkos inlined all the same. What is
# built elsewhere has the options, and with a cache of compiled files the objects, of the ordinary build.
QUICK = "add_compile_options(-O1 -finline-small-functions -findirect-inlining -fpartial-inlining -Wno-error)\n"
WITH_MUTANTS = ("src/kernels", "src/dem", "src/coupling", "src/io", "src/study", "tests")


def instrument(text, mutants):
    """The text with its (number, mutant) in it, every line one further down: the first includes what they call."""
    marks = []  # (position, 0 closes or 1 opens, nesting, text)
    for number, m in mutants:
        size = m.end - m.start
        if m.kind != "replace":
            marks.append((m.start, 1, -size, f"::vug::mutants::{m.kind}({number}, "))
            marks.append((m.end, 0, size, ")"))
        elif "@ON" in m.text:  # says itself where it wakes: what stands there is left out
            marks.append((m.start, 1, -size, m.text.replace("@ON", f"::vug::mutants::on({number})") + " /*"))
            marks.append((m.end, 0, size, "*/"))
        elif text[m.start:m.end].endswith(";"):
            new = m.text.replace("\n", " ")
            marks.append((m.start, 1, -size, f"{{ if (::vug::mutants::on({number})) {{ {new} }} else {{ "))
            marks.append((m.end, 0, size, " } }"))
        else:
            new = m.text.replace("\n", " ")
            marks.append((m.start, 1, -size, f"(::vug::mutants::on({number}) ? ({new}) : ("))
            marks.append((m.end, 0, size, "))"))
    for position, _, _, mark in sorted(marks, key=lambda m: m[:3], reverse=True):
        text = text[:position] + mark + text[position:]
    return '#include "mutants.hpp"\n' + text


def write(path, text):
    if not path.exists() or path.read_text() != text:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


def copy_project(root, folder, mutants):
    """Tracked and new files of the project with the mutants in them; what has not changed keeps its date."""
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=root, capture_output=True, text=True, check=True)
    wanted = {name for name in listed.stdout.splitlines() if (root / name).is_file()}
    of_file = {}
    for number, mutant in mutants:
        of_file.setdefault("src/" + mutant.path, []).append((number, mutant))
    for name in sorted(wanted):
        if name in [f"{part}/CMakeLists.txt" for part in WITH_MUTANTS]:
            write(folder / name, QUICK + (root / name).read_text())
        elif name in of_file:
            write(folder / name, instrument((root / name).read_text(), of_file[name]))
        elif not (folder / name).exists() or (folder / name).read_bytes() != (root / name).read_bytes():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(root / name, folder / name)
    write(folder / "src/mutants.hpp", HEADER)
    if (root / ".deps").exists() and not (folder / ".deps").exists():
        (folder / ".deps").symlink_to((root / ".deps").resolve())


def configure(folder, options):
    subprocess.run(["cmake", "--preset", "openmp", *options], cwd=folder, check=True, stdout=subprocess.DEVNULL)


def faults(folder, log):
    """{(path below src, line)} of what does not compile."""
    found = set()
    source = re.escape(str(folder)) + r"/src/|(?:\.\./)+src/"
    for match in re.finditer(rf"(?:{source})([\w/.]+):(\d+)", log):
        found.add((match.group(1), int(match.group(2)) - 1))  # the included line comes before
    return found


def build(root, folder, mutants, targets, jobs, options):
    """Builds the copy. Returns the numbers of those mutants that are no C++, without which it was built."""
    known = folder / "refused.txt"  # by an earlier build
    names = set(known.read_text().split()) if known.exists() else set()
    refused = {n for n, m in mutants if m.name in names}
    for _ in range(12):
        kept = [(n, m) for n, m in mutants if n not in refused]
        copy_project(root, folder, kept)
        configure(folder, options)
        command = ["cmake", "--build", "build/openmp", f"-j{jobs}", "--target", *targets, "--", "-k", "0"]
        run = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
        if run.returncode == 0:
            known.write_text("".join(f"{name}\n" for name in sorted(names | {m.name for n, m in mutants if n in refused})))
            return refused
        log = run.stdout + run.stderr
        wrong = set()
        for text in re.split(r"\n(?=FAILED)", log):
            errors = re.findall(r"^(.*?): error:.*$", text, re.MULTILINE)
            wrong |= faults(folder, "\n".join(errors) + "\n" + "\n".join(re.findall(r"^.*required from.*$", text, re.MULTILINE)))
        new = {n for n, m in kept for line in lines_of(root, m) if (m.path, line) in wrong}
        print(f"mutate: {len(new)} are no C++", flush=True)
        if not new:
            pathlib.Path(folder, "build.log").write_text(log)
            raise SystemExit(f"mutate: the build failed; see {folder}/build.log")
        refused |= new
    raise SystemExit("mutate: the build still fails after twelve attempts")


def lines_of(root, mutant):
    text = (root / "src" / mutant.path).read_text()
    return range(text.count("\n", 0, mutant.start) + 1, text.count("\n", 0, mutant.end) + 2)


def environment(number):
    return os.environ | {"VUG_MUTANT": str(number), "OMP_PROC_BIND": "false", "OMP_NUM_THREADS": "1", "OMP_WAIT_POLICY": "passive"}
