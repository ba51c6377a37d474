#pragma once
// What the choices of a case gain and what they cost, as measured.
#include "io/scene.hpp"

#include <string>
#include <vector>

namespace vug {

/// A choice of the page docs/accuracy.md, measured by perf/accuracy_cost: on the paper's rock, which is quoted of cases
/// with mechanics, or where nothing but one physics is computed, which is quoted of others.
struct MeasuredChoice {
  const char* problem;  ///< "rock", "wall", "channel", "cooling" or "receding"
  const char* row;      ///< of the problem's table: "precision = single"
  const char* name;     ///< as a case has it
  const char* cost;     ///< processor time over that of preset = careful
  const char* error;    ///< of the rock's dissolved volume against that preset's, elsewhere against paper
  bool (*made)(const Scene&);
};

/// All that were measured and that a case can make.
const std::vector<MeasuredChoice>& measured_choices();

/// A number that a case may choose, with the values that were measured (docs/accuracy.md).
struct MeasuredLadder {
  const char* key;
  std::vector<double> measured;  ///< on the paper's rock
  std::vector<double> alone;     ///< where nothing but one physics is computed
  /// What the case chooses otherwise than its preset and dearer in accuracy than `careful`; 0: nothing.
  double (*chosen)(const Scene&);
};

/// All numbers of which several values were measured.
const std::vector<MeasuredLadder>& measured_ladders();

/// Whether what was measured at `measured` says something about `value`: it is no further off than the root of two.
bool is_near(double value, double measured);

/// One line for every choice that the case makes, quoted where it lies near a value that was measured and said to be
/// unknown elsewhere; no error of the rock below what rounding alone does.
std::vector<std::string> choice_notes(const Scene& scene);

}  // namespace vug
