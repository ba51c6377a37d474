#include "coupling/pathways.hpp"

#include "coupling/slit.hpp"
#include "dem/crack_aperture.hpp"
#include "dem/mechanics.hpp"
#include "kernels/launch/launch.hpp"

namespace vug {

/// Determines what a bond conducts now. Counts the bonds where that has changed since the last look, and those with
/// slits, which are narrower than whole nodes or than they have been (a crack that closes leaves its nodes open).
struct LookAtBonds {
  PathwayNodes nodes;
  Kokkos::View<const double*> d_m, gap;
  BondPathways bonds;
  KOKKOS_FUNCTION void operator()(int b, PathwayOpener::Look& seen) const {
    const bool gapes = gap.extent(0) > 0;
    const double closed = nodes.closed(b), open = nodes.open(b);
    const double width = gapes ? Kokkos::fmin(gap(b), open) : pathway_aperture(d_m(b), closed, open);
    double strip = width, conductivity = slot_conductivity(width);
    if (nodes.cubic) {  // a crack in a pathway widens it
      const double slot = gapes ? Kokkos::fmin(closed + gap(b), open) : Kokkos::fmax(closed, width);
      conductivity = cubic_law(slot);
      strip = strip_of_slot(slot);
    } else if (gapes) {
      conductivity = Kokkos::fmax(slot_conductivity(closed), cubic_law(width));
      strip = Kokkos::fmax(slot_aperture(conductivity), strip_of_slot(width));
    }
    seen.changed += strip != bonds.strip(b) || conductivity != bonds.conductivity(b);
    seen.narrow += strip < bonds.widest(b) || (strip >= 1 && slit_resistance(conductivity, nodes.slope(b)) > 0);
    bonds.strip(b) = strip;
    bonds.widest(b) = Kokkos::fmax(strip, bonds.widest(b));
    bonds.conductivity(b) = conductivity;
  }
};

/// Opens the candidates that their bonds open now, marks them and counts them.
struct MarkOpening {
  PathwayNodes nodes;
  Kokkos::View<const double*> strip;
  Kokkos::View<NodeType*> type;
  Kokkos::View<std::uint8_t*> opening;
  KOKKOS_FUNCTION bool opens(int c) const {
    for (int k = nodes.offset(c); k < nodes.offset(c + 1); ++k)
      if (nodes.least(k) <= strip(nodes.bond(k))) return true;
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

/// Gives the candidates that are fluid from the start the solid that their pathway does not fill, and marks them.
struct MarkUnfilled {
  PathwayNodes nodes;
  Kokkos::View<const NodeType*> type;
  Kokkos::View<std::uint8_t*> opening;
  ScalarField<double> volume;
  KOKKOS_FUNCTION void operator()(int c) const {
    const int n = nodes.node(c);
    if (type(n) != NodeType::fluid) return;
    volume(n) = 1 - nodes.filled(c);
    opening(n) = 1;
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
      bonds_{ScalarField<double>("vug::pathways::strip", nodes_.closed.extent(0)),
             ScalarField<double>("vug::pathways::widest", nodes_.closed.extent(0)),
             ScalarField<double>("vug::pathways::conductivity", nodes_.closed.extent(0))} {
  Kokkos::deep_copy(bonds_.strip, -1.0);
}

void PathwayOpener::follow_cracks(const Mechanics& rock, double residual, double spacing) {
  rock_ = &rock;
  residual_ = residual;
  spacing_ = spacing;
  gap_ = ScalarField<double>("vug::pathways::gap", bonds_.strip.extent(0));
}

PathwayOpener::Look PathwayOpener::look(const Exec& exec, const ScalarField<double>& d_m) {
  if (rock_)
    find_crack_apertures(exec, rock_->particles(), rock_->bonds(), rock_->parameters().thermal_expansion, residual_,
                         spacing_, gap_);
  Look found;  // one value, because a reduction of two waits twice
  Kokkos::parallel_reduce("vug::pathways::look",
                          Kokkos::RangePolicy<Exec>(exec, 0, static_cast<int>(bonds_.strip.extent(0))),
                          LookAtBonds{nodes_, d_m, gap_, bonds_}, found);
  return found;
}

int PathwayOpener::open(const Exec& exec, const Kokkos::View<NodeType*>& type, const ScalarField<double>& volume,
                        const ScalarField<double>& dissolved) {
  const int candidates = static_cast<int>(nodes_.node.extent(0));
  int opened = 0;
  Kokkos::parallel_reduce("vug::pathways::mark", Kokkos::RangePolicy<Exec>(exec, 0, candidates),
                          MarkOpening{nodes_, bonds_.strip, type, opening_}, opened);
  if (opened == 0) return 0;
  if (volume.extent(0) > 0)
    spread_(exec, type, opening_, volume, dissolved);
  else
    for_each_node(exec, "vug::pathways::clear", candidates, ClearOpening{nodes_, opening_});
  return opened;
}

double PathwayOpener::return_solid(const Exec& exec, const Kokkos::View<NodeType*>& type,
                                   const ScalarField<double>& volume, const ScalarField<double>& dissolved) {
  if (!nodes_.cubic) return 0;  // rows of whole nodes take whole cells
  for_each_node(exec, "vug::pathways::unfilled", static_cast<int>(nodes_.node.extent(0)),
                MarkUnfilled{nodes_, type, opening_, volume});
  spread_.among_all(exec, type, opening_, volume, dissolved);
  return sum_in_order(spread_.waiting());
}

}  // namespace vug
