# A recipe for Spack: put it into packages/vug/ of a repository of your own (spack repo create). Its syntax is checked by the
# tests; it has not been built by Spack.
from spack.package import *


class Vug(CMakePackage):
    """Rock that dissolves and fractures while hot and cold fluid is pushed through it: lattice Boltzmann for flow, heat and
    solutes, bonded discrete elements for the rock."""

    license("BSD-3-Clause")

    version("main", branch="main", git="file:///srv/git/vug.git")  # where your copy of the project lies

    variant("openmp", default=True, description="Threads by OpenMP")
    variant("cuda", default=False, description="GPUs of NVIDIA")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("ninja", type="build")
    depends_on("kokkos@5: +serial")
    depends_on("kokkos +openmp", when="+openmp")
    depends_on("kokkos +cuda", when="+cuda")
    depends_on("hdf5 +hl~mpi")
    depends_on("eigen@3.4:")
    depends_on("fmt@9:")
    depends_on("fmt@9:10", when="+cuda")
    depends_on("tomlplusplus@3:")
    depends_on("cli11@2:")
    depends_on("libpng")
    depends_on("libtiff@4:")
    depends_on("zlib-api")
    depends_on("boost@1.74:")
    depends_on("python@3.11:", type="run")
    depends_on("py-numpy", type="run")
    depends_on("py-h5py", type="run")
    depends_on("py-matplotlib", type="run")

    generator("ninja")

    def cmake_args(self):
        backend = "CUDA" if "+cuda" in self.spec else "OPENMP" if "+openmp" in self.spec else "SERIAL"
        return [
            self.define("VUG_BACKEND", backend),
            self.define("VUG_TESTS", False),
            self.define("VUG_NATIVE", False),
            self.define("Kokkos_ROOT", self.spec["kokkos"].prefix),
        ]
