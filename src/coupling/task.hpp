#pragma once
// What is done in a lattice step, in words: for people, and for the rule that every field has one writer.
#include <cstdint>
#include <string>
#include <vector>

namespace vug {

/// A part of a step. Fields are named as in a checkpoint, "flow/u"; a name stands for all that begin with it and that
/// no other task names more closely, "flow" for the flow's populations, velocity and sums at its sides.
struct Task {
  std::string name;
  std::int64_t interval = 1;        ///< lattice steps from one time to the next
  std::vector<std::string> reads;   ///< what others write: of this step where they stand before it, else of the last
  std::vector<std::string> writes;  ///< what nobody else does
  std::vector<std::string> takes;   ///< what another has added up, set back to nothing
};

/// The tasks of a step as a table, in their order.
std::string to_text(const std::vector<Task>& schedule);

}  // namespace vug
