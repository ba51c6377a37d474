#include "coupling/slits.hpp"

#include "coupling/slit.hpp"
#include "kernels/launch/launch.hpp"
#include "kernels/solute/slit_diffusion.hpp"

namespace vug {

/// Width (cells) that dissolution of a node and its walls adds to the crack: for a line of the given slope the faces of
/// the nodes beside it count 1/sqrt(1 + slope^2).
KOKKOS_FORCEINLINE_FUNCTION double etched_width(double dissolved, double slope) {
  return dissolved / Kokkos::sqrt(1 + slope * slope);
}

/// Finds resistance and openness of the places and counts changes. A node that several bonds open conducts as in the
/// widest of them.
struct FindSlits {
  PathwayNodes nodes;
  BondPathways bonds;
  Kokkos::View<const NodeType*> type;
  Kokkos::View<const double*> dissolved;
  int pitch;
  ScalarField<double> resistance, openness;

  struct Slit {
    double resistance = 0, openness = 1;
  };

  KOKKOS_FORCEINLINE_FUNCTION double dissolved_around(int n) const {
    if (dissolved.extent(0) == 0) return 0;
    return dissolved(n) + dissolved(n - 1) + dissolved(n + 1) + dissolved(n - pitch) + dissolved(n + pitch);
  }
  KOKKOS_FORCEINLINE_FUNCTION Slit found(int c) const {
    const int n = nodes.node(c);
    Slit widest;  // no resistance, where no bond has opened the node but acid
    if (type(n) != NodeType::fluid) return widest;
    const double gone = dissolved_around(n);
    bool any = false;
    for (int k = nodes.offset(c); k < nodes.offset(c + 1); ++k) {
      const int b = nodes.bond(k);
      if (nodes.least(k) > bonds.widest(b)) continue;
      // beside the narrowest strip, the nodes that a closed crack leaves open hardly conduct
      double conductivity = nodes.least(k) <= bonds.strip(b) ? bonds.conductivity(b) : cubic_law(narrowest_slit);
      double width = Kokkos::cbrt(12 * conductivity);
      if (gone > 0) conductivity = cubic_law(width += etched_width(gone, nodes.slope(b)));
      const double of_bond = slit_resistance(conductivity, nodes.slope(b));
      if (any && of_bond >= widest.resistance) continue;
      any = true;
      widest = {of_bond, of_bond > 0 ? slit_openness(width, nodes.slope(b)) : 1};
    }
    return widest;
  }
  KOKKOS_FUNCTION void operator()(int place, int& changed) const {
    const Slit now = found(nodes.in_order(place));
    changed += now.resistance != resistance(place);
    resistance(place) = now.resistance;
    openness(place) = now.openness;
  }
};

/// Lists the slits in the order of places, and thus of triangles.
struct ListSlits {
  PathwayNodes nodes;
  Kokkos::View<const double*> resistance, openness;
  IndexList index, listed;
  SlitNodes slits;
  int places;
  KOKKOS_FUNCTION void operator()(int place, int& before, bool last) const {
    const bool slit = resistance(place) > 0;
    if (last) {
      listed(place) = before;
      if (place + 1 == places) listed(places) = before + slit;
      if (slit) {
        const int i = index(nodes.node(nodes.in_order(place)));
        slits.fluid(before) = i;
        slits.resistance(before) = resistance(place);
        slits.openness(i) = openness(place);
      }
    }
    before += slit;
  }
};

struct GroupSlits {
  IndexList first_place, listed, first;
  KOKKOS_FUNCTION void operator()(int t) const { first(t) = listed(first_place(t)); }
};

Slits::Slits(const PathwayNodes& nodes)
    : nodes_(nodes),
      resistance_("vug::slits::resistance", nodes.in_order.extent(0)),
      openness_("vug::slits::openness_of_places", nodes.in_order.extent(0)),
      listed_("vug::slits::listed", nodes.in_order.extent(0) + 1) {
  Kokkos::deep_copy(openness_, 1.0);
}

void Slits::update(const Exec& exec, const BondPathways& bonds, Geometry& geometry) {
  int changed = 0;
  Kokkos::parallel_reduce(
      "vug::slits::resistance", Kokkos::RangePolicy<Exec>(exec, 0, static_cast<int>(resistance_.extent(0))),
      FindSlits{nodes_, bonds, geometry.type, geometry.dissolved, geometry.lattice.pitch, resistance_, openness_},
      changed);
  if (changed == 0) return;
  list(exec, geometry);
  ++geometry.slit_changes;
}

void Slits::list(const Exec& exec, Geometry& geometry) const {
  SlitNodes& slits = geometry.slits;
  const int places = static_cast<int>(resistance_.extent(0)), groups = static_cast<int>(nodes_.first.extent(0));
  if (slits.first.extent(0) == 0) {
    slits.fluid = IndexList("vug::slits::fluid", places);
    slits.resistance = ScalarField<double>("vug::slits::list", places);
    slits.first = IndexList("vug::slits::first", groups);
  }
  if (slits.openness.extent(0) < static_cast<std::size_t>(geometry.fluid.capacity))
    slits.openness = ScalarField<double>("vug::slits::openness", geometry.fluid.capacity);
  Kokkos::deep_copy(exec, slits.openness, 1.0);
  Kokkos::parallel_scan("vug::slits::list", Kokkos::RangePolicy<Exec>(exec, 0, places),
                        ListSlits{nodes_, resistance_, openness_, geometry.fluid.index, listed_, slits, places},
                        slits.count);
  for_each_node(exec, "vug::slits::group", groups, GroupSlits{nodes_.first, listed_, slits.first});
}

}  // namespace vug
