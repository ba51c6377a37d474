#include "dem/monitors.hpp"

#include <limits>

namespace vug {

namespace {

KOKKOS_FORCEINLINE_FUNCTION double speed_of(const Particles& p, int i) {
  return norm({p.v(i, 0), p.v(i, 1)}) + Kokkos::abs(p.spin(i)) * Kokkos::sqrt(p.inertia(i) / p.mass(i));
}

/// Smallest number of a particle whose motion fails the comparison (NaN fails every comparison).
struct FindRunaway {
  double largest_speed;
  Particles p;
  KOKKOS_FUNCTION void operator()(int i, int& first) const {
    const bool sane = speed_of(p, i) <= largest_speed && Kokkos::isfinite(p.u(i, 0)) && Kokkos::isfinite(p.u(i, 1));
    if (!sane && i < first) first = i;
  }
};

struct LargestWarming {
  Particles p;
  KOKKOS_FUNCTION void operator()(int i, double& largest) const {
    largest = Kokkos::fmax(largest, presence(p.solid_fraction(i)) * Kokkos::abs(p.warming(i)));
  }
};

/// Speed of a particle (see RunawayParticle), read on the host.
struct SpeedOf {
  Particles p;
  int particle;
  KOKKOS_FUNCTION void operator()(int, double& speed) const {
    const int i = particle;
    const bool placed = Kokkos::isfinite(p.u(i, 0)) && Kokkos::isfinite(p.u(i, 1));
    speed += placed ? speed_of(p, i) : Kokkos::Experimental::quiet_NaN_v<double>;
  }
};

}  // namespace

RunawayParticle find_runaway(const Exec& exec, const Particles& particles, double largest_speed) {
  int first = std::numeric_limits<int>::max();
  Kokkos::parallel_reduce("vug::dem::find_runaway", Kokkos::RangePolicy<Exec>(exec, 0, particles.count),
                          FindRunaway{largest_speed, particles}, Kokkos::Min<int>(first));
  if (first >= particles.count) return {};
  double speed = 0;
  Kokkos::parallel_reduce("vug::dem::runaway_speed", Kokkos::RangePolicy<Exec>(exec, 0, 1), SpeedOf{particles, first},
                          speed);
  return {first, speed};
}

BondCounts count_bonds(const Bonds& bonds) {
  const auto state = on_host(bonds.state);
  const auto d_m = on_host(bonds.d_m);
  BondCounts counts;
  for (int k = 0; k < bonds.count; ++k) {
    counts.damaged += d_m(k) > 0 && !has_failed(state(k));
    counts.failed_in_tension += state(k) == BondState::failed_in_tension;
    counts.failed_in_shear += state(k) == BondState::failed_in_shear;
    counts.dissolved += state(k) == BondState::dissolved;
    counts.cracked_at_start += state(k) == BondState::cracked_at_start;
  }
  return counts;
}

double largest_thermal_strain(const Exec& exec, const Particles& particles, double expansion) {
  double warming = 0;
  Kokkos::parallel_reduce("vug::dem::largest_warming", Kokkos::RangePolicy<Exec>(exec, 0, particles.count),
                          LargestWarming{particles}, Kokkos::Max<double>(warming));
  return particles.count > 0 ? expansion * warming : 0;
}

Vec2 reaction_of(const std::vector<int>& held_particles, const Particles& particles) {
  const auto reaction = on_host(particles.reaction);
  Vec2 sum;
  for (const int i : held_particles) sum = sum + Vec2{reaction(i, 0), reaction(i, 1)};
  return sum;
}

}  // namespace vug
