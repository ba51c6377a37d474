#pragma once
// The tasks of a lattice step, in words: for people, and for the rule that every field has one writer.
#include <cstdint>
#include <string>
#include <vector>

namespace vug {

/// A part of a step. Fields are named as in a checkpoint, for instance "flow/u". A name stands for all fields that
/// begin with it, except those for which another task has a longer name: "flow" for the flow's populations, velocity
/// and sums at its sides.
struct Task {
  std::string name;
  std::int64_t interval = 1;        ///< lattice steps from one execution to the next
  std::vector<std::string> reads;   ///< results of others: of this step where they come earlier, else of the last
  std::vector<std::string> writes;  ///< what no other task writes
  std::vector<std::string> takes;   ///< sums of other tasks, which are then set to zero
};

/// The tasks of a step as a table, in their order.
std::string to_text(const std::vector<Task>& schedule);

}  // namespace vug
