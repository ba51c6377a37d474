#include "dem/rest.hpp"

#include "dem/bond_law.hpp"
#include "dem/gather_contacts.hpp"
#include "dem/push.hpp"
#include "kernels/launch/launch.hpp"

#include <algorithm>

namespace vug {

/// Unrest of a group: the largest unrest of a particle (`most`), the sum of the forces that would move the particles
/// (`x`, `y`) and the largest force of a bond (`borne`). += makes it usable in a reduction.
struct Unrest {
  double most = 0, x = 0, y = 0, borne = 0;
  KOKKOS_FORCEINLINE_FUNCTION Unrest& operator+=(const Unrest& other) {
    most = at_least(most, other.most);
    x += other.x;
    y += other.y;
    borne = at_least(borne, other.borne);
    return *this;
  }
  KOKKOS_FORCEINLINE_FUNCTION bool is_below(double force) const {
    return most < force && Kokkos::abs(x) < force && Kokkos::abs(y) < force;
  }
};

}  // namespace vug

template <>
struct Kokkos::reduction_identity<vug::Unrest> {
  KOKKOS_FORCEINLINE_FUNCTION static vug::Unrest sum() { return {}; }
};

namespace vug {

namespace {

constexpr double asleep_below = 0.25;  // of the unrest that wakes: rock that has come to rest stays so for a while
constexpr double least_borne = 0.1;  // of the force that breaks a bond: rock before its load must also be able to rest

Groups make_groups(const char* label, int count, int size) {
  Groups groups{count, size, Kokkos::View<std::uint8_t*>(label, (count + size - 1) / size), {}};
  Kokkos::deep_copy(groups.runs, std::uint8_t{1});
  return groups;
}

/// Computes the unrest of one group by one team, and from it whether the group is awake.
struct LookAtRest {
  using Team = typename Kokkos::TeamPolicy<Exec>::member_type;
  double tolerance, least, most, mass_scaling, per_step;  ///< 1, N, N, 1, 1/s
  GatherContacts gather;
  ParticlePush push;
  Groups groups;

