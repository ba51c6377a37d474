// The flow on several ranks (docs/scaling.md): what they exchange, and what all of them know.
#include "coupling/flow_module.hpp"
#include "coupling/flow_paths.hpp"
#include "coupling/shared_field.hpp"
#include "kernels/launch/launch.hpp"
#include "kernels/nodes/fluid_nodes.hpp"

#include <limits>

namespace vug {

namespace {

/// Whether the populations that enter come from a condition, not from bounce-back or the opposite side.
bool is_dressed(const StretchLinks& boundary) {
  const FlowBoundary& flow = boundary.stretch.conditions.flow;
  if (boundary.slides) return true;
  return flow.kind != FlowBoundaryKind::periodic && (flow.kind != FlowBoundaryKind::wall || flow.peak_speed() != 0);
}

/// Adds the nodes at links and the nodes behind them that are not rock: an outflow depends on the velocities of all.
void add_nodes_at(const FluidNodes& fluid, const BoundaryLinks& links, std::vector<int>& nodes) {
  const auto source = on_host(fluid.source), node = on_host(links.fluid);
  const auto direction = on_host(links.direction);
  for (int link = 0; link < links.count; ++link) {
    nodes.push_back(node(link));
    const int behind = upstream_node(source, fluid.capacity, direction(link), nodes.back());
    if (behind >= 0) nodes.push_back(behind);
  }
}

}  // namespace

template <class T>
void FlowModule<T>::find_halos() {
  const Split& split = geometry_.split;
  if (split.alone()) return;
  const FluidNodes& fluid = geometry_.fluid;
  std::vector<int> slots, nodes;
  for (StretchLinks& boundary : boundaries_) {
    if (!is_dressed(boundary)) continue;
    split.share_out(boundary.links, boundary.mirror);
    const auto node = on_host(boundary.links.fluid), own = on_host(boundary.links.own);
    const auto direction = on_host(boundary.links.direction);
    for (int k = 0; k < boundary.links.own_count; ++k) {
      nodes.push_back(node(own(k)));
      slots.push_back(direction(own(k)) * fluid.capacity + nodes.back());
    }
    if (boundary.past.extent(0) > 0) {
      const auto past = on_host(boundary.past);
      for (int e = 0; e < 2; ++e) {
        if (past(e).fluid < 0 || split.owner_of(node(past(e).link)) != split.ranks().rank()) continue;
        nodes.push_back(past(e).fluid);
        slots.push_back(past(e).direction * fluid.capacity + past(e).fluid);
      }
    }
    const bool outflow = boundary.outflow.along.extent(0) > 0;
    if (outflow && boundary.links.own_count > 0) add_nodes_at(fluid, boundary.links, nodes);
  }
  populations_ = split.populations(fluid, D2Q9::Q);
  dressed_ = split.slots(fluid, slots);
  velocities_ = split.around(fluid, nodes);
  in_rows_ = split.in_rows(fluid);
  if (excess_.extent(0) > 0) around_ = split.populations_around(fluid);
}

template <class T>
void FlowModule<T>::bring_to_all_links(const Exec& exec) const {
  const Split& split = geometry_.split;
  if (split.alone()) return;
  const FluidNodes& fluid = geometry_.fluid;
  std::vector<int> slots, nodes;
  for (const StretchLinks& boundary : boundaries_) {
    const auto node = on_host(boundary.links.fluid);
    const auto direction = on_host(boundary.links.direction);
    for (int link = 0; link < boundary.links.count; ++link)
      slots.push_back(direction(link) * fluid.capacity + node(link));
    add_nodes_at(fluid, boundary.links, nodes);
  }
  split.slots(fluid, slots).template exchange<T, 1>(exec, {fields_.f});
  split.slots(fluid, nodes).template exchange<T, 2>(exec, components(fields_.u));
  gather_sums();
}

template <class T>
void FlowModule<T>::visit_shares(const SharedFields& visit) const {
  const Owners nodes = geometry_.split.of_fluid(geometry_.fluid);
  visit("flow/f", fields_.f, Shares(nodes, D2Q9::Q, {populations_, dressed_, around_}));
  visit("flow/u", fields_.u, Shares::of_vector(nodes, {velocities_}));
  for (std::size_t c = 0; c < carriers_.size(); ++c)  // in the order in which the modules requested them
    visit("flow/carrier" + std::to_string(c) + "/e", carriers_[c].e, Shares(nodes, 1, {in_rows_}));
}

template <class T>
void FlowModule<T>::gather(const Exec& exec) {
  return_populations(exec);
  geometry_.split.make_whole(geometry_.split.of_blocks(), step_.limited);
  gather_sums();
}

template <class T>
void FlowModule<T>::gather_sums() const {
  const Split& split = geometry_.split;
  if (split.alone()) return;
  for (const StretchLinks& boundary : boundaries_) {
    const BoundaryLinks& links = boundary.links;
    split.make_whole(split.of_links(links), boundary.gain);
    const ScalarField<double>& level = boundary.outflow.level;
    if (level.extent(0) == 0 || links.count == 0) continue;
    Owners owners(split.ranks().size());  // the owner of the first link has dressed links, so that it knows the level
    const int first = on_host(Kokkos::subview(links.fluid, std::pair(0, 1)))(0);
    owners[split.owner_of(first)] = {{0, static_cast<int>(level.extent(0))}};
    split.make_whole(owners, level);
  }
}

template <class T>
void FlowModule<T>::return_populations(const Exec& exec) const {
  if (fields_.turned) populations_.template exchange_back<T, 1>(exec, {fields_.f});
}

template <class T>
double FlowModule<T>::sum_mass() const {
  const ScalarField<double> partial("vug::flow::partial", block_count(geometry_.fluid.count));
  add_mass(Exec{}, geometry_.fluid, fields_, partial);
  geometry_.split.make_whole(geometry_.split.of_blocks(), partial);
  return sum_in_order(partial);
}

template <class T>
double FlowModule<T>::mass() const {
  return_populations(Exec{});
  return sum_mass();
}

template <class T>
FlowExtremes FlowModule<T>::extremes(const Exec& exec) const {
  const Ranks& ranks = geometry_.split.ranks();
  FlowExtremes found = flow_extremes(exec, geometry_.fluid, fields_, speed_bound, density_bound);
  found.speed = ranks.most(found.speed);
  found.density = ranks.most(found.density);
  const int none = std::numeric_limits<int>::max(), first = ranks.least(found.bad < 0 ? none : found.bad);
  found.bad = first == none ? -1 : first;
  return found;
}

#define VUG_INSTANTIATE(T)                                              \
  template void FlowModule<T>::find_halos();                            \
  template void FlowModule<T>::gather(const Exec&);                     \
  template void FlowModule<T>::visit_shares(const SharedFields&) const; \
  template void FlowModule<T>::gather_sums() const;                     \
  template void FlowModule<T>::bring_to_all_links(const Exec&) const;   \
  template void FlowModule<T>::return_populations(const Exec&) const;   \
  template double FlowModule<T>::sum_mass() const;                      \
  template double FlowModule<T>::mass() const;                          \
  template FlowExtremes FlowModule<T>::extremes(const Exec&) const;
VUG_FOR_NUMBERS(VUG_INSTANTIATE)
#undef VUG_INSTANTIATE

}  // namespace vug
