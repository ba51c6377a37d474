// What the rock's mechanics report: limits, concerns, columns of the history, fields.
#include "coupling/mechanics_module.hpp"
#include "coupling/rock_fields.hpp"
#include "coupling/rock_limits.hpp"
#include "dem/monitors.hpp"
#include "dem/out_of_place.hpp"
#include "dem/pieces.hpp"

#include <fmt/format.h>

namespace vug {

template <class T>
void MechanicsModule<T>::limits(LimitTable& table) const {
  const double critical = mechanics_.critical_step();
  table.push_back({"mechanics", "sub-steps per lattice step", static_cast<double>(substeps_), "1", 1, 1e4,
                   "lower lattice.time_step or raise rock.element_size; where loads change slowly, as in rock that "
                   "cools for seconds, raise mechanics.mass_scaling"});
  table.push_back({"mechanics", "sub-step over its critical step", units_.time_step / substeps_ / critical, "1", 0, 0.5,
                   "raise mechanics.substeps or leave it out"});
  table.push_back(limit_of_edges(mechanics_, units_.spacing));
  if (warming_ > 0) table.push_back(limit_of_thermal_strain(mechanics_.parameters().thermal_expansion, warming_));
  if (!section_.initial_velocities.empty()) table.push_back(limit_of_initial_velocities(section_));
}

/// Thermal strain beyond that of the temperatures that the case names, which `vug check` has judged: from given
/// fluxes.
template <class T>
std::vector<Concern> MechanicsModule<T>::concerns(const Exec& exec) const {
  std::vector<Concern> concerns;
  const double expansion = mechanics_.parameters().thermal_expansion;
  if (heat_ && expansion * warming_ <= largest_small_strain) {
    const double strain = largest_thermal_strain(exec, mechanics_.particles(), expansion);
    if (strain > largest_small_strain)
      concerns.push_back({fmt::format("thermal strain above {:g}", largest_small_strain),
                          fmt::format(" ({:.3g} in the rock, {:.3g} of the temperatures that the case names): the "
                                      "mechanics are those of small strains; check heat fluxes and "
                                      "mechanics.thermal_expansion",
                                      strain, expansion * warming_)});
  }
  if (!wet_ && !heat_) return concerns;  // nothing on the lattice depends on where the rock is
  int moved = count_out_of_place(exec, mechanics_.particles());
  if (moved > 0 && section_.lets_fragments_go) {  // those of loose pieces go with the next update
    const auto loose = find_loose_pieces(mechanics_.particles(), mechanics_.bonds());
    moved = count_out_of_place(exec, mechanics_.particles(), to_device<IndexList>("vug::mechanics::loose", loose));
  }
  if (moved > 0)
    concerns.push_back({"rock is more than half a triangle from where the lattice has it",
                        fmt::format(": {}; fluid, heat and pathways do not follow it (mechanics.fragments)",
                                    moved == 1 ? "1 triangle" : fmt::format("{} triangles", moved))});
  return concerns;
}

template <class T>
void MechanicsModule<T>::history(std::vector<HistoryValue>& row) const {
  const BondCounts counts = mechanics_.bond_counts();
  row.push_back({"bonds_damaged_1", static_cast<double>(counts.damaged)});
  row.push_back({"bonds_failed_in_tension_1", static_cast<double>(counts.failed_in_tension)});
  row.push_back({"bonds_failed_in_shear_1", static_cast<double>(counts.failed_in_shear)});
  row.push_back({"bonds_dissolved_1", static_cast<double>(counts.dissolved)});
  if (dissolved_) {
    const LostWithRock lost = mechanics_.lost();
    row.push_back({"triangles_dissolved_1", static_cast<double>(lost.triangles)});
    if (section_.lets_fragments_go) row.push_back({"triangles_let_go_1", static_cast<double>(fragments_let_go())});
    row.push_back({"dissolved_rock_momentum_x_N_s_per_m", lost.momentum.x});
    row.push_back({"dissolved_rock_momentum_y_N_s_per_m", lost.momentum.y});
    row.push_back({"dissolved_rock_kinetic_energy_J_per_m", lost.kinetic});
    row.push_back({"dissolved_rock_elastic_energy_J_per_m", lost.elastic});
  }
  if (section_.parameters.rest_tolerance > 0) row.push_back({"rock_awake_1", mechanics_.awake_share()});
  const Energies energies = mechanics_.energies(Exec{});
  row.push_back({"kinetic_energy_J_per_m", energies.kinetic});
  row.push_back({"elastic_energy_J_per_m", energies.elastic});
  gauges_.history(row);
}

template <class T>
void MechanicsModule<T>::fields(FieldList& list) const {
  add_rock_fields(mechanics_, list, fields_asked_for_);
}

#define VUG_INSTANTIATE(T)                                                       \
  template void MechanicsModule<T>::limits(LimitTable&) const;                   \
  template std::vector<Concern> MechanicsModule<T>::concerns(const Exec&) const; \
  template void MechanicsModule<T>::history(std::vector<HistoryValue>&) const;   \
  template void MechanicsModule<T>::fields(FieldList&) const;
VUG_FOR_NUMBERS(VUG_INSTANTIATE)
#undef VUG_INSTANTIATE

}  // namespace vug
