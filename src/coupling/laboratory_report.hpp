#pragma once
// The findings of a loading test, as text for people and as results for the record.
#include "dem/laboratory.hpp"

#include <string>
#include <utility>
#include <vector>

namespace vug {

using Results = std::vector<std::pair<std::string, double>>;

/// One specimen of a loading test.
struct LoadedSpecimen {
  PlatenResult result;
  int along_load = 0;  ///< how many of the bonds that the load has broken are along it
};

/// Names of the columns of the curve and of the results, where work is accounted for, and their values.
extern const std::vector<std::string> energy_columns;
std::vector<double> values_of(const Energies& energies);

/// Reports Young's modulus and Poisson's ratio, where the curve gives them; the strength, or the largest stress where a
/// specimen did not pass a peak; and how the bonds failed, on the mean of the specimens. `advice` says how to reach a
/// peak.
std::string report_of(const std::vector<LoadedSpecimen>& specimens, const char* advice, Results& results);

/// Reports where the work on the specimens has gone, on their mean; missing is the most that is in any of them.
std::string report_energies(const std::vector<LoadedSpecimen>& specimens, Results& results);

/// A line of the report for one number of the specimens, with its scatter where there are several.
std::string line_of(const char* what, const Spread& s, double unit, const char* name, int digits);

}  // namespace vug
