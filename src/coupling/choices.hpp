#pragma once
// What the choices of a case gain and cost, as measured.
#include "io/scene.hpp"

#include <functional>
#include <string>
#include <vector>

namespace vug {

/// A choice of the page docs/accuracy.md, measured by perf/accuracy_cost: on the paper's rock, which is quoted for
/// cases with mechanics, or where only one physics is computed, which is quoted for the others.
struct MeasuredChoice {
  std::string problem;  ///< "rock", "wall", "channel", "cooling" or "receding"
  std::string row;      ///< of the problem's table, for instance "precision = single"
  std::string name;     ///< as it is written in a case
  std::string cost;     ///< processor time over that of preset = careful
  std::string error;    ///< rock: of the dissolved volume against that preset's; else against analytic solutions
  std::function<bool(const Scene&)> made;
};

/// All choices that were measured and that a case can make.
const std::vector<MeasuredChoice>& measured_choices();

/// A number that a case may choose, with the values for which it was measured (docs/accuracy.md).
struct MeasuredLadder {
  const char* key;
  /// The value of the case where it differs from its preset and is less accurate than that of `careful`; otherwise 0.
  double (*chosen)(const Scene&);
  std::vector<double> measured{};  ///< on the paper's rock
  std::vector<double> alone{};     ///< with only one physics
};

/// All numbers for which several values were measured.
const std::vector<MeasuredLadder>& measured_ladders();

/// Whether the measurement at `measured` applies to `value`: they differ by a factor of sqrt(2) at most.
bool is_near(double value, double measured);

/// One line for every choice that the case makes. The measurement is quoted where the value is near a measured one;
/// otherwise the line says that it is unknown. No error of the rock is given as less than that of rounding.
std::vector<std::string> choice_notes(const Scene& scene);

}  // namespace vug
