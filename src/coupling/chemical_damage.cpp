#include "coupling/chemical_damage.hpp"

#include "coupling/run_sum.hpp"
#include "dem/dissolved_rock.hpp"
#include "dem/out_of_place.hpp"
#include "dem/pieces.hpp"
#include "kernels/launch/launch.hpp"
#include "kernels/launch/prefetch.hpp"

namespace vug {

struct StoreSum {
  ScalarField<double> sum;
  KOKKOS_FUNCTION void operator()(int group, double value) const { sum(group) = value; }
};

/// sum(s) = settled(s) + dissolved volume of the wet nodes of sector s.
struct SumWetNodes {
  Kokkos::View<const int*> offset, node;
  Kokkos::View<const double*> dissolved, settled;
  ScalarField<double> sum;
  /// Prefetches: neighbours in the list are often in different rows.
  KOKKOS_FORCEINLINE_FUNCTION void announce(int k) const {
    constexpr int ahead = 256;
    if (k + ahead < static_cast<int>(node.extent(0))) prefetch_far(&dissolved(node(k + ahead)));
  }
  KOKKOS_FUNCTION void operator()(int s) const {
    double wet = 0;
    for (int k = offset(s); k < offset(s + 1); ++k) {
      announce(k);
      wet += dissolved(node(k));
    }
    sum(s) = settled(s) + wet;
  }
};

/// settled(s) += dissolved volume of the nodes of sector s that were wet and are fluid now.
struct SettleNodes {
  Kokkos::View<const int*> offset, node;
  Kokkos::View<const NodeType*> type;
  Kokkos::View<const double*> dissolved;
  ScalarField<double> settled;
  KOKKOS_FUNCTION void operator()(int s) const {
    double fluid = 0;
    for (int k = offset(s); k < offset(s + 1); ++k)
      if (type(node(k)) == NodeType::fluid) fluid += dissolved(node(k));
    settled(s) += fluid;
  }
};

struct OfSector {
  Kokkos::View<const double*> sum;
  KOKKOS_FORCEINLINE_FUNCTION double operator()(int s) const { return sum(s); }
};

struct OfTriangle {
  Kokkos::View<const double*> sum;
  KOKKOS_FORCEINLINE_FUNCTION double operator()(int t) const { return sum(3 * t) + sum(3 * t + 1) + sum(3 * t + 2); }
};

/// Share of the solid of group g that is left (see DissolvedShares).
template <class Of>
struct RemainingShare {
  Of dissolved;
  SolidMoved moved;
  KOKKOS_FORCEINLINE_FUNCTION double operator()(int g) const {
    return remaining_share(moved.left(g), dissolved(g) - moved.dissolved(g), moved.held(g));
  }
};

struct StoreSolidFraction {
  RemainingShare<OfTriangle> left;
  ScalarField<double> solid_fraction;
  KOKKOS_FUNCTION void operator()(int t) const { solid_fraction(t) = left(t); }
};

struct StoreChemicalDamage {
  SectorPairs sectors;
  RemainingShare<OfSector> left;
  Kokkos::View<const double*> initial, solid_fraction;
  ScalarField<double> d_c;
  /// Share of a bond's side that is left. The rock of a sector without a solid node has dissolved or is elsewhere in
  /// the triangle; d_c must not fall.
  KOKKOS_FORCEINLINE_FUNCTION double left_of_side(int s) const {
    const double of_triangle = solid_fraction(s / 3), own = left(s);
    return side_left(left.moved.held(s) > 0 || own < of_triangle ? own : of_triangle, of_triangle);
  }
  KOKKOS_FUNCTION void operator()(int b) const {
    const int s = sectors(b, 0), t = sectors(b, 1);
    d_c(b) = chemical_damage_of_sides(initial(s), left_of_side(s), initial(t), left_of_side(t));
  }
};

/// After solid has moved: stores the share until now, what has dissolved and what the nodes hold now.
template <class Of>
struct StoreMoved {
  RemainingShare<Of> left;
  Of held;
  KOKKOS_FUNCTION void operator()(int g) const {
    const SolidMoved& moved = left.moved;
    moved.left(g) = left(g);
    moved.dissolved(g) = left.dissolved(g);
    moved.held(g) = held(g);
  }
};

/// Marks the loose pieces of which a triangle has left its place.
struct MarkLeaving {
  Particles particles;
  IndexList piece, leaving;
  KOKKOS_FUNCTION void operator()(int t) const {
    if (piece(t) >= 0 && is_out_of_place(particles, t)) Kokkos::atomic_store(&leaving(piece(t)), 1);
  }
};

/// Sets the remaining share of the triangles of those pieces to 0, and counts them in `gone`.
struct LetPieceGo {
  IndexList piece, leaving;
  ScalarField<double> left, gone;
  KOKKOS_FUNCTION void operator()(int t) const {
    if (piece(t) < 0 || leaving(piece(t)) == 0) return;
    left(t) = 0;
    gone(t) = 1;
  }
};

SolidMoved::SolidMoved(std::size_t count)
    : left("vug::chemical_damage::left", count),
      dissolved("vug::chemical_damage::dissolved", count),
      held("vug::chemical_damage::held", count) {
  Kokkos::deep_copy(left, 1.0);
}

DissolvedShares::DissolvedShares(const Exec& exec, const NodeGroups& nodes_of_sector,
                                 const SectorPairs& sectors_of_bond, const ScalarField<double>& volume)
    : nodes_of_sector_(nodes_of_sector),
      sectors_of_bond_(sectors_of_bond),
      triangles_(nodes_of_sector.count() / 3),
      sectors_(nodes_of_sector.count()),
      initial_("vug::chemical_damage::initial", nodes_of_sector.count()),
      settled_("vug::chemical_damage::settled", nodes_of_sector.count()),
      sum_("vug::chemical_damage::sum", nodes_of_sector.count()),
      held_("vug::chemical_damage::held_of_sector", nodes_of_sector.count()),
      solid_fraction_("vug::chemical_damage::solid_fraction", nodes_of_sector.count() / 3),
      d_c_("vug::chemical_damage::d_c", sectors_of_bond.extent(0)) {
  sum_held(exec, volume);
  Kokkos::deep_copy(exec, initial_, held_);
  store_moved(exec);
}

void DissolvedShares::sum_dissolved(const Exec& exec, const WetNodes& wet, const ScalarField<double>& dissolved) const {
  for_each_node(exec, "vug::chemical_damage::sum", wet.sectors(),
                SumWetNodes{wet.of_sector(), wet.node(), dissolved, settled_, sum_});
}

void DissolvedShares::sum_held(const Exec& exec, const ScalarField<double>& volume) const {
  sum_runs(exec, "vug::chemical_damage::held", nodes_of_sector_, volume, StoreSum{held_});
}

void DissolvedShares::store_moved(const Exec& exec) const {
  for_each_node(exec, "vug::chemical_damage::triangles_moved", static_cast<int>(triangles_.held.extent(0)),
                StoreMoved<OfTriangle>{{{sum_}, triangles_}, {held_}});
  for_each_node(exec, "vug::chemical_damage::sectors_moved", static_cast<int>(sectors_.held.extent(0)),
                StoreMoved<OfSector>{{{sum_}, sectors_}, {held_}});
}

void DissolvedShares::update(const Exec& exec, const WetNodes& wet, const ScalarField<double>& dissolved) const {
  sum_dissolved(exec, wet, dissolved);
  for_each_node(exec, "vug::chemical_damage::solid_fraction", static_cast<int>(solid_fraction_.extent(0)),
                StoreSolidFraction{{{sum_}, triangles_}, solid_fraction_});
  for_each_node(exec, "vug::chemical_damage::d_c", static_cast<int>(d_c_.extent(0)),
                StoreChemicalDamage{sectors_of_bond_, {{sum_}, sectors_}, initial_, solid_fraction_, d_c_});
}

void DissolvedShares::follow_fragments() {
  let_go_ = ScalarField<double>("vug::chemical_damage::let_go", solid_fraction_.extent(0));
  leaving_ = IndexList("vug::chemical_damage::leaving", solid_fraction_.extent(0));
}

void DissolvedShares::let_go(const Exec& exec, const Particles& particles, const Bonds& bonds) {
  if (let_go_.extent(0) == 0 || count_out_of_place(exec, particles) == 0) return;
  // anew each time: which piece is the heaviest changes as rock dissolves, and must not depend on when it was asked
  const auto piece = to_device<IndexList>("vug::chemical_damage::pieces", find_loose_pieces(particles, bonds));
  Kokkos::deep_copy(exec, leaving_, 0);
  for_each_node(exec, "vug::chemical_damage::mark_leaving", particles.count, MarkLeaving{particles, piece, leaving_});
  for_each_node(exec, "vug::chemical_damage::let_go", particles.count,
                LetPieceGo{piece, leaving_, triangles_.left, let_go_});
}

int DissolvedShares::let_go_count() const {
  const auto gone = on_host(let_go_);
  int count = 0;
  for (std::size_t t = 0; t < gone.extent(0); ++t) count += gone(t) > 0;
  return count;
}

void DissolvedShares::solid_moved(const Exec& exec, const WetNodes& wet, const ScalarField<double>& dissolved,
                                  const ScalarField<double>& volume) const {
  sum_dissolved(exec, wet, dissolved);
  sum_held(exec, volume);
  store_moved(exec);
}

void DissolvedShares::settle(const Exec& exec, const WetNodes& wet, const Kokkos::View<NodeType*>& type,
                             const ScalarField<double>& dissolved) const {
  for_each_node(exec, "vug::chemical_damage::settle", wet.sectors(),
                SettleNodes{wet.of_sector(), wet.node(), type, dissolved, settled_});
}

}  // namespace vug
