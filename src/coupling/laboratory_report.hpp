#pragma once
// What a loading test has found: as text for people, and as results for the record.
#include "dem/laboratory.hpp"

#include <string>
#include <utility>
#include <vector>

namespace vug {

using Results = std::vector<std::pair<std::string, double>>;

/// One specimen of a loading test.
struct LoadedSpecimen {
  PlatenResult result;
  double along_load = 0;  ///< share of its failed bonds
};

/// Columns of the curve, and names of results, where the work is accounted for; and their values.
extern const std::vector<std::string> energy_columns;
std::vector<double> values_of(const Energies& energies);

/// Young's modulus and Poisson's ratio, where the curve tells them; the strength, or the largest stress where a
/// specimen did not pass a peak; and how the bonds of the first one failed. `advice` says what leads on to a peak.
std::string report_of(const std::vector<LoadedSpecimen>& specimens, const char* advice, Results& results);

/// Where the work on a specimen has gone.
std::string report_of(const Energies& energies, Results& results);

/// A number of specimens in a line of the report, with its scatter where there are several.
std::string line_of(const char* what, const Spread& s, double unit, const char* name, int digits);

}  // namespace vug
