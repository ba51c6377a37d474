#include "coupling/pathways.hpp"

#include "kernels/launch.hpp"

namespace vug {

/// Aperture of a bond now; counts the bonds where it differs from that of the last look.
struct WidenBonds {
  PathwayNodes nodes;
  Kokkos::View<const double*> d_m;
  ScalarField<double> aperture;
  KOKKOS_FUNCTION void operator()(int b, int& changed) const {
    const double now = pathway_aperture(d_m(b), nodes.closed(b), nodes.open(b));
    changed += now != aperture(b);
    aperture(b) = now;
  }
};

/// Marks the candidates that the damage of their bond opens now and counts them.
struct MarkOpening {
  PathwayNodes nodes;
  Kokkos::View<const double*> aperture;
  Kokkos::View<NodeType*> type;
  Kokkos::View<std::uint8_t*> opening;
  KOKKOS_FUNCTION bool opens(int c) const {
    for (int k = nodes.offset(c); k < nodes.offset(c + 1); ++k)
      if (nodes.least(k) <= aperture(nodes.bond(k))) return true;
    return false;
  }
  KOKKOS_FUNCTION void operator()(int c, int& count) const {
    const int n = nodes.node(c);
    if (type(n) != NodeType::solid || !opens(c)) return;
    type(n) = NodeType::fluid;
    opening(n) = 1;
    ++count;
  }
};

struct ClearOpening {
  PathwayNodes nodes;
  Kokkos::View<std::uint8_t*> opening;
  KOKKOS_FUNCTION void operator()(int c) const { opening(nodes.node(c)) = 0; }
};

PathwayOpener::PathwayOpener(const Lattice& lattice, PathwayNodes nodes, SolidSpread spread)
    : nodes_(std::move(nodes)),
      spread_(std::move(spread)),
      opening_("vug::pathways::opening", lattice.size()),
      aperture_("vug::pathways::aperture", nodes_.closed.extent(0)) {
  Kokkos::deep_copy(aperture_, -1.0);
}

int PathwayOpener::open(const Exec& exec, const ScalarField<double>& d_m, const Kokkos::View<NodeType*>& type,
                        const ScalarField<double>& volume, const ScalarField<double>& dissolved) {
  const int candidates = static_cast<int>(nodes_.node.extent(0)), bonds = static_cast<int>(aperture_.extent(0));
  int changed = 0, opened = 0;
  Kokkos::parallel_reduce("vug::pathways::widen", Kokkos::RangePolicy<Exec>(exec, 0, bonds),
                          WidenBonds{nodes_, d_m, aperture_}, changed);
  if (changed == 0) return 0;
  Kokkos::parallel_reduce("vug::pathways::mark", Kokkos::RangePolicy<Exec>(exec, 0, candidates),
                          MarkOpening{nodes_, aperture_, type, opening_}, opened);
  if (opened == 0) return 0;
  if (volume.extent(0) > 0)
    spread_(exec, type, opening_, volume, dissolved);
  else
    for_each_node(exec, "vug::pathways::clear", candidates, ClearOpening{nodes_, opening_});
  return opened;
}

}  // namespace vug
