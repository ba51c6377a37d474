#pragma once
// MPI from its start to its end.
#include "ranks/ranks.hpp"

namespace vug {

/// Starts MPI and ends it. There must be one of these, around everything that computes. In a build without MPI there is
/// one rank.
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

/// Number of ranks on this machine, including this one, that may use the same processors as this one: all of them, or
/// those of a core, a socket or whatever the launcher has bound it to. Called by all ranks.
int ranks_on_these_processors(const Ranks& ranks);

/// Waits some seconds on all ranks but the first. An error in a case or a command line occurs on every rank; the first
/// one can thus report it and end all, if it does, or the launcher ends the others when the first one has ended.
void let_first_end(bool first);

/// Ends every rank with an exit code, also those that wait for this one. Returns if there is no other.
void end_all_ranks(const Ranks& ranks, int code);

/// MPI library of the build, for instance "Open MPI v4.1.4" or "MPICH 4.0.2"; "none" without MPI.
std::string mpi_library();

/// Whether messages may be in the memory of Views: on a host always; on a device where MPI reports this and a message
/// of this process to itself, sent at the first call, has confirmed it.
bool takes_device_memory();

/// Number of processes started together, according to the environment; 1 where it does not say.
int processes_started();
/// Whether this one is the first of them.
bool started_first();

/// Number of processes that Slurm's srun has started together without anything by which MPI could find the others; 1
/// otherwise.
int processes_that_mpi_does_not_know();

}  // namespace vug
