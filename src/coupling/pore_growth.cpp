#include "coupling/pore_growth.hpp"

#include "kernels/launch/launch.hpp"
#include "kernels/reaction/dissolution.hpp"

namespace vug {

PoreGrowth::PoreGrowth(Geometry& geometry, std::unique_ptr<PathwayOpener> opener, ScalarField<double> d_m, Losses lost)
    : geometry_(geometry), opener_(std::move(opener)), d_m_(std::move(d_m)), lost_(std::move(lost)) {
  if (opener_) slits_.emplace(opener_->nodes());
}

int PoreGrowth::grow(const Exec& exec, const std::vector<std::unique_ptr<Module>>& modules) {
  FluidNodes& fluid = geometry_.fluid;
  int dissolved = 0, opened = 0;
  if (lost_.all.extent(0) > 0)
    dissolved =
        mark_dissolved(exec, fluid, geometry_.surface, geometry_.type, geometry_.volume, lost_.all, lost_.of_minerals);
  const PathwayOpener::Look look = opener_ ? opener_->look(exec, d_m_) : PathwayOpener::Look{};
  if (look.changed > 0) opened = opener_->open(exec, geometry_.type, geometry_.volume, geometry_.dissolved);
  if (dissolved + opened > 0) {
    Births births{fluid.count, fluid.count, opened > 0};
    append_births(exec, geometry_.type, fluid);
    geometry_.split.follow(fluid);
    births.last = fluid.count;
    find_surface(exec, fluid, geometry_.type, geometry_.surface);
    for (const auto& module : modules) module->births(exec, births);
    dissolved_nodes_ += dissolved;
    opened_nodes_ += opened;
  }
  // also without a change of the pathways, because acid widens the slits
  if (look.narrow > 0 || geometry_.slits.count > 0) slits_->update(exec, opener_->bonds(), geometry_);
  return dissolved + opened;
}

void PoreGrowth::ledger(Ledger& ledger, double pixel_volume) const {
  if (!opener_ || lost_.all.extent(0) == 0) return;
  double all = 0;
  for (int m = 0; m < opener_->parts(); ++m) {
    const double waiting = sum_in_order(opener_->waiting(m));
    all += waiting;
    if (lost_.names.empty() || lost_.names[m].empty()) continue;
    ledger.of(lost_.names[m] + "_volume", "m3/m").gains.push_back({"waiting", -pixel_volume * waiting});
  }
  ledger.of("solid_volume", "m3/m").gains.push_back({"waiting", -pixel_volume * all});
}

void PoreGrowth::state(StateList& list) {
  if (opener_)
    for (int m = 0; m < opener_->parts(); ++m)
      list.add(m == 0 ? "growth/waiting" : "growth/waiting/" + std::to_string(m), opener_->waiting(m));
  if (slits_) {
    slits_->state(list, below_a_cell());
    list.add("growth/widest", opener_->bonds().widest);
    if (opener_->follows_cracks()) list.add("growth/gap", opener_->gap());
    list.add_value("growth/slit_changes", geometry_.slit_changes, {0, most_steps});
  }
  const StateRange nodes{0, static_cast<double>(geometry_.lattice.size())};
  list.add_value("growth/dissolved_nodes", dissolved_nodes_, nodes);
  list.add_value("growth/opened_nodes", opened_nodes_, nodes);
}

}  // namespace vug
