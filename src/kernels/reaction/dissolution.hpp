#pragma once
// From a pixel that has dissolved to a fluid node (volume of pixel, paper section 3.3): called at a fixed small
// interval, between two lattice steps, as
//   mark_dissolved -> append_births -> find_surface -> per species
//   fit_to_capacity -> settle -> initialise_births.
#include "base/choices.hpp"
#include "kernels/solute/solute.hpp"

#include <vector>

namespace vug {

/// Overdrafts that are lost when pixels dissolve, by mineral.
struct MineralLosses {
  Kokkos::View<const std::uint8_t*> of_node;  ///< (dense node); empty: one mineral
  std::vector<ScalarField<double>> lost;      ///< (mineral) its part of `lost` of mark_dissolved
};

/// Turns every surface node with V <= 0 into fluid and returns how many (0: nothing else was touched; waits for the
/// device). The overdraft of a pixel, -V, is taken in equal shares from its solid neighbours (of eight), however many
/// pixels dissolve at once and whatever their order; where no solid is left, lost(block) += V (negative). V of the new
/// fluid nodes is 0: sum V + lost is unchanged.
/// `lost` has at least block_count(surface.count) entries. With `minerals` only neighbours of the same mineral take
/// shares, since no mineral turns into another, and minerals.lost[m](block) gets the part of `lost` that belongs to
/// mineral m.
int mark_dissolved(const Exec& exec, const FluidNodes& nodes, const Surface& surface,
                   const Kokkos::View<NodeType*>& type, const ScalarField<double>& V, const ScalarField<double>& lost,
                   const MineralLosses& minerals = {});

/// Fills the newborn fluid nodes [first, last) with one species, at rest, from their old fluid neighbours along the
/// velocity set; a newborn without any gets none. Newborns side by side do not read each other: the result does not
/// depend on their order. created(block) += solute that came from nowhere (mean); block_count(last) entries at least.
template <class Set, class T>
void initialise_births(const Exec& exec, const FluidNodes& nodes, int first, int last, BirthFill fill,
                       SoluteFields<T>& s, const ScalarField<double>& created);

}  // namespace vug
