"""A program whose libraries come from folders that a module has added starts where cmake --install has put it, and names
none of these folders where it is packed for elsewhere; what is packed where, and that a program for another processor is not
started. Tried with a project in miniature that has this one's cmake/install.cmake."""
import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
LIBRARY = """cmake_minimum_required(VERSION 3.25)
project(thing LANGUAGES C)
add_library(thing SHARED thing.c)
install(TARGETS thing)
"""
PROGRAM = f"""cmake_minimum_required(VERSION 3.25)
project(vug VERSION 0.1.0 LANGUAGES C)
add_executable(vug main.c)
find_library(thing thing REQUIRED)
target_link_libraries(vug PRIVATE ${{thing}})
include("{ROOT}/cmake/install.cmake")
"""


def call(*words):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, words))}: ended with {done.returncode}: {done.stdout}{done.stderr}")
    return done.stdout


with tempfile.TemporaryDirectory() as folder:
    folder = pathlib.Path(folder)
    module, source = folder / "module", folder / "vug"
    for place in (folder / "thing", source):
        place.mkdir()
    (folder / "thing/CMakeLists.txt").write_text(LIBRARY)
    (folder / "thing/thing.c").write_text("int thing(void) { return 0; }\n")
    call("cmake", "-G", "Ninja", "-S", folder / "thing", "-B", folder / "thing/build", f"-DCMAKE_INSTALL_PREFIX={module}")
    call("cmake", "--build", folder / "thing/build", "--target", "install")
    for name in ("scripts", "python", "cases", "packaging", "docs", "README.md", "CHANGELOG.md", "CITATION.cff", "LICENSE"):
        (source / name).symlink_to(ROOT / name)
    (source / "CMakeLists.txt").write_text(PROGRAM)
    (source / "main.c").write_text("int thing(void);\nint main(void) { return thing(); }\n")

    def build(name, *options):
        """The path of the installed program, and the folder of the build."""
        binary, prefix = folder / name, folder / f"{name}-installed"
        call("cmake", "-G", "Ninja", "-S", source, "-B", binary, f"-DCMAKE_PREFIX_PATH={module}", "-DCMAKE_BUILD_TYPE=Release",
             *options)
        call("cmake", "--build", binary, "--target", "vug")
        call("cmake", "--install", binary, "--prefix", prefix)
        return prefix / "bin/vug", binary

    def starts(program):
        return subprocess.run([program], env={}, capture_output=True, check=False).returncode == 0

    def is_in_all(target, binary):
        return any(line.startswith("build all:") and target in line.split() for line in
                   (binary / "build.ninja").read_text().splitlines())

    usual, binary = build("usual")
    assert starts(usual), "the installed program does not find a library of a module"
    assert is_in_all("vug_pages", binary), "an installation lacks vug's own pages"

    presets = json.loads((ROOT / "CMakePresets.json").read_text())["configurePresets"]
    variables = next(one for one in presets if one["name"] == "package")["cacheVariables"]
    packed, _ = build("packed", *(f"-D{name}={value}" for name, value in variables.items()))
    assert not starts(packed) and str(module).encode() not in packed.read_bytes(), "a package names folders of this machine"

    _, binary = build("other", "-DCMAKE_SYSTEM_NAME=Linux", "-DCMAKE_SYSTEM_PROCESSOR=aarch64", "-DVUG_DPKG_SHLIBDEPS=NO")
    assert not is_in_all("vug_pages", binary), "a program for another processor is started when it is built"
    packing = (binary / "CPackConfig.cmake").read_text()
    assert 'set(CPACK_GENERATOR "TGZ")' in packing, "a .deb without the packages that it depends on"
    assert 'set(CPACK_PACKAGE_FILE_NAME "vug-0.1.0-Linux-aarch64")' in packing, "the tarball does not say for which processor it is"
print("installed, packed, and for another processor")
