// Solutes on one rank among others (docs/scaling.md): what it gets from them, and what all ranks know.
#include "coupling/shared_field.hpp"
#include "coupling/solute_module.hpp"
#include "coupling/sum_state.hpp"
#include "kernels/launch/launch.hpp"
#include "kernels/nodes/fluid_nodes.hpp"

namespace vug {

template <class T, class Set>
void SoluteModule<T, Set>::find_halos() {
  populations_ = geometry_.split.populations(geometry_.fluid, Set::Q);
  neighbours_ = geometry_.split.around(geometry_.fluid, {});
  if (geometry_.split.alone()) return;
  for (SpeciesState<T>& s : species_)
    for (StretchLinks& boundary : s.boundaries) geometry_.split.share_out(boundary.links);
  before_outflow_ = geometry_.split.slots(geometry_.fluid, nodes_before_outflow());
}

template <class T, class Set>
std::vector<int> SoluteModule<T, Set>::nodes_before_outflow() const {
  std::vector<int> nodes;
  const auto source = on_host(geometry_.fluid.source);
  for (const StretchLinks& boundary : species_[0].boundaries) {  // all species have the same links
    if (boundary.stretch.conditions.solute.kind != SoluteBoundaryKind::outflow) continue;
    const auto fluid = on_host(boundary.links.fluid), own = on_host(boundary.links.own);
    const auto direction = on_host(boundary.links.direction);
    for (int k = 0; k < boundary.links.own_count; ++k) {
      const int before = upstream_node(source, geometry_.fluid.capacity, direction(own(k)), fluid(own(k)));
      if (before >= 0) nodes.push_back(before);
    }
  }
  return nodes;
}

template <class T, class Set>
void SoluteModule<T, Set>::exchange(const Exec& exec, const SoluteFields<T>& fields) const {
  if (fields.turned)
    populations_.template exchange_back<T, 1>(exec, {fields.h});
  else
    populations_.template exchange<T, 1>(exec, {fields.h});
}

template <class T, class Set>
void SoluteModule<T, Set>::visit_shares(const SharedFields& visit) const {
  const Owners nodes = geometry_.split.of_fluid(geometry_.fluid);
  for (const SpeciesState<T>& s : species_) {
    const std::string key = "solute/" + s.section.name;
    visit(key + "/h", s.fields.h, Shares(nodes, Set::Q, {populations_}));
    visit(key + "/C", s.fields.C, Shares(nodes, 1, {before_outflow_, neighbours_}));
    if (s.watched.extent(0) > 0) visit(key + "/watched", s.watched, Shares(nodes, 1, {}));
  }
}

template <class T, class Set>
void SoluteModule<T, Set>::gather(const Exec& exec) {
  for (const SpeciesState<T>& s : species_) {
    if (s.fields.turned) exchange(exec, s.fields);
    gather_sums(s);
  }
}

template <class T, class Set>
void SoluteModule<T, Set>::gather_sums(const SpeciesState<T>& s) const {
  const Split& split = geometry_.split;
  if (split.alone()) return;
  split.make_whole(split.of_blocks(s.correction.recent().extent(0)), s.correction);
  for (const StretchLinks& boundary : s.boundaries) split.make_whole(split.of_links(boundary.links), boundary.gain);
}

template <class T, class Set>
double SoluteModule<T, Set>::total(const SpeciesState<T>& s) const {
  if (s.fields.turned) exchange(Exec{}, s.fields);
  const ScalarField<double> partial("vug::solute::partial", block_count(geometry_.fluid.count));
  add_solute<Set>(Exec{}, geometry_.fluid, s.fields, partial);
  geometry_.split.make_whole(geometry_.split.of_blocks(), partial);
  return sum_in_order(partial);
}

#define VUG_INSTANTIATE(T, Set)                                                            \
  template void SoluteModule<T, Set>::find_halos();                                        \
  template void SoluteModule<T, Set>::exchange(const Exec&, const SoluteFields<T>&) const; \
  template std::vector<int> SoluteModule<T, Set>::nodes_before_outflow() const;            \
  template void SoluteModule<T, Set>::gather(const Exec&);                                 \
  template void SoluteModule<T, Set>::visit_shares(const SharedFields&) const;             \
  template void SoluteModule<T, Set>::gather_sums(const SpeciesState<T>&) const;           \
  template double SoluteModule<T, Set>::total(const SpeciesState<T>&) const;
VUG_FOR_NUMBERS_AND_SETS(VUG_INSTANTIATE)
#undef VUG_INSTANTIATE

}  // namespace vug
