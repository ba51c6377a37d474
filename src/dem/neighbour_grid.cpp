#include "dem/neighbour_grid.hpp"

#include "dem/pair_candidates.hpp"
#include "kernels/launch/launch.hpp"

#include <algorithm>
#include <cmath>

namespace vug {

NeighbourGrid make_neighbour_grid(const Particles& particles, double skin) {
  const auto x0 = on_host(particles.x0);
  const auto corner = on_host(particles.corner);
  NeighbourGrid grid;
  double right = x0(0, 0), top = x0(0, 1);
  grid.left = right;
  grid.bottom = top;
  for (int i = 0; i < particles.count; ++i) {
    grid.left = std::min(grid.left, x0(i, 0)), right = std::max(right, x0(i, 0));
    grid.bottom = std::min(grid.bottom, x0(i, 1)), top = std::max(top, x0(i, 1));
    for (int c = 0; c < 3; ++c) grid.reach = std::max(grid.reach, std::hypot(corner(i, c, 0), corner(i, c, 1)));
  }
  grid.cell = 2.05 * grid.reach + skin;  // room for warm triangles
  grid.nx = 1 + static_cast<int>((right - grid.left) / grid.cell);
  grid.ny = 1 + static_cast<int>((top - grid.bottom) / grid.cell);
  grid.start = IndexList("vug::dem::grid_start", grid.nx * grid.ny + 1);
  grid.item = IndexList("vug::dem::grid_item", particles.count);
  return grid;
}

namespace {

/// Marks the list as stale when this particle has moved or turned by more than a quarter of the skin.
struct WatchMotion {
  double reach;
  Particles p;
  Bonds bonds;
  Contacts contacts;
  KOKKOS_FUNCTION void operator()(int i) const {
    if (bonds.events(bond_has_failed) == 0) return;
    if (i == 0 && bonds.events(cracks_have_changed) != 0) {
      bonds.events(cracks_have_changed) = 0;
      Kokkos::atomic_store(&contacts.status(contacts_stale), 1);
    }
    const double moved = norm({p.u(i, 0) - contacts.u_built(i, 0), p.u(i, 1) - contacts.u_built(i, 1)}) +
                         reach * Kokkos::abs(p.angle(i) - contacts.angle_built(i));
    if (!(moved < 0.25 * contacts.skin)) Kokkos::atomic_store(&contacts.status(contacts_stale), 1);
  }
};

/// The whole rebuild by one team, in phases separated by barriers: one launch, which returns at once when the list is
/// up to date. Pairs come out ordered by particle numbers, whatever the order in which cells were filled.
struct RebuildPairs {
  using Team = Kokkos::TeamPolicy<Exec>::member_type;
  PairCandidates near;
  Contacts contacts;

  template <class Body>
  KOKKOS_FUNCTION static void each(const Team& team, int n, const Body& body) {
    Kokkos::parallel_for(Kokkos::TeamThreadRange(team, n), body);
    team.team_barrier();
  }

  /// Turns counts in [0, n) into starts in [0, n], in place.
  template <class ViewType>
  KOKKOS_FUNCTION static void accumulate(const Team& team, int n, const ViewType& count) {
    Kokkos::parallel_scan(Kokkos::TeamThreadRange(team, n + 1), [&](int i, int& sum, bool last) {
      const int own = i < n ? count(i) : 0;
      if (last) count(i) = sum;
      sum += own;
    });
    team.team_barrier();
  }

  KOKKOS_FUNCTION void sort_into_cells(const Team& team) const {
    const int cells = near.grid.nx * near.grid.ny;
    each(team, cells + 1, [&](int c) { near.grid.start(c) = 0; });
    each(team, near.p.count, [&](int i) { Kokkos::atomic_inc(&near.grid.start(near.cell_of(i))); });
    Kokkos::parallel_scan(Kokkos::TeamThreadRange(team, cells + 1), [&](int c, int& sum, bool last) {
      sum += near.grid.start(c);
      if (last) near.grid.start(c) = sum;  // the end of the cell
    });
    team.team_barrier();
    // cells are filled from their ends, the last particle first: this moves each end to the start of its cell
    each(team, near.p.count, [&](int item) {
      const int i = near.p.count - 1 - item;
      near.grid.item(Kokkos::atomic_fetch_sub(&near.grid.start(near.cell_of(i)), 1) - 1) = i;
    });
  }

  KOKKOS_FUNCTION int find_pair(int low, int high, int generation) const {
    for (int k = contacts.first(low, generation); k < contacts.first(low + 1, generation); ++k) {
      if (contacts.other(k, generation) == high) return k;
    }
    return -1;
  }

