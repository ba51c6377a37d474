#include "coupling/simulation.hpp"

#include "coupling/read_fields.hpp"
#include "coupling/shared_field.hpp"
#include "kernels/reaction/solid_share.hpp"
#include "ranks/traffic.hpp"

namespace vug {

namespace {

/// The scene with intervals of one lattice step, where they are chosen during the run.
Scene with_first_intervals(Scene scene) {
  AccuracySection& accuracy = scene.accuracy;
  if (accuracy.chooses_intervals())
    accuracy.heat_interval = accuracy.solute_interval = accuracy.wall_interval = accuracy.exchange_interval =
        accuracy.update_interval = 1;
  return scene;
}

}  // namespace

Simulation::Simulation(const Scene& scene, const Ranks& ranks)
    : scene_(with_first_intervals(scene)),
      clock_{0, scene.lattice.time_step},
      update_interval_(scene_.accuracy.update_interval),
      parts_(build_modules(exec_, scene_, ranks)) {
  give_back();
  if (!scene.accuracy.chooses_intervals()) return;
  Intervals most = longest_intervals(scene.accuracy);
  for (const auto& module : parts_->modules) module->bound(0, most);
  Intervals safe = most;
  for (const auto& module : parts_->modules) module->bound(std::nullopt, safe);
  chooser_.emplace(scene, most, safe);
}

void Simulation::begin() {
  for (const auto& module : parts_->modules) module->begin(exec_);
}

void Simulation::step() {
  const double factor = parts_->ageing ? parts_->ageing->factor() : 1;  // before a module changes it for the next step
  const Ranks& ranks = parts_->geometry.split.ranks();
  if (chooser_) choose_intervals();
  for (const auto& module : parts_->modules) {
    const Phase phase(ranks, module->name());
    module->step(exec_, clock_);
  }
  ++clock_.step;
  clock_.ahead += (factor - 1) * clock_.time_step;
  whole_ = false;
  if (!parts_->growth || clock_.step % update_interval_ != 0) return;
  const Phase phase(ranks, "new pores");
  const std::int64_t opened = parts_->growth->opened_nodes();
  const int capacity = parts_->geometry.fluid.capacity;
  parts_->growth->grow(exec_, parts_->modules);
  if (parts_->geometry.fluid.capacity != capacity) give_back();
  if (chooser_ && parts_->growth->opened_nodes() > opened) chooser_->be_wary();
}

void Simulation::choose_intervals() {
  if (chooser_->due(clock_)) {
    const Phase phase(parts_->geometry.split.ranks(), "intervals");
    Changes changes;
    for (const auto& module : parts_->modules) module->watch(exec_, clock_, changes);
    Intervals stable = chooser_->most();
    for (const auto& module : parts_->modules) module->bound(changes.speed, stable);
    if (!chooser_->choose(changes, stable, clock_)) return;
  } else if (!chooser_->shorten(clock_)) {
    return;
  }
  for (const auto& module : parts_->modules) module->take(exec_, chooser_->now());
  update_interval_ = chooser_->now().update;
}

Intervals Simulation::intervals() const {
  const AccuracySection& given = scene_.accuracy;
  return chooser_ ? chooser_->now()
                  : Intervals{given.heat_interval, given.solute_interval, given.wall_interval, given.exchange_interval,
                              given.update_interval};
}

void Simulation::catch_up() const {
  for (const auto& module : parts_->modules) module->catch_up(exec_);
}

void Simulation::gather() const {
  catch_up();
  if (parts_->geometry.split.alone() || whole_) return;
  const Phase phase(parts_->geometry.split.ranks(), "gathering");
  for (const auto& module : parts_->modules) module->gather(exec_);
  whole_ = true;
}

void Simulation::give_back() {
  if (parts_->geometry.split.alone()) return;
  const SharedFields shared(parts_->geometry.split.ranks());
  for (const auto& module : parts_->modules) module->visit_shares(shared);
}

void Simulation::guard() {
  catch_up();
  const Phase phase(parts_->geometry.split.ranks(), "guards");
  for (const auto& module : parts_->modules) module->guard(exec_, clock_);
}

double Simulation::updates_per_step() const {
  const Geometry& geometry = parts_->geometry;
  double updates = 0;
  if (scene_.flow) updates += geometry.fluid.count;
  if (scene_.heat) updates += static_cast<double>(geometry.lattice.nx) * geometry.lattice.ny / intervals().heat;
  if (scene_.solute)
    updates += static_cast<double>(scene_.solute->species.size()) * geometry.fluid.count / intervals().solute;
  return updates;
}

LimitTable Simulation::limits() const {
  catch_up();
  LimitTable table;
  for (const auto& module : parts_->modules) module->limits(table);
  return table;
}

std::vector<Task> Simulation::schedule() const {
  std::vector<Task> tasks;
  for (const auto& module : parts_->modules) module->tasks(tasks);
  if (parts_->growth)
    tasks.push_back({"new pores: dissolved nodes, opened pathways, newborn fluid",
                     update_interval_,
                     {"reaction/volume", "mechanics/d_m"},
                     {"geometry", "growth"},
                     {}});
  return tasks;
}

Ledger Simulation::ledger() const {
  catch_up();
  Ledger ledger;
  for (const auto& module : parts_->modules) module->ledger(ledger);
  if (parts_->growth) parts_->growth->ledger(ledger, parts_->units.volume());
  return ledger;
}

std::vector<HistoryValue> Simulation::history() const {
  catch_up();
  const Phase phase(parts_->geometry.split.ranks(), "rows");
  std::vector<HistoryValue> row{{"time_s", clock_.time()}, {"step_1", static_cast<double>(clock_.step)}};
  for (const auto& module : parts_->modules) module->history(row);
  if (chooser_) chooser_->history(row);
  if (scene_.output.forces || scene_.output.flows)
    for (const auto& module : parts_->modules) module->surfaces(clock_, scene_.output, row);
  if (parts_->growth) {
    row.push_back({"nodes_dissolved_1", static_cast<double>(parts_->growth->dissolved_nodes())});
    row.push_back({"nodes_opened_by_damage_1", static_cast<double>(parts_->growth->opened_nodes())});
    if (const int slits = parts_->growth->slit_nodes(); slits >= 0)
      row.push_back({"slit_nodes_1", static_cast<double>(slits)});
  }
  for (const Balance& balance : ledger().balances) {
    std::string unit = balance.unit;
    if (const auto slash = unit.find('/'); slash != std::string::npos) unit.replace(slash, 1, "_per_");
    const auto column = [&](const std::string& what) { return balance.quantity + "_" + what + "_" + unit; };
    row.push_back({column("initial"), balance.initial});
    row.push_back({column("stored"), balance.stored});
    for (const Balance::Term& gain : balance.gains) row.push_back({column("gain_" + gain.name), gain.value});
    row.push_back({balance.quantity + "_balance_error_1", balance.relative_error()});
  }
  return row;
}

FieldList Simulation::fields() const {
  catch_up();
  FieldList list;
  const Geometry& geometry = parts_->geometry;
  if (geometry.mineral.extent(0) > 0)
    list.lattice.push_back({"mineral", "1", 1, [&geometry] { return read_mineral(geometry); }});
  for (const auto& module : parts_->modules) module->fields(list);
  list.lattice.push_back({"node_type", "1", 1, [&geometry] { return read_type(geometry); }});
  list.lattice.push_back({"solid_fraction", "1", 1, [&geometry] {
                            return geometry.volume.extent(0) > 0 ? read_solid(geometry, solid_share)
                                                                 : read_solid(geometry);
                          }});
  return list;
}

}  // namespace vug
