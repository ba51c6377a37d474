#pragma once
// What intervals of [accuracy] leave out of a case without being wrong by themselves.
#include "io/scene.hpp"

#include <string>
#include <vector>

namespace vug {

/// One line for each: an interval longer than the run, which the preset has set (check_times refuses it where the case
/// gives it; for `update_interval` in any case); rows or snapshots, given or by default, more
/// frequent than the steps of heat or solutes;
/// a given flow that changes within an interval; rare looks at how fast the rock may age. None where a tolerance
/// chooses the intervals.
std::vector<std::string> interval_warnings(const Scene& scene);

/// The shortest time in which a given flow changes: a ramp, or two points of different values of a table, s; infinity
/// where none does.
double quickest_flow(const Scene& scene);

}  // namespace vug
