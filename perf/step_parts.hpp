#pragma once
// The time that kernels take by the part of a coupled step that they belong to, from the callbacks of Kokkos.
#include "base/base.hpp"

#include <array>
#include <cstdint>
#include <cstring>

namespace vug::perf {

enum Part : int { flow, heat, carried, solutes, reaction, fluid_force, mechanics, pores, part_count };
inline constexpr std::array<const char*, part_count> part_names{"flow",     "heat",        "advective_form", "solutes",
                                                                "reaction", "fluid_force", "mechanics",      "pores"};

/// Seconds and launches of the kernels that run while one exists; kernels of no part are left out.
class PartClock {
 public:
  struct Share {
    double seconds = 0;
    double launches = 0;
  };

  PartClock() {
    running_ = this;
    using namespace Kokkos::Tools::Experimental;
    set_begin_parallel_for_callback(begin);
    set_begin_parallel_reduce_callback(begin);
    set_begin_parallel_scan_callback(begin);
    set_end_parallel_for_callback(end);
    set_end_parallel_reduce_callback(end);
    set_end_parallel_scan_callback(end);
  }
  ~PartClock() {
    using namespace Kokkos::Tools::Experimental;
    set_begin_parallel_for_callback(nullptr);
    set_begin_parallel_reduce_callback(nullptr);
    set_begin_parallel_scan_callback(nullptr);
    set_end_parallel_for_callback(nullptr);
    set_end_parallel_reduce_callback(nullptr);
    set_end_parallel_scan_callback(nullptr);
  }
  PartClock(const PartClock&) = delete;
  PartClock& operator=(const PartClock&) = delete;

  const Share& operator[](int part) const { return share_[static_cast<std::size_t>(part)]; }

 private:
  /// The part that a label names after "vug::"; part_count when it is none.
  static int part_of(const char* label) {
    struct Prefix {
      const char* text;
      int part;
    };
    static constexpr Prefix prefixes[] = {{"vug::flow", flow},
                                          {"vug::open_boundary", flow},
                                          {"vug::heat", heat},
                                          {"vug::advective_form", carried},
                                          {"vug::solute", solutes},
                                          {"vug::reactive_wall::react", solutes},
                                          {"vug::reacti", reaction},
                                          {"vug::surface_normal", reaction},
                                          {"vug::momentum_exchange", fluid_force},
                                          {"vug::wet_nodes", fluid_force},
                                          {"vug::dem", mechanics},
                                          {"vug::thermal_exchange", mechanics},
                                          {"vug::chemical_damage", mechanics},
                                          {"vug::dissolution", pores},
                                          {"vug::pathways", pores},
                                          {"vug::fluid_nodes", pores}};
    for (const Prefix& prefix : prefixes)
      if (std::strncmp(label, prefix.text, std::strlen(prefix.text)) == 0) return prefix.part;
    return part_count;
  }

  static void begin(const char* label, std::uint32_t, std::uint64_t* id) {
    *id = static_cast<std::uint64_t>(part_of(label));
    running_->timer_.reset();
  }
  static void end(std::uint64_t id) {
    if constexpr (!runs_on_host) Kokkos::fence();
    Share& share = running_->share_[id];
    share.seconds += running_->timer_.seconds();
    share.launches += 1;
  }

  std::array<Share, part_count + 1> share_{};
  Kokkos::Timer timer_;
  inline static PartClock* running_ = nullptr;
};

}  // namespace vug::perf
