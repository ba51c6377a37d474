#pragma once
// How long a run is, how accurate, and what it writes.
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
  int update_interval = 10;   ///< lattice steps between births, pathway openings and chemical-damage updates
  int wall_interval = 10;     ///< lattice steps between renewals of the normals and rates of reacting walls, at most
  int heat_interval = 1;      ///< lattice steps per heat step
  int solute_interval = 1;    ///< lattice steps per solute step
  int exchange_interval = 1;  ///< lattice steps for which the fluid's force on the triangles is held
  int guard_interval = 100;   ///< lattice steps between checks for divergence
  /// Largest share by which results may be off for the intervals above, which are chosen as the run goes then and are
  /// at most what is given; 0: they are what is given
  double tolerance = 0;
  /// Largest change of velocity between two checks, over the largest velocity, at which the flow is held until the
  /// pores change; 0: never
  double flow_tolerance = 0;
  /// Volume that dissolves per volume that the acid pays for: the rock ages so many times faster than the fluid
  double dissolution_factor = 1;
  /// Largest relative error of the dissolved volume for which that factor is chosen as the run goes; 0: it is given
  double dissolution_tolerance = 0;

  /// Whether `tolerance` chooses the intervals; where rock ages faster than the fluid it chooses that instead.
  bool chooses_intervals() const { return tolerance > 0 && dissolution_tolerance == 0; }
};

struct Probe {
  std::string name;
  std::array<double, 2> at;  ///< m
};
enum class GaugeKind { displacement, stress, reaction, opening, crack_tip };
/// Numbers of the rock for the history.
struct Gauge {
  std::string name;
  GaugeKind kind = GaugeKind::displacement;
  std::array<double, 2> at{0, 0};              ///< m, of displacement
  std::array<double, 2> from{0, 0}, to{0, 0};  ///< m, of opening; `from` also of crack_tip
  std::array<double, 2> direction{1, 0};       ///< of crack_tip
  std::optional<Form> region;                  ///< of stress
  std::string side;                            ///< of reaction
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
  bool flows = false;   ///< of mass, heat and species through them, likewise
  std::vector<Probe> probes;
  std::vector<Gauge> gauges;
};

}  // namespace vug
