#include "coupling/chemical_damage.hpp"

#include "coupling/run_sum.hpp"
#include "dem/dissolved_rock.hpp"
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

/// What is left of a volume of which `dissolved` is gone: a share between 0 and 1; 1 where there was no solid.
KOKKOS_FORCEINLINE_FUNCTION double share_left(double dissolved, double initial) {
  const double share = initial > 0 ? 1 - dissolved / initial : 1.0;
  return share > 0 ? share : 0.0;
}

struct StoreSolidFraction {
  Kokkos::View<const double*> initial, sum;
  ScalarField<double> solid_fraction;
  KOKKOS_FUNCTION void operator()(int t) const {
    solid_fraction(t) = share_left(sum(3 * t) + sum(3 * t + 1) + sum(3 * t + 2),
                                   initial(3 * t) + initial(3 * t + 1) + initial(3 * t + 2));
  }
};

struct StoreChemicalDamage {
  SectorPairs sectors;
  Kokkos::View<const double*> initial, sum, solid_fraction;
  ScalarField<double> d_c;
  KOKKOS_FORCEINLINE_FUNCTION double left(int s) const {
    return side_left(share_left(sum(s), initial(s)), solid_fraction(s / 3));
  }
  KOKKOS_FUNCTION void operator()(int b) const {
    const int s = sectors(b, 0), t = sectors(b, 1);
    d_c(b) = chemical_damage_of_sides(initial(s), left(s), initial(t), left(t));
  }
};

DissolvedShares::DissolvedShares(const Exec& exec, const NodeGroups& nodes_of_sector,
                                 const SectorPairs& sectors_of_bond, const ScalarField<double>& volume)
    : sectors_of_bond_(sectors_of_bond),
      initial_("vug::chemical_damage::initial", nodes_of_sector.count()),
      settled_("vug::chemical_damage::settled", nodes_of_sector.count()),
      sum_("vug::chemical_damage::sum", nodes_of_sector.count()),
      solid_fraction_("vug::chemical_damage::solid_fraction", nodes_of_sector.count() / 3),
      d_c_("vug::chemical_damage::d_c", sectors_of_bond.extent(0)) {
  sum_runs(exec, "vug::chemical_damage::initial", nodes_of_sector, volume, StoreSum{initial_});
}

void DissolvedShares::update(const Exec& exec, const WetNodes& wet, const ScalarField<double>& dissolved) const {
  for_each_node(exec, "vug::chemical_damage::sum", wet.sectors(),
                SumWetNodes{wet.of_sector(), wet.node(), dissolved, settled_, sum_});
  for_each_node(exec, "vug::chemical_damage::solid_fraction", static_cast<int>(solid_fraction_.extent(0)),
                StoreSolidFraction{initial_, sum_, solid_fraction_});
  for_each_node(exec, "vug::chemical_damage::d_c", static_cast<int>(d_c_.extent(0)),
                StoreChemicalDamage{sectors_of_bond_, initial_, sum_, solid_fraction_, d_c_});
}

void DissolvedShares::settle(const Exec& exec, const WetNodes& wet, const Kokkos::View<NodeType*>& type,
                             const ScalarField<double>& dissolved) const {
  for_each_node(exec, "vug::chemical_damage::settle", wet.sectors(),
                SettleNodes{wet.of_sector(), wet.node(), type, dissolved, settled_});
}

}  // namespace vug
