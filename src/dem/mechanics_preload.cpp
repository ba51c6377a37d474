// Brings the rock to rest under its loads before a run begins.
#include "dem/mechanics.hpp"
#include "dem/static_equilibrium.hpp"
#include "ranks/stop.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <type_traits>
#include <vector>

namespace vug {

namespace {

constexpr double at_rest =
    1e-9;  // kinetic over elastic energy: the relative oscillation of the stress is its square root
constexpr long shortest_look = 16;            // steps: checking the energies costs as much as two
constexpr long steps_between_questions = 16;  // to other ranks, whether they are to stop
constexpr int looks_at_rest = 3;  // in a row, a fifth of the ramp apart: this excludes turning points of an oscillation
constexpr int longest_settling = 50;       // times the ramp, or
constexpr double longest_crossings = 500;  // of sound through the rock, if that is longer
constexpr double shortest_ramp = 2;        // crossings: a load applied at once overshoots to twice itself

}  // namespace

void Mechanics::end_if_asked(long step) const {
  if (ranks_.alone() || step % steps_between_questions == 0) throw_if_any_is_to_stop(ranks_);
}

double Mechanics::kinetic_over_elastic(const Exec& exec) const {
  const Energies e = energies(exec);
  return e.kinetic == 0 ? 0 : e.kinetic / e.elastic;
}

long Mechanics::ramp(const Exec& exec, double dt, double ramp_time, double damping) {
  const long steps = std::max(1L, std::lround(ramp_time / dt));
  for (long s = 0; s < steps; ++s) {
    end_if_asked(s);
    step(exec, {dt, damping, parameters_.mass_scaling, static_cast<double>(s + 1) / static_cast<double>(steps), 0});
  }
  return steps;
}

PreloadReport Mechanics::preload(const Exec& exec, double ramp_time, double damping) {
  follow_temperature(exec);
  const double dt = 0.3 * critical_step();
  const StepControl settle{dt, damping, parameters_.mass_scaling, 1, 0};
  PreloadReport report;
  report.steps = ramp(exec, dt, std::max(ramp_time, shortest_ramp * sound_crossing_), damping);
  const long look = std::max(shortest_look, report.steps / 5);
  const long settling =
      std::max(longest_settling * report.steps, std::lround(longest_crossings * sound_crossing_ / dt));
  const long last = report.steps + settling;
  int rested = 0;
  while (rested < looks_at_rest && report.steps < last) {
    for (long s = 0; s < look; ++s) {
      end_if_asked(s);
      step(exec, settle);
    }
    report.steps += look;
    report.kinetic_over_elastic = kinetic_over_elastic(exec);
    rested = report.kinetic_over_elastic < at_rest ? rested + 1 : 0;
  }
  report.settled = rested == looks_at_rest;
  report.time = static_cast<double>(report.steps) * dt;
  report.crossings = report.time / sound_crossing_;
  report.bonds = bond_counts();
  Kokkos::deep_copy(exec, particles_.v, 0.0);
  Kokkos::deep_copy(exec, particles_.spin, 0.0);
  take_as_reference(exec);
  ramped_ = report;
  return report;
}

void Mechanics::take_as_reference(const Exec& exec) {
  Kokkos::deep_copy(exec, particles_.u_reference, particles_.u);
  Kokkos::deep_copy(exec, particles_.angle_reference, particles_.angle);
  reset_ledger(exec);
  exec.fence("vug::dem::preload");
}

bool Mechanics::preload_statically(const Exec& exec) {
  if (!servos_.empty()) return false;
  follow_temperature(exec);
  std::vector<std::function<void()>> restore;
  visit_state([&](const char*, const auto& view, auto...) {
    std::decay_t<decltype(view)> copy("vug::dem::before_preload", view.layout());
    Kokkos::deep_copy(copy, view);
    restore.push_back([copy, view] { Kokkos::deep_copy(view, copy); });
  });
  const BondCounts before = bond_counts();
  const bool found = find_static_equilibrium(exec, parameters_, grid_, loads_, particles_, bonds_, contacts_, ranks_);
  const BondCounts after = bond_counts();
  if (!found || after.damaged != before.damaged || after.failed() != before.failed()) {
    for (const auto& put_back : restore) put_back();
    return false;
  }
  take_as_reference(exec);
  return true;
}

}  // namespace vug
