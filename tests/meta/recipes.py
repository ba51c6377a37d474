"""The syntax of the recipes in packaging/: what can be said of them without Spack and conda."""
import ast
import importlib.metadata
import pathlib
import re
import sys
import tomllib

ROOT = pathlib.Path(__file__).resolve().parents[2] / "packaging"
VERSION = re.search(r"project\(vug VERSION (\S+)", (ROOT.parent / "CMakeLists.txt").read_text()).group(1)

tree = ast.parse((ROOT / "spack/package.py").read_text())
assert [node.name for node in tree.body if isinstance(node, ast.ClassDef)] == ["Vug"]

recipe = re.sub(r"\{\{.*?\}\}", "compiler", (ROOT / "conda/meta.yaml").read_text())
assert f'version: "{VERSION}"' in recipe, f"the recipe for conda is not of version {VERSION}"
try:
    import yaml
except ImportError:
    print("PyYAML is not installed: the recipe for conda was not parsed")
else:
    assert set(yaml.safe_load(recipe)) >= {"package", "source", "build", "requirements", "test", "about"}

project = tomllib.loads((ROOT.parent / "pyproject.toml").read_text())["project"]
assert project["version"] == VERSION, f"pyproject.toml is not of version {VERSION}"
for need in sum(project["optional-dependencies"].values(), project["dependencies"]):  # no more than what the tests run with
    name, _, least = need.partition(">=")
    here = importlib.metadata.version(name) if least else ""
    if [int(part) for part in re.findall(r"\d+", here)] < [int(part) for part in re.findall(r"\d+", least)]:
        sys.exit(f"pyproject.toml: asks for {need}, and the tests pass with {here}")

words = {line.split()[0] for line in (ROOT / "Containerfile").read_text().replace("\\\n", " ").splitlines()
         if line and not line.startswith("#")}
if not words <= {"FROM", "ARG", "ENV", "RUN", "COPY", "WORKDIR", "ENTRYPOINT"}:
    sys.exit(f"packaging/Containerfile: unknown words in {words}")
# What was built here must not travel into a container: podman reads the one name, docker the other.
for name in (".containerignore", ".dockerignore"):
    kept_out = set((ROOT.parent / name).read_text().split())
    assert {"build", ".deps", "runs"} <= kept_out, f"{name} lets what was built here into a container: it has {kept_out}"
