#include "ranks/mpi.hpp"

#include "base/base.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <optional>
#include <sched.h>
#include <string_view>
#include <thread>
#include <unistd.h>
#include <vector>

#ifdef VUG_MPI
#include <mpi.h>
#ifdef OPEN_MPI
#include <mpi-ext.h>
#endif
#endif

namespace vug {

void let_first_end(bool first) {
  constexpr std::chrono::seconds patience(5);
  if (!first) std::this_thread::sleep_for(patience);
}

namespace {

/// Number in an environment variable, 1 where it is not a number; none where the variable is not set.
std::optional<int> number_of(const char* variable) {
  const char* const text = std::getenv(variable);
  if (!text) return std::nullopt;
  const std::string_view value(text);
  int count = 1;
  std::from_chars(value.data(), value.data() + value.size(), count);
  return count;
}

}  // namespace

int processes_started() {
  // PMIx, and on machines of Cray older Slurm, say the rank and leave the number to Slurm
  const bool slurm_counts = std::getenv("PMIX_RANK") || std::getenv("PALS_RANKID");
  const char* const by_slurm = slurm_counts ? "SLURM_STEP_NUM_TASKS" : "PMIX_SIZE";
  for (const char* variable : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MV2_COMM_WORLD_SIZE", by_slurm})
    if (const std::optional<int> count = number_of(variable)) return *count;
  return 1;
}

bool started_first() {
  if (processes_started() == 1) return true;
  for (const char* variable : {"OMPI_COMM_WORLD_RANK", "PMI_RANK", "MV2_COMM_WORLD_RANK", "PMIX_RANK", "PALS_RANKID"})
    if (const std::optional<int> rank = number_of(variable)) return *rank == 0;
  return true;
}

int processes_that_mpi_does_not_know() {
  if (processes_started() > 1) return 1;
  for (char** variable = environ; *variable; ++variable)
    for (const std::string_view of_launcher :
         {"PMI", "OMPI_COMM_WORLD_", "MV2_COMM_WORLD_"})  // also matches PMI2, PMIx
      if (std::string_view(*variable).starts_with(of_launcher)) return 1;
  return number_of("SLURM_STEP_NUM_TASKS").value_or(1);
}

#ifdef VUG_MPI

Mpi::Mpi() {
  int level = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &level);
  int rank = 0, size = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  world_ = Ranks(rank, size);
}

Mpi::~Mpi() {
  MPI_Finalize();
}

int ranks_on_these_processors(const Ranks& ranks) {
  if (ranks.alone()) return 1;
  cpu_set_t own;
  CPU_ZERO(&own);
  sched_getaffinity(0, sizeof own, &own);  // where that fails, all ranks have the same (empty) set
  MPI_Comm machine;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
  int beside = 1;
  MPI_Comm_size(machine, &beside);
  std::vector<cpu_set_t> all(static_cast<std::size_t>(beside));
  MPI_Allgather(&own, sizeof own, MPI_BYTE, all.data(), sizeof own, MPI_BYTE, machine);
  MPI_Comm_free(&machine);
  return static_cast<int>(
      std::count_if(all.begin(), all.end(), [&](const cpu_set_t& other) { return CPU_EQUAL(&own, &other); }));
}

namespace {

/// What MPI reports about itself, because a trial without support would end the process.
bool claims_device_memory() {
  bool claimed = false;
#ifdef MPIX_CUDA_AWARE_SUPPORT  // Open MPI
  claimed = claimed || MPIX_Query_cuda_support() != 0;
#endif
#ifdef OMPI_HAVE_MPI_EXT_ROCM
  claimed = claimed || MPIX_Query_rocm_support() != 0;
#endif
#ifdef MPIX_GPU_SUPPORT_CUDA  // MPICH
  for (const int kind : {MPIX_GPU_SUPPORT_CUDA, MPIX_GPU_SUPPORT_HIP}) {
    int supported = 0;
    MPIX_GPU_query_support(kind, &supported);
    claimed = claimed || supported != 0;
  }
#endif
  return claimed;
}

struct CountRight {
  Kokkos::View<const int*> numbers;
  int wanted;
  KOKKOS_FUNCTION void operator()(int i, int& sum) const { sum += numbers(i) == wanted; }
};

/// Whether a message from memory of Views arrives in memory of Views.
bool proves_device_memory() {
  constexpr int count = 1000, number = 4711;
  const Kokkos::View<int*> out("vug::mpi::out", count), in("vug::mpi::in", count);
  Kokkos::deep_copy(out, number);
  Kokkos::fence("vug::mpi::proves_device_memory");
  MPI_Sendrecv(out.data(), count, MPI_INT, 0, 0, in.data(), count, MPI_INT, 0, 0, MPI_COMM_SELF, MPI_STATUS_IGNORE);
  int right = 0;
  Kokkos::parallel_reduce("vug::mpi::count_right", Kokkos::RangePolicy<Exec>(0, count), CountRight{in, number}, right);
  return right == count;
}

}  // namespace

bool takes_device_memory() {
  if constexpr (runs_on_host) return true;
  static const bool takes = claims_device_memory() && proves_device_memory();
  return takes;
}

void end_all_ranks(const Ranks& ranks, int code) {
  if (!ranks.alone()) MPI_Abort(MPI_COMM_WORLD, code);
}

std::string mpi_library() {
  char text[MPI_MAX_LIBRARY_VERSION_STRING];
  int length = 0;
  MPI_Get_library_version(text, &length);
  std::string name(text, length);
  name.resize(std::min(name.size(), name.find_first_of(",\n")));
  for (const std::string_view filling : {" Version:", "\t"})  // from MPICH
    if (const auto at = name.find(filling); at != std::string::npos)
      name.replace(at, filling.size(), filling == "\t" ? " " : "");
  return name;
}

#else

Mpi::Mpi() = default;
Mpi::~Mpi() = default;
int ranks_on_these_processors(const Ranks&) {
  return 1;
}
bool takes_device_memory() {
  return true;
}
void end_all_ranks(const Ranks&, int) {}
std::string mpi_library() {
  return "none";
}

#endif

}  // namespace vug
