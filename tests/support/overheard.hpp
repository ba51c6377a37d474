#pragma once
// Listening to what Kokkos tells its tools, without anybody else missing it.
#include <Kokkos_Core.hpp>

#include <cstdint>

namespace vug::test {

/// While one lives callbacks may be set, which hand on what they hear: separate memory (tests/separate_memory) is open
/// while kernels and copies run. At its end callbacks are what they were.
class Overheard {
 public:
  Overheard() = default;
  ~Overheard() { Kokkos::Tools::Experimental::set_callbacks(before_); }
  Overheard(const Overheard&) = delete;
  Overheard& operator=(const Overheard&) = delete;

  /// Of a kernel, whether loop, sum or scan: all are told alike.
  void launched(const char* label, std::uint32_t device, std::uint64_t* id) const {
    if (before_.begin_parallel_for) before_.begin_parallel_for(label, device, id);
  }
  void region_began(const char* label) const {
    if (before_.push_region) before_.push_region(label);
  }
  void copied(Kokkos::Profiling::SpaceHandle to, const char* target, const void* at,
              Kokkos::Profiling::SpaceHandle from, const char* source, const void* of, std::uint64_t size) const {
    if (before_.begin_deep_copy) before_.begin_deep_copy(to, target, at, from, source, of, size);
  }

 private:
  Kokkos::Tools::Experimental::EventSet before_ = Kokkos::Tools::Experimental::get_callbacks();
};

}  // namespace vug::test
