#pragma once
// MPI from its start to its end.
#include "ranks/ranks.hpp"

namespace vug {

/// Starts MPI and ends it; one of them, around all that computes. In a build without MPI there is one rank.
class Mpi {
 public:
  Mpi();
  ~Mpi();
  Mpi(const Mpi&) = delete;
  Mpi& operator=(const Mpi&) = delete;

  /// All processes that were started together.
  Ranks world() const { return world_; }

 private:
  Ranks world_;
};

/// How many ranks of this machine, this one among them, have the processors that this one may use: all of them, or
/// those of a core, a socket or whatever the launcher has bound it to. Called by all ranks.
int ranks_on_these_processors(const Ranks& ranks);

/// What is wrong with a case is wrong on every rank: waits for the first one to say so and to end all, if it does.
void let_first_end(const Ranks& ranks);

/// Ends every rank with an exit code, also those that wait for this one. Returns where there is no other.
void end_all_ranks(const Ranks& ranks, int code);

/// What was built in, for instance "Open MPI v4.1.4" or "MPICH 4.0.2"; "none".
std::string mpi_library();

/// Whether messages may lie in the memory of Views: on a host always; in a device's where MPI says so and has proved it
/// by a message that this process sent itself when it first asked.
bool takes_device_memory();

/// What the environment says of how many processes were started together; 1 where nobody did.
int processes_started();

/// How many processes Slurm's srun has started together without anything by which MPI could find the others; 1 where it
/// has not.
int processes_that_mpi_does_not_know();

}  // namespace vug