  /// Unrest of one degree of freedom; for a rotation `force` and `momentum` are the torque and the angular momentum
  /// over the radius of gyration.
  KOKKOS_FORCEINLINE_FUNCTION double unrest(bool held, double force, double momentum) const {
    const double stop = Kokkos::abs(momentum) * per_step;
    return held ? stop : at_least(Kokkos::abs(force), stop);
  }
  KOKKOS_FUNCTION Unrest unrest(int i) const {
    const Push all = push.total(i, push.outside(i));
    push.hold(i, all);  // nothing else updates the reaction of a sleeping particle
    const double mass = mass_scaling * mass_fraction(push.p.solid_fraction(i)) * push.p.mass(i);
    const double gyration = Kokkos::sqrt(push.p.inertia(i) / push.p.mass(i));
    const int held = push.p.held(i);
    const double x = unrest((held & 1) != 0, all.x, mass * push.p.v(i, 0));
    const double y = unrest((held & 2) != 0, all.y, mass * push.p.v(i, 1));
    const double turn = unrest((held & 4) != 0, all.torque / gyration, mass * gyration * push.p.spin(i));
    double borne = 0;
    for (int edge = 0; edge < 3; ++edge) {
      const Push bond = push.bond(i, edge);
      borne = at_least(borne, at_least(Kokkos::abs(bond.x), Kokkos::abs(bond.y)));
    }
    return {at_least(at_least(x, y), turn), (held & 1) != 0 ? 0 : all.x, (held & 2) != 0 ? 0 : all.y, borne};
  }
  KOKKOS_FUNCTION void operator()(const Team& team) const {
    const int g = team.league_rank(), first = g * groups.size;
    if (!groups.is_ours(g)) return;
    const auto range =
        Kokkos::TeamThreadRange(team, first, first + groups.size < push.p.count ? first + groups.size : push.p.count);
    Unrest all;
    Kokkos::parallel_reduce(
        range,
        [&](int i, Unrest& sum) {
          gather(i);
          sum += unrest(i);
        },
        Kokkos::Sum<Unrest>(all));
    const bool was_awake = groups.runs(g) != 0;
    const double wake_at = tolerance * Kokkos::clamp(all.borne, least, most);
    const bool wakes = !all.is_below((was_awake ? asleep_below : 1) * wake_at);
    team.team_barrier();
    Kokkos::single(Kokkos::PerTeam(team), [&] { groups.runs(g) = wakes ? 1 : 0; });
    if (wakes || !was_awake) return;
    Kokkos::parallel_for(range, [&](int i) { push.p.v(i, 0) = push.p.v(i, 1) = push.p.spin(i) = 0; });
  }
};

struct WakeBonds {
  Bonds bonds;
  Groups particles, groups, due;
  KOKKOS_FUNCTION void operator()(int g) const {
    const int first = g * groups.size, last = first + groups.size < bonds.count ? first + groups.size : bonds.count;
    int runs = 0;
    for (int k = first; k < last; ++k)
      runs |= particles.runs(bonds.pair(k, 0) / particles_per_group) |
              particles.runs(bonds.pair(k, 1) / particles_per_group);
    due.runs(g) = static_cast<std::uint8_t>(runs | groups.runs(g));
    groups.runs(g) = static_cast<std::uint8_t>(runs);
  }
};

struct CountAwake {
  Groups groups;
  KOKKOS_FUNCTION void operator()(int g, int& awake) const { awake += groups.runs(g); }
};

}  // namespace

Rest make_rest(const Particles& particles, const Bonds& bonds, double normal_strength, const Loads& loads,
               double tolerance) {
  Rest rest;
  rest.tolerance = tolerance;
  const double strength = bonds.count == 0 ? 0 : normal_strength * sum_in_order(bonds.length) / bonds.count;
  // otherwise rock far stronger than its loads, or loaded from the start, would sleep through what changes
  const double change = loads.change > 0 ? loads.change : loads.largest;
  rest.least = strength * (change > 0 ? std::min(least_borne, change / normal_strength) : least_borne);
  rest.most = strength * (loads.change > 0 ? std::min(1.0, loads.change / normal_strength) : 1.0);
  rest.particles = make_groups("vug::dem::rest_particles", particles.count, particles_per_group);
  rest.bonds = make_groups("vug::dem::rest_bonds", bonds.count, bonds_per_group);
  rest.due = make_groups("vug::dem::rest_due", bonds.count, bonds_per_group);
  rest.awake = static_cast<int>(rest.particles.runs.extent(0));
  return rest;
}

double awake_share(const Rest& rest) {
  const auto runs = on_host(rest.particles.runs);
  double awake = 0;
  for (std::size_t g = 0; g < runs.extent(0); ++g) awake += runs(g);
  return awake / static_cast<double>(runs.extent(0));
}

void look_at_rest(const Exec& exec, const StepControl& control, const Bonds& bonds, const Contacts& contacts,
                  const BoundaryLoads& loads, const Particles& particles, const Rest& rest) {
  const LookAtRest look{rest.tolerance,
                        rest.least,
                        rest.most,
                        control.mass_scaling,
                        1 / control.dt,
                        gather_loads(bonds, contacts),
                        particle_push(control.load_factor, control.surroundings, bonds, contacts, loads, particles),
                        rest.particles};
  const int groups = static_cast<int>(rest.particles.runs.extent(0));
  for_each_team(exec, "vug::dem::look_at_rest", groups, particles_per_group, look);
}

void wake_bonds(const Exec& exec, const Bonds& bonds, Rest& rest) {
  const int groups = static_cast<int>(rest.particles.runs.extent(0));
  for_each_node(exec, "vug::dem::wake_bonds", static_cast<int>(rest.bonds.runs.extent(0)),
                WakeBonds{bonds, rest.particles, rest.bonds, rest.due});
  if constexpr (runs_on_host)
    Kokkos::parallel_reduce("vug::dem::count_awake", Kokkos::RangePolicy<Exec>(exec, 0, groups),
                            CountAwake{rest.particles}, rest.awake);
}

}  // namespace vug
