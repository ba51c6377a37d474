#include "coupling/chemical_damage.hpp"

#include "coupling/run_sum.hpp"
#include "kernels/launch.hpp"

namespace vug {

struct StoreSum {
  ScalarField<double> sum;
  KOKKOS_FUNCTION void operator()(int group, double value) const { sum(group) = value; }
};

/// sum(s) = settled(s) and what has dissolved of the wet nodes of sector s.
struct SumWetNodes {
  Kokkos::View<const int*> offset, node;
  Kokkos::View<const double*> dissolved, settled;
  ScalarField<double> sum;
  /// Neighbours in the list often lie on different rows.
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

/// settled(s) += what had dissolved of the nodes of sector s that were wet and now are fluid.
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

struct OfTriangle {
  Kokkos::View<const double*> sum;
  KOKKOS_FORCEINLINE_FUNCTION double operator()(int t) const { return sum(3 * t) + sum(3 * t + 1) + sum(3 * t + 2); }
};

struct OfBond {
  SectorPairs sectors;
  Kokkos::View<const double*> sum;
  KOKKOS_FORCEINLINE_FUNCTION double operator()(int b) const { return sum(sectors(b, 0)) + sum(sectors(b, 1)); }
};

/// volume(g) = sum over the sectors of g.
template <class Of>
struct StoreVolume {
  Of of;
  ScalarField<double> volume;
  KOKKOS_FUNCTION void operator()(int g) const { volume(g) = of(g); }
};

/// value(g) = sum over the sectors of g over its initial volume, or what that leaves of 1.
template <class Of>
struct StoreShare {
  Of of;
  Kokkos::View<const double*> initial;
  ScalarField<double> value;
  bool remaining;
  KOKKOS_FUNCTION void operator()(int g) const {
    const double ratio = initial(g) > 0 ? of(g) / initial(g) : 0.0, share = ratio < 1 ? ratio : 1.0;
    value(g) = remaining ? 1 - share : share;
  }
};

DissolvedShares::DissolvedShares(const Exec& exec, const NodeGroups& nodes_of_sector,
                                 const SectorPairs& sectors_of_bond, const ScalarField<double>& volume)
    : sectors_of_bond_(sectors_of_bond),
      triangle_volume_("vug::chemical_damage::triangle_volume", nodes_of_sector.count() / 3),
      bond_volume_("vug::chemical_damage::bond_volume", sectors_of_bond.extent(0)),
      settled_("vug::chemical_damage::settled", nodes_of_sector.count()),
      sum_("vug::chemical_damage::sum", nodes_of_sector.count()) {
  sum_runs(exec, "vug::chemical_damage::initial", nodes_of_sector, volume, StoreSum{sum_});
  for_each_node(exec, "vug::chemical_damage::triangle_volume", static_cast<int>(triangle_volume_.extent(0)),
                StoreVolume<OfTriangle>{{sum_}, triangle_volume_});
  for_each_node(exec, "vug::chemical_damage::bond_volume", static_cast<int>(bond_volume_.extent(0)),
                StoreVolume<OfBond>{{sectors_of_bond_, sum_}, bond_volume_});
}

void DissolvedShares::update(const Exec& exec, const WetNodes& wet, const ScalarField<double>& dissolved,
                             const ScalarField<double>& solid_fraction, const ScalarField<double>& d_c) const {
  for_each_node(exec, "vug::chemical_damage::sum", wet.sectors(),
                SumWetNodes{wet.of_sector(), wet.node(), dissolved, settled_, sum_});
  for_each_node(exec, "vug::chemical_damage::remaining", static_cast<int>(triangle_volume_.extent(0)),
                StoreShare<OfTriangle>{{sum_}, triangle_volume_, solid_fraction, true});
  for_each_node(exec, "vug::chemical_damage::share", static_cast<int>(bond_volume_.extent(0)),
                StoreShare<OfBond>{{sectors_of_bond_, sum_}, bond_volume_, d_c, false});
}

void DissolvedShares::settle(const Exec& exec, const WetNodes& wet, const Kokkos::View<NodeType*>& type,
                             const ScalarField<double>& dissolved) const {
  for_each_node(exec, "vug::chemical_damage::settle", wet.sectors(),
                SettleNodes{wet.of_sector(), wet.node(), type, dissolved, settled_});
}

}  // namespace vug
