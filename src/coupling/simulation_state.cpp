// The state of a simulation, which checkpoints hold, and the return to one.
#include "base/require.hpp"
#include "coupling/simulation.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace vug {

namespace {

constexpr StateRange node_types{0, static_cast<double>(NodeType::opening)};

StateRange nodes_of(const Geometry& geometry) {
  return {0, static_cast<double>(geometry.lattice.size()) - 1};
}

}  // namespace

StateList Simulation::geometry_state() {
  StateList list;
  list.add_value("clock/step", clock_.step, {0, most_steps});
  if (chooser_) chooser_->state(list);
  if (parts_->ageing) list.add_value("clock/ahead", clock_.ahead, {0, std::numeric_limits<double>::max()});
  fluid_count_ = parts_->geometry.fluid.count;
  fluid_capacity_ = parts_->geometry.fluid.capacity;
  const StateRange room{static_cast<double>(fluid_count_), 2.0 * static_cast<double>(parts_->geometry.lattice.size())};
  list.add_value("geometry/count", fluid_count_, room);  // the number of fluid nodes never falls
  list.add_value("geometry/capacity", fluid_capacity_, room);
  return list;
}

StateList Simulation::state() {
  gather();
  StateList list = geometry_state();
  Geometry& geometry = parts_->geometry;
  list.add("geometry/type", geometry.type, node_types);
  if (fluid_count_ > 0)
    list.add("geometry/node", Kokkos::subview(geometry.fluid.node, std::pair(0, fluid_count_)), nodes_of(geometry));
  for (const auto& module : parts_->modules) module->state(list);
  if (parts_->growth) parts_->growth->state(list);
  return list;
}

void Simulation::require_possible(const Kokkos::View<NodeType*>& type, const IndexList& node) const {
  const Geometry& geometry = parts_->geometry;
  const auto before = on_host(geometry.type);
  const auto now = on_host(type);
  const auto list = on_host(node);
  const auto require = [](bool possible) {
    if (!possible) throw FileError("the checkpoint's fluid nodes are none that this rock can have");
  };
  require(fluid_capacity_ >= fluid_count_);
  const Lattice& lattice = geometry.lattice;
  std::vector<bool> grows(lattice.size(), false), listed(lattice.size(), false);
  for (int y = 0; y < lattice.ny; ++y)
    for (int x = 0; x < lattice.nx; ++x) {
      const int n = lattice.node(x, y);
      grows[n] = before(n) == NodeType::solid && now(n) == NodeType::fluid;
    }
  for (std::size_t n = 0; n < now.extent(0); ++n) require(now(n) == before(n) || grows[n]);
  for (int i = 0; i < fluid_count_; ++i) {
    const int n = list(i);
    require(now(n) == NodeType::fluid && !listed[n]);
    listed[n] = true;
  }
}

void Simulation::restore(const std::function<void(StateList&)>& load) {
  catch_up();
  Geometry& geometry = parts_->geometry;
  StateList header = geometry_state();
  load(header);
  if (fluid_count_ > 0) {
    const Births births{std::min(geometry.fluid.count, fluid_count_), fluid_count_};
    StateList list;
    IndexList node("vug::geometry::node", fluid_count_);
    const Kokkos::View<NodeType*> type("vug::geometry::type", geometry.type.extent(0));
    list.add("geometry/type", type, node_types);
    list.add("geometry/node", node, nodes_of(geometry));
    load(list);
    require_possible(type, node);
    Kokkos::deep_copy(geometry.type, type);
    set_fluid_nodes(exec_, node, fluid_capacity_, geometry.fluid);
    geometry.split.follow(geometry.fluid);
    find_surface(exec_, geometry.fluid, geometry.type, geometry.surface);
    for (const auto& module : parts_->modules) module->births(exec_, births);
  }
  StateList everything = state();
  load(everything);
  give_back();
  if (parts_->growth) parts_->growth->restored(exec_);
  if (!chooser_) return;
  for (const auto& module : parts_->modules) module->resume(exec_, chooser_->now());
  update_interval_ = chooser_->now().update;
}

}  // namespace vug
