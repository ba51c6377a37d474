#include "dem/rest.hpp"

#include "dem/bond_law.hpp"
#include "dem/gather_contacts.hpp"
#include "dem/push.hpp"

#include <algorithm>
#include <vector>

namespace vug {

namespace {

constexpr double asleep_below = 0.25;  // of the unrest that wakes: what has come to rest stays there for a while

Groups make_groups(const char* label, const std::vector<int>& first) {
  Groups groups{static_cast<int>(first.size()) - 1, IndexList(label, first.size()),
                Kokkos::View<std::uint8_t*>(label, first.size() - 1)};
  const auto host = Kokkos::create_mirror_view(groups.first);
  std::copy(first.begin(), first.end(), host.data());
  Kokkos::deep_copy(groups.first, host);
  Kokkos::deep_copy(groups.runs, std::uint8_t{1});
  return groups;
}

/// One group by one team: its largest unrest, then whether it is awake.
struct LookAtRest {
  using Team = typename Kokkos::TeamPolicy<Exec>::member_type;
  double wake_at, mass_scaling, per_step;  ///< N, 1, 1/s
  GatherContacts gather;
  ParticlePush push;
  Particles p;
  Groups groups;

  /// Along one axis or about the centroid; `push` and `momentum` over a length.
  KOKKOS_FORCEINLINE_FUNCTION double unrest(bool held, double force, double momentum) const {
    const double stop = Kokkos::abs(momentum) * per_step;
    return held ? stop : at_least(Kokkos::abs(force), stop);
  }
  KOKKOS_FUNCTION double unrest(int i) const {
    const Push all = push.total(i, push.outside(i));
    const double mass = mass_scaling * mass_fraction(p.solid_fraction(i)) * p.mass(i);
    const double gyration = Kokkos::sqrt(p.inertia(i) / p.mass(i));
    const int held = p.held(i);
    const double x = unrest((held & 1) != 0, all.x, mass * p.v(i, 0));
    const double y = unrest((held & 2) != 0, all.y, mass * p.v(i, 1));
    const double turn = unrest((held & 4) != 0, all.torque / gyration, mass * gyration * p.spin(i));
    return at_least(at_least(x, y), turn);
  }
  KOKKOS_FUNCTION void operator()(const Team& team) const {
    const int g = team.league_rank();
    const auto range = Kokkos::TeamThreadRange(team, groups.first(g), groups.first(g + 1));
    double most = 0;
    Kokkos::parallel_reduce(
        range,
        [&](int i, double& largest) {
          gather(i);
          largest = at_least(largest, unrest(i));
        },
        Kokkos::Max<double>(most));
    const bool was_awake = groups.runs(g) != 0;
    const bool wakes = !(most < (was_awake ? asleep_below : 1) * wake_at);
    team.team_barrier();
    Kokkos::single(Kokkos::PerTeam(team), [&] { groups.runs(g) = wakes ? 1 : 0; });
    if (wakes || !was_awake) return;
    Kokkos::parallel_for(range, [&](int i) { p.v(i, 0) = p.v(i, 1) = p.spin(i) = 0; });
  }
};

/// A group's bonds run when one of its particles or of those that they join may move. Counts the awake groups.
struct WakeBonds {
  Groups particles, bonds;
  IndexList reach;
  KOKKOS_FUNCTION void operator()(int g, int& awake) const {
    int runs = 0;
    for (int h = g; h <= reach(g); ++h) runs |= particles.runs(h);
    bonds.runs(g) = static_cast<std::uint8_t>(runs);
    awake += particles.runs(g);
  }
};

}  // namespace

Rest make_rest(const Particles& particles, const Bonds& bonds, const BondParameters& law, double tolerance) {
  const auto pair = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, bonds.pair);
  const auto length = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, bonds.length);
  const int count = (particles.count + particles_per_group - 1) / particles_per_group;
  std::vector<int> first_particle(count + 1), first_bond(count + 1, bonds.count), reach(count);
  for (int g = 0; g <= count; ++g) first_particle[g] = std::min(g * particles_per_group, particles.count);
  for (int g = 0; g < count; ++g) reach[g] = g;
  double sum = 0;
  for (int k = bonds.count - 1; k >= 0; --k) {
    const int low = pair(k, 0) / particles_per_group, high = pair(k, 1) / particles_per_group;
    std::fill(first_bond.begin(), first_bond.begin() + low + 1, k);
    reach[low] = std::max(reach[low], high);
    sum += length(k);
  }
  Rest rest;
  rest.wake_at = bonds.count == 0 ? 0 : tolerance * law.normal_strength * sum / bonds.count;
  rest.particles = make_groups("vug::dem::rest_particles", first_particle);
  rest.bonds = make_groups("vug::dem::rest_bonds", first_bond);
  rest.reach = IndexList("vug::dem::rest_reach", count);
  const auto host = Kokkos::create_mirror_view(rest.reach);
  std::copy(reach.begin(), reach.end(), host.data());
  Kokkos::deep_copy(rest.reach, host);
  rest.awake = count;
  return rest;
}

void look_at_rest(const Exec& exec, const StepControl& control, const Bonds& bonds, const Contacts& contacts,
                  const BoundaryLoads& loads, const Particles& particles, Rest& rest) {
  const LookAtRest look{rest.wake_at,
                        control.mass_scaling,
                        1 / control.dt,
                        {bonds, contacts, contacts.load, contacts.push},
                        {control.load_factor, control.surroundings, bonds, contacts, loads, particles},
                        particles,
                        rest.particles};
  constexpr int team = runs_on_host ? 1 : particles_per_group;
  Kokkos::parallel_for("vug::dem::look_at_rest", Kokkos::TeamPolicy<Exec>(exec, rest.particles.count, team), look);
  Kokkos::parallel_reduce("vug::dem::wake_bonds", Kokkos::RangePolicy<Exec>(exec, 0, rest.particles.count),
                          WakeBonds{rest.particles, rest.bonds, rest.reach}, rest.awake);
}

}  // namespace vug
