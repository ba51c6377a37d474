#include "ranks/mpi.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <string_view>
#include <thread>
#include <unistd.h>

#ifdef VUG_MPI
#include <mpi.h>
#endif

namespace vug {

void let_first_end(const Ranks& ranks) {
  constexpr std::chrono::seconds patience(5);
  if (!ranks.first()) std::this_thread::sleep_for(patience);
}

std::string machine_name() {
  char name[256] = "";
  gethostname(name, sizeof(name) - 1);
  return name;
}

int processes_started() {
  const char* const by_slurm = std::getenv("PMIX_RANK") ? "SLURM_STEP_NUM_TASKS" : "PMIX_SIZE";
  for (const char* variable : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MV2_COMM_WORLD_SIZE", by_slurm})
    if (const char* text = std::getenv(variable)) {
      const std::string_view value(text);
      int count = 1;
      std::from_chars(value.data(), value.data() + value.size(), count);
      return count;
    }
  return 1;
}

#ifdef VUG_MPI

Mpi::Mpi() {
  int level = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &level);
  int rank = 0, size = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  world_ = Ranks(rank, size);
  MPI_Comm machine;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
  MPI_Comm_size(machine, &beside_);
  MPI_Comm_free(&machine);
}

Mpi::~Mpi() {
  MPI_Finalize();
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
  for (const std::string_view filling : {" Version:", "\t"})  // of MPICH
    if (const auto at = name.find(filling); at != std::string::npos)
      name.replace(at, filling.size(), filling == "\t" ? " " : "");
  return name;
}

#else

Mpi::Mpi() = default;
Mpi::~Mpi() = default;
void end_all_ranks(const Ranks&, int) {}
std::string mpi_library() {
  return "none";
}

#endif

}  // namespace vug