  /// Lists the pairs of which i is the lower particle, ordered, with the friction and the idle overlaps that they had
  /// in the old list.
  KOKKOS_FUNCTION void list_pairs(int i, int now, int before) const {
    const int first = contacts.first(i, now), last = contacts.first(i + 1, now);
    if (first == last) contacts.energy(i) = 0;  // no force is computed that would set it
    int count = first;
    near.for_candidates(i, [&](int j) {
      if (j < i || count == last) return;
      int k = count++;
      for (; k > first && contacts.other(k - 1, now) > j; --k) contacts.other(k, now) = contacts.other(k - 1, now);
      contacts.other(k, now) = j;
    });
    for (int k = first; k < last; ++k) {
      const int j = contacts.other(k, now), old = find_pair(i, j, before);
      for (int f = 0; f < pair_features; ++f) {
        contacts.stretch(k, now, f) = old < 0 ? 0 : contacts.stretch(old, before, f);
        contacts.idle_overlap(k, now, f) =
            old < 0 ? near.first_idle_overlap(i, j) : contacts.idle_overlap(old, before, f);
      }
    }
  }

  /// Clears what a longer list left behind the present one: ranks know all of a list, but not of what was before.
  KOKKOS_FUNCTION void clear_rest(const Team& team, int now, int used) const {
    const int end = contacts.first(near.p.count, now);
    each(team, used - end, [&](int k) {
      for (int f = 0; f < pair_features; ++f) {
        contacts.stretch(end + k, now, f) = 0;
        contacts.idle_overlap(end + k, now, f) = 0;
      }
    });
  }

  KOKKOS_FUNCTION void list_rows(int i, int now) const {
    int at = contacts.row(i);
    const int first = at;
    near.for_candidates(i, [&](int j) {
      const int pair = find_pair(i < j ? i : j, i < j ? j : i, now);
      if (pair < 0) return;
      const int value = 2 * pair + (i < j ? 0 : 1);
      int k = at++;
      for (; k > first && contacts.entry(k - 1) > value; --k) contacts.entry(k) = contacts.entry(k - 1);
      contacts.entry(k) = value;
    });
  }

  KOKKOS_FUNCTION void count_pairs(const Team& team, int now) const {
    const auto first = Kokkos::subview(contacts.first, Kokkos::ALL, now);
    each(team, near.p.count, [&](int i) {
      int higher = 0;
      near.for_candidates(i, [&](int j) { higher += j > i; });
      first(i) = higher;
    });
    accumulate(team, near.p.count, first);
    Kokkos::single(Kokkos::PerTeam(team),
                   [&] { contacts.status(contacts_lost) = Kokkos::max(0, first(near.p.count) - contacts.capacity); });
    team.team_barrier();
    each(team, near.p.count + 1, [&](int i) { first(i) = Kokkos::min(first(i), contacts.capacity); });
  }

  KOKKOS_FUNCTION void count_rows(const Team& team, int now) const {
    each(team, near.p.count, [&](int i) {
      int pairs = 0;
      near.for_candidates(i, [&](int j) { pairs += find_pair(i < j ? i : j, i < j ? j : i, now) >= 0; });
      contacts.row(i) = pairs;
    });
    accumulate(team, near.p.count, contacts.row);
  }

  KOKKOS_FUNCTION void operator()(const Team& team) const {
    if (near.bonds.events(bond_has_failed) == 0 || contacts.status(contacts_stale) == 0) return;
    const int before = contacts.status(contacts_generation), now = 1 - before;
    const int used = contacts.first(near.p.count, now);
    team.team_barrier();  // all threads have read these
    sort_into_cells(team);
    count_pairs(team, now);
    each(team, near.p.count, [&](int i) { list_pairs(i, now, before); });
    clear_rest(team, now, used);
    count_rows(team, now);
    each(team, near.p.count, [&](int i) {
      list_rows(i, now);
      contacts.u_built(i, 0) = near.p.u(i, 0);
      contacts.u_built(i, 1) = near.p.u(i, 1);
      contacts.angle_built(i) = near.p.angle(i);
    });
    Kokkos::single(Kokkos::PerTeam(team), [&] {
      contacts.status(contacts_stale) = 0;
      contacts.status(contacts_generation) = now;
    });
  }
};

}  // namespace

void update_contacts(const Exec& exec, const NeighbourGrid& grid, const Particles& particles, const Bonds& bonds,
                     const Contacts& contacts) {
  for_each_node(exec, "vug::dem::watch_motion", particles.count, WatchMotion{grid.reach, particles, bonds, contacts});
  for_each_team(exec, "vug::dem::rebuild_pairs", 1, 1024,
                RebuildPairs{{grid, contacts.skin, particles, bonds}, contacts});
}

}  // namespace vug
