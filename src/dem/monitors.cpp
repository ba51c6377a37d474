#include "dem/monitors.hpp"

#include <limits>

namespace vug {

namespace {

/// Smallest number of a particle whose motion fails the comparison (NaN fails every comparison).
struct FindRunaway {
  double largest_speed;
  Particles p;
  KOKKOS_FUNCTION void operator()(int i, int& first) const {
    const double speed = norm({p.v(i, 0), p.v(i, 1)}) + Kokkos::abs(p.spin(i)) * Kokkos::sqrt(p.inertia(i) / p.mass(i));
    const bool sane = speed <= largest_speed && Kokkos::isfinite(p.u(i, 0)) && Kokkos::isfinite(p.u(i, 1));
    if (!sane && i < first) first = i;
  }
};

}  // namespace

RunawayParticle find_runaway(const Exec& exec, const Particles& particles, double largest_speed) {
  int first = std::numeric_limits<int>::max();
  Kokkos::parallel_reduce("vug::dem::find_runaway", Kokkos::RangePolicy<Exec>(exec, 0, particles.count),
                          FindRunaway{largest_speed, particles}, Kokkos::Min<int>(first));
  if (first >= particles.count) return {};
  const auto v = on_host(particles.v);
  return {first, norm({v(first, 0), v(first, 1)})};
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

Vec2 reaction_of(const std::vector<int>& held_particles, const Particles& particles) {
  const auto reaction = on_host(particles.reaction);
  Vec2 sum;
  for (const int i : held_particles) sum = sum + Vec2{reaction(i, 0), reaction(i, 1)};
  return sum;
}

}  // namespace vug
