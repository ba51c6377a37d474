#include "kernels/reaction/reactive_wall.hpp"

#include "kernels/launch/launch.hpp"
#include "kernels/launch/prefetch.hpp"
#include "kernels/reaction/reactive_wall_step.hpp"

namespace vug {

template <class Set, class T>
void react_at_wall(const Exec& exec, const FluidNodes& nodes, const ReactiveWall& wall, const ReactiveLinks<T>& links,
                   const SoluteFields<T>& reactant, const SoluteFields<T>* product) {
  require_product(wall, product != nullptr);
  const char* label = "vug::reactive_wall::react";
  const auto launch = [&](const auto& its_product) {
    using Product = std::decay_t<decltype(its_product)>;
    visit_rock<T, Set>(wall, [&](const auto& rock) {
      using Rock = std::decay_t<decltype(rock)>;
      if (wall.law == ReactiveWallLaw::kinetic)
        for_each_node<false>(
            exec, label, links.share(),
            KineticStep<T, Rock, Product>{rock, links, reactant.h, its_product, reactant.rounding.at_links});
      else
        for_each_node(exec, label, links.share(),
                      PaperStep<T, Set, Rock, Product>{rock, T(wall.D_reactant), T(wall.D_product), nodes.capacity,
                                                       links, reactant.h, reactant.C, its_product});
    });
  };
  if (product)
    launch(WithProduct<T>{product->h, product->C});
  else
    launch(NoProduct{});
}

/// Pixels dissolved per acid: of rock of one kind, or of the mineral of a node.
struct DissolvedPerAcid {
  double molar_volume;
  MineralRates minerals;
  explicit DissolvedPerAcid(const ReactiveWall& wall) : molar_volume(wall.molar_volume), minerals(wall.minerals) {}
  KOKKOS_FORCEINLINE_FUNCTION double operator()(int node) const {
    return minerals.of_node.extent(0) > 0 ? minerals.at(node).molar_volume : molar_volume;
  }
};

/// Books the links of one surface node in their order; returns the acid that they consumed.
template <class T>
struct BookTurnover {
  IndexList node;
  int count;
  ReactiveLinks<T> links;
  bool apart;  ///< acid, product and solid differ
  DissolvedPerAcid per_acid;
  ReactionLedger ledger;
  SurfaceLosses losses;
  bool first;  ///< reactant of this booking

  KOKKOS_FORCEINLINE_FUNCTION static double take(double& amount) {
    const double taken = amount;
    amount = 0;
    return taken;
  }
  /// Prefetches for a later surface node, because these are scattered over the lattice.
  KOKKOS_FORCEINLINE_FUNCTION void announce(int s) const {
    constexpr int ahead = 128;
    const int later = node(s + ahead < count ? s + ahead : count - 1);
    prefetch(&ledger.V(later));
    prefetch(&ledger.dissolved(later));
  }
  KOKKOS_FUNCTION double operator()(int s) const {
    announce(s);
    double acid = 0, product = 0, solid = 0;
    for (int k = links.of_surface(s); k < links.of_surface(s + 1); ++k) {
      const int l = links.of_surface_link(k);
      acid += take(links.acid(l));
      if (!apart) continue;
      product += take(links.product(l));
      solid += take(links.solid(l));
    }
    const int n = node(s);
    const double volume = per_acid(n) * (apart ? solid : acid);
    if (ledger.acid.extent(0) > 0) ledger.acid(n) += acid;
    ledger.V(n) -= volume;
    ledger.dissolved(n) += volume;
    losses.note(s, volume, first);
    if (ledger.released.extent(0) > 0) ledger.released(n) += apart ? product : acid;
    return acid;
  }
};

/// Adds the volume that the links of one surface node have taken off it, not booked yet.
template <class T>
struct AddLoss {
  IndexList node;
  ReactiveLinks<T> links;
  DissolvedPerAcid per_acid;
  ScalarField<double> loss;
  KOKKOS_FUNCTION void operator()(int s) const {
    double solid = 0;
    for (int k = links.of_surface(s); k < links.of_surface(s + 1); ++k) solid += links.solid(links.of_surface_link(k));
    loss(s) += per_acid(node(s)) * solid;
  }
};

template <class T>
void add_losses(const Exec& exec, const Surface& surface, const ReactiveWall& wall, const ReactiveLinks<T>& links,
                const ScalarField<double>& loss) {
  for_each_node(exec, "vug::reactive_wall::loss", surface.count,
                AddLoss<T>{surface.node, links, DissolvedPerAcid(wall), loss});
}

template <class T>
void book_turnover(const Exec& exec, const Surface& surface, const ReactiveWall& wall, const ReactiveLinks<T>& links,
                   const ReactionLedger& ledger, const SurfaceLosses& losses, bool first) {
  const bool apart = wall.law != ReactiveWallLaw::kinetic;
  add_per_block(
      exec, "vug::reactive_wall::book", surface.count,
      BookTurnover<T>{surface.node, surface.count, links, apart, DissolvedPerAcid(wall), ledger, losses, first},
      ledger.consumed);
}

/// The value where the mineral is `wanted`, else 0.
struct OfMineral {
  Kokkos::View<const double*> value;
  Kokkos::View<const std::uint8_t*> mineral;
  int wanted;
  KOKKOS_FUNCTION double operator()(int i) const { return mineral(i) == wanted ? value(i) : 0.0; }
};

std::vector<double> sums_by_mineral(const Exec& exec, const std::string& label, int n,
                                    const Kokkos::View<const double*>& value,
                                    const Kokkos::View<const std::uint8_t*>& mineral, int minerals) {
  std::vector<double> sums;
  for (int m = 0; m < minerals; ++m) sums.push_back(sum_of_list(exec, label, n, OfMineral{value, mineral, m}));
  return sums;
}

VUG_COMPILE_FOR_SETS(react_at_wall)

VUG_COMPILE_FOR_NUMBERS(add_losses)
VUG_COMPILE_FOR_NUMBERS(book_turnover)

}  // namespace vug
