#pragma once
// What the choices of a case gain and what they cost, as measured.
#include "io/scene.hpp"

#include <string>
#include <vector>

namespace vug {

/// A choice of the page docs/accuracy.md, measured on the paper's rock (perf/accuracy_cost).
struct MeasuredChoice {
  const char* name;   ///< as in the page's table: "precision = single"
  const char* cost;   ///< processor time over that of preset = careful
  const char* error;  ///< of the dissolved volume against that preset's
  bool (*made)(const Scene&);
};

/// All that were measured and that a case can make.
const std::vector<MeasuredChoice>& measured_choices();

/// One line for every choice that the case makes, quoted where it lies near a value that was measured and said to be
/// unknown elsewhere; no error below what rounding alone does.
std::vector<std::string> choice_notes(const Scene& scene);

}  // namespace vug
