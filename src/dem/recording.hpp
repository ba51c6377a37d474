#pragma once
// Kernels that run repeatedly: recorded once, then sent to the device as one launch.
#include "base/base.hpp"

#include <Kokkos_Graph.hpp>
#include <Kokkos_Profiling_ScopedRegion.hpp>

#include <string>

namespace vug {

/// A sequence of kernels with the arguments that they were recorded with. Values that change from one replay to the
/// next must be in Views.
class Recording {
 public:
  explicit Recording(const Exec& exec) : graph_(exec), last_(graph_.root_node()) {}

  template <class Policy, class Body>
  void add(const std::string& label, const Policy& policy, const Body& body) {
    last_ = last_.then_parallel_for(label, policy, body);
  }

  /// Runs all of them. Tools see a region of this label instead of the kernels. Nothing is fenced (except by Kokkos'
  /// graphs for hosts).
  void replay(const Exec& exec, const std::string& label) const {
    const Kokkos::Profiling::ScopedRegion region(label);
    graph_.submit(exec);
  }

 private:
  Kokkos::Experimental::Graph<Exec> graph_;
  Kokkos::Experimental::GraphNodeRef<Exec> last_;
};

/// Where a kernel goes: to the device at once, or to the end of a recording.
struct Queue {
  const Exec& exec;
  Recording* recording = nullptr;

  Queue(const Exec& at_once) : exec(at_once) {}
  Queue(const Exec& space, Recording& later) : exec(space), recording(&later) {}
};

}  // namespace vug
