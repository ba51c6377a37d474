#include "coupling/ageing_module.hpp"

#include "coupling/ageing_looks.hpp"
#include "coupling/shared_field.hpp"
#include "io/each_boundary.hpp"
#include "kernels/launch/launch.hpp"

#include <limits>

namespace vug {

std::vector<double> moments_of(const Scene& scene) {
  std::vector<double> moments;
  const auto add = [&](const TimeTable& table) {
    moments.insert(moments.end(), table.moments().begin(), table.moments().end());
  };
  for_each_boundary(scene, [&](const BoundarySection& given) {
    given.flow.for_each_table(add);
    add(given.heat.temperature);
    add(given.heat.flux);
    for (const auto* tables : {&given.solute.concentration, &given.solute.flux})
      for (const auto& [species, table] : *tables) add(table);
  });
  std::sort(moments.begin(), moments.end());
  return moments;
}

void Ageing::take_in(const Look& look) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  residual_ = look.residual;
  paid_ += look.made;
  if (look.made > 0) error_ += (1 - 1 / factor_) * std::min(look.residual, 1.0) * look.made;
  if (factor_ == 1) waiting_ += look.steps;
  const double seen = std::max({look.still ? residual_ : infinite, look.loss, look.aged});
  const double next = std::min(next_factor(factor_, seen, tolerance_), look.most);
  if (next == 1 && factor_ > 1) ++waits_;
  factor_ = next;
  largest_ = std::max(largest_, factor_);
}

void Ageing::add_state(StateList& list) {
  list.add_value("ageing/factor", factor_, {1, largest_factor});
  list.add_value("ageing/largest", largest_, {1, largest_factor});
  list.add_value("ageing/paid", paid_);
  list.add_value("ageing/error", error_);
  list.add_value("ageing/waits", waits_, {0, most_steps});
  list.add_value("ageing/waiting", waiting_, {0, most_steps});
}

template <class T, class Set>
AgeingModule<T, Set>::AgeingModule(const Scene& scene, const Geometry& geometry, ReactionModule<T, Set>& reaction,
                                   const FlowModule<T>* flow)
    : Ageing(scene.accuracy.dissolution_tolerance),
      geometry_(geometry),
      reaction_(reaction),
      flow_(flow),
      interval_(look_interval(scene.accuracy)),
      moments_(moments_of(scene)),
      change_("vug::ageing::change", block_count(geometry.fluid.capacity)),
      compared_(geometry.fluid.count) {
  for (const Sway& sway : reaction.sways()) {
    Watched watched{sway, ScalarField<T>("vug::ageing::before", geometry.fluid.capacity)};
    Kokkos::deep_copy(watched.before, sway.species->fields.C);
    watched_.push_back(watched);
  }
}

template <class T, class Set>
double AgeingModule<T, Set>::unsteady(const Exec& exec) {
  const FluidNodes& fluid = geometry_.fluid;
  double volume = 0;
  for (const Watched& watched : watched_) {
    Kokkos::deep_copy(exec, change_, 0.0);
    add_change<T>(exec, fluid, watched.sway.species->fields.C, compared_, watched.before, change_);
    geometry_.split.make_whole(geometry_.split.of_blocks(), change_);
    volume += watched.sway.volume * sum_in_order(change_);
  }
  compared_ = fluid.count;
  return volume;
}

template <class T, class Set>
void AgeingModule<T, Set>::step(const Exec& exec, const Clock& clock) {
  if (!clock.every(interval_)) return;
  const double before = factor();
  const double paid = reaction_.paid(), made = paid - paid_before_;
  const double off = before * unsteady(exec);
  paid_before_ = paid;
  const double look = interval_ * clock.time_step, age = clock.time() + before * clock.time_step;  // after this step
  const double aged = before * look / (clock.time() + clock.time_step);
  // where nothing reacts although there is a wall, the acid has not reached it yet
  const double none = geometry_.surface.count > 0 ? std::numeric_limits<double>::infinity() : 0;
  const double residual = made > 0 ? off / made : none;
  take_in({made, residual, reaction_.largest_loss(exec), aged, !flow_ || flow_->settled(), interval_,
           factor_before(moments_, age, look)});
  if (factor() != before) reaction_.set_factor(exec, factor());
}

template <class T, class Set>
void AgeingModule<T, Set>::visit_shares(const SharedFields& visit) const {
  const Shares shares(geometry_.split.of_fluid(geometry_.fluid), 1, {});
  for (std::size_t w = 0; w < watched_.size(); ++w)
    visit("ageing/before" + std::to_string(w), watched_[w].before, shares);
}

template <class T, class Set>
void AgeingModule<T, Set>::births(const Exec& exec, const Births&) {
  for (Watched& watched : watched_) Kokkos::resize(exec, watched.before, geometry_.fluid.capacity);
  Kokkos::resize(exec, change_, block_count(geometry_.fluid.capacity));
}

template <class T, class Set>
void AgeingModule<T, Set>::state(StateList& list) {
  add_state(list);
  list.add_value("ageing/compared", compared_, {0, static_cast<double>(geometry_.fluid.count)});
  list.add_value("ageing/paid_before", paid_before_);
  visit_shares(SharedFields(geometry_.split.ranks(), &list));
}

template class AgeingModule<float, D2Q5>;
template class AgeingModule<float, D2Q9>;
template class AgeingModule<double, D2Q5>;
template class AgeingModule<double, D2Q9>;

}  // namespace vug
