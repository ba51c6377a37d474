#include "coupling/build_modules.hpp"

#include "coupling/ageing_module.hpp"
#include "coupling/flow_module.hpp"
#include "coupling/heat_module.hpp"
#include "coupling/mechanics_module.hpp"
#include "coupling/memory_need.hpp"
#include "coupling/minerals.hpp"
#include "coupling/reaction_module.hpp"
#include "coupling/solute_module.hpp"

#include <algorithm>

namespace vug {

LatticeUnits units_of(const Scene& scene) {
  LatticeUnits units;
  units.spacing = scene.lattice.spacing;
  units.time_step = scene.lattice.time_step;
  if (scene.flow) {
    units.fluid_density = scene.flow->density;
    units.reference_pressure = scene.flow->initial_pressure;
    units.pressure_scale = scene.flow->pressure_scale;
  }
  if (scene.heat) units.reference_temperature = scene.heat->initial_temperature;
  if (scene.solute) {
    double largest = 0;
    for (const Species& species : scene.solute->species) largest = std::max(largest, species.initial);
    for (const Stretch& stretch : boundary_stretches(scene))
      for (const auto& [name, value] : stretch.conditions.solute.concentration)
        largest = std::max(largest, value.highest());
    for (const OpeningSection& opening : scene.openings)
      for (const auto& [name, value] : opening.conditions.solute.concentration)
        largest = std::max(largest, value.highest());
    if (largest > 0) units.concentration = largest;
  }
  return units;
}

namespace {

/// Node types from masks (row by row without halo); the halo is solid. `opening` is empty or from opening_of_nodes.
Kokkos::View<NodeType*> node_types(const Lattice& lattice, const std::vector<bool>& solid,
                                   const std::vector<int>& opening) {
  Kokkos::View<NodeType*> type("vug::geometry::type", lattice.size());
  const auto host = Kokkos::create_mirror_view(type);
  Kokkos::deep_copy(host, NodeType::solid);
  for (int y = 0; y < lattice.ny; ++y)
    for (int x = 0; x < lattice.nx; ++x) {
      const std::size_t n = static_cast<std::size_t>(y) * lattice.nx + x;
      if (!solid[n]) host(lattice.node(x, y)) = NodeType::fluid;
      if (!opening.empty() && opening[n] >= 0) host(lattice.node(x, y)) = NodeType::opening;
    }
  Kokkos::deep_copy(type, host);
  return type;
}

std::int64_t count_fluid(const Geometry& geometry) {
  const auto type = on_host(geometry.type);
  return std::count(type.data(), type.data() + type.size(), NodeType::fluid);
}

template <class T, class Set>
void build_physics(const Exec& exec, const Scene& scene, Parts& parts) {
  FlowModule<T>* flow = nullptr;
  HeatModule<T>* heat = nullptr;
  const auto add = [&]<class M>(std::unique_ptr<M> module) {
    M* pointer = module.get();
    parts.modules.push_back(std::move(module));
    return pointer;
  };
  Geometry& geometry = parts.geometry;
  std::unique_ptr<PathwayOpener> opener;
  if (scene.mechanics && scene.damage && geometry.fluid.count > 0)
    opener = std::make_unique<PathwayOpener>(
        geometry.lattice, parts.rock->pathways,
        SolidSpread(parts.rock->nodes_of_particle, parts.rock->neighbours,
                    MineralNodes{geometry.mineral, static_cast<int>(scene.minerals.size()) + 1}));
  if (scene.flow) flow = add(std::make_unique<FlowModule<T>>(exec, scene, parts.units, geometry, parts.paths));
  if (scene.heat) heat = add(std::make_unique<HeatModule<T>>(exec, scene, parts.units, geometry, flow));
  std::unique_ptr<SoluteModule<T, Set>> solutes;
  if (scene.solute) solutes = std::make_unique<SoluteModule<T, Set>>(exec, scene, parts.units, geometry, flow);
  ReactionModule<T, Set>* reaction = nullptr;
  if (scene.reaction)
    reaction =
        add(std::make_unique<ReactionModule<T, Set>>(exec, scene, parts.units, geometry, *solutes, heat, opener.get()));
  if (solutes) add(std::move(solutes));
  if (scene.accuracy.dissolution_tolerance > 0)
    parts.ageing = add(std::make_unique<AgeingModule<T, Set>>(scene, geometry, *reaction, flow));
  if (reaction) add(std::make_unique<TurnoverModule<T, Set>>(*reaction, scene.accuracy.update_interval));

  ScalarField<double> d_m;
  if (scene.mechanics) {
    const auto* mechanics =
        add(std::make_unique<MechanicsModule<T>>(exec, scene, parts.units, geometry, *parts.rock, flow, heat));
    parts.mechanics = &mechanics->mechanics();
    parts.fragments_let_go = [mechanics] { return mechanics->fragments_let_go(); };
    d_m = mechanics->mechanics().bonds().d_m;
    if (opener && scene.damage->aperture == ApertureLaw::opening)
      opener->follow_cracks(mechanics->mechanics(), scene.damage->residual_aperture, geometry.spacing);
  }
  const bool dissolves = reaction && rock_dissolves(scene);
  if (!dissolves && !opener) return;
  parts.growth = std::make_unique<PoreGrowth>(geometry, std::move(opener), d_m,
                                              reaction ? reaction->losses() : PoreGrowth::Losses{});
}

}  // namespace

std::vector<double> row_weights(const Scene& scene, const Geometry& geometry) {
  const auto moved = [](ScalarVelocitySet set, int interval) {
    return static_cast<double>(set == ScalarVelocitySet::d2q9 ? D2Q9::Q : D2Q5::Q) / interval;
  };
  const AccuracySection& accuracy = scene.accuracy;
  const double dense = scene.heat ? moved(scene.heat->velocity_set, accuracy.heat_interval) : 0;
  double fluid = scene.flow ? D2Q9::Q : 0;
  if (scene.solute)
    fluid +=
        static_cast<double>(scene.solute->species.size()) * moved(scene.solute->velocity_set, accuracy.solute_interval);
  const Lattice& lattice = geometry.lattice;
  std::vector<double> weights(lattice.ny, dense * lattice.nx);
  const auto node = on_host(geometry.fluid.node);
  for (int i = 0; i < geometry.fluid.count; ++i) weights[lattice.y(node(i))] += fluid;
  return weights;
}

std::unique_ptr<Parts> build_modules(const Exec& exec, const Scene& scene, const Ranks& ranks) {
  require_memory_of_lattice(scene);
  auto parts = std::make_unique<Parts>();
  parts->units = units_of(scene);
  Geometry& geometry = parts->geometry;
  geometry.lattice = Lattice(scene.lattice.nx, scene.lattice.ny);
  geometry.spacing = scene.lattice.spacing;
  if (scene.geometry.kind == GeometryKind::rock) {
    parts->rock = build_rock(scene, geometry.lattice);
    geometry.type = node_types(geometry.lattice, parts->rock->solid, opening_of_nodes(scene));
    geometry.mineral = mineral_field(geometry.lattice, parts->rock->mineral);
  } else {
    DrawnRock drawn = drawn_rock(scene);
    parts->warning = drawn.warning;
    const std::vector<int> opening = opening_of_nodes(scene);
    geometry.type = node_types(geometry.lattice, drawn.solid, opening);
    for (std::size_t n = 0; n < opening.size(); ++n)
      if (opening[n] >= 0) drawn.solid[n] = false;
    geometry.mineral =
        mineral_field(geometry.lattice, mineral_of_nodes(scene, drawn.solid, std::move(drawn.of_label), nullptr));
  }
  geometry.openings = make_openings(scene, geometry.lattice);
  if (scene.flow || scene.solute) {
    require_memory_of_fluid(scene, count_fluid(geometry));
    geometry.fluid = make_fluid_nodes(exec, geometry.lattice, geometry.type, periodic_sides(scene));
    find_surface(exec, geometry.fluid, geometry.type, geometry.surface);
    parts->paths = find_flow_paths(scene, geometry, parts->units);
  }
  if (!ranks.alone()) {
    geometry.split = Split(ranks, row_weights(scene, geometry));
    geometry.split.follow(geometry.fluid);
  }
  const bool paper_set = scene.solute && scene.solute->velocity_set == ScalarVelocitySet::d2q9;
  const bool single = scene.accuracy.precision == Precision::single_precision;
  if (single)
    paper_set ? build_physics<float, D2Q9>(exec, scene, *parts) : build_physics<float, D2Q5>(exec, scene, *parts);
  else
    paper_set ? build_physics<double, D2Q9>(exec, scene, *parts) : build_physics<double, D2Q5>(exec, scene, *parts);
  return parts;
}

}  // namespace vug
