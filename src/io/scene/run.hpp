#pragma once
// Length, accuracy and output of a run.
#include "io/scene/geometry.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vug {

struct TimeSection {
  std::optional<double> end;          ///< s
  std::optional<std::int64_t> steps;  ///< lattice steps; exactly one of the two is given
};

enum class Precision { single_precision, double_precision };
struct AccuracySection {
  std::string preset = "careful";
  Precision precision = Precision::double_precision;
  int update_interval = 10;   ///< lattice steps between updates of births, pathways and chemical damage
  int wall_interval = 10;     ///< most lattice steps between renewals of the normals and rates of reacting walls
  int heat_interval = 1;      ///< lattice steps per heat step
  int solute_interval = 1;    ///< lattice steps per solute step
  int exchange_interval = 1;  ///< lattice steps for which the fluid's force on the triangles is held
  int guard_interval = 100;   ///< lattice steps between checks for divergence
  /// Largest relative error of results. With a value above 0 the intervals are chosen during the run, and those above
  /// are upper limits; with 0 they are used as given.
  double tolerance = 0;
  /// Largest change of velocity between two checks, over the largest velocity, at which the flow is held until the
  /// pores change; 0: never held.
  double flow_tolerance = 0;
  /// Factor by which the rock ages faster than the fluid: dissolved volume over the volume that the acid used accounts
  /// for.
  double dissolution_factor = 1;
  /// Largest relative error of the dissolved volume, by which that factor is chosen during the run; 0: the factor is
  /// given.
  double dissolution_tolerance = 0;

  /// Whether `tolerance` chooses the intervals. Where the rock may age faster than the fluid, it bounds that instead.
  bool chooses_intervals() const { return tolerance > 0 && dissolution_tolerance == 0; }
};

struct Probe {
  std::string name;
  std::array<double, 2> at;  ///< m
};
enum class GaugeKind { displacement, stress, reaction, opening, crack_tip };
/// A quantity of the rock in the history.
struct Gauge {
  std::string name;
  GaugeKind kind = GaugeKind::displacement;
  std::array<double, 2> at{0, 0};              ///< m, of displacement
  std::array<double, 2> from{0, 0}, to{0, 0};  ///< m, of opening; `from` also of crack_tip
  std::array<double, 2> direction{1, 0};       ///< of crack_tip
  std::optional<Form> region;                  ///< of stress
  Side side = Side::left;                      ///< of reaction
  std::optional<double> first, last;           ///< m along it
};
struct OutputSection {
  std::optional<double> interval;  ///< s
  std::optional<std::int64_t> interval_steps;
  std::optional<double> history_interval;     ///< s
  std::optional<double> checkpoint_interval;  ///< s
  std::vector<std::string> fields;            ///< empty: all
  bool compress = true;
  bool forces = false;  ///< of the fluid on sides and named shapes, in the history
  bool flows = false;   ///< of mass, heat and species through sides and named shapes, in the history
  std::vector<Probe> probes;
  std::vector<Gauge> gauges;
};

}  // namespace vug
