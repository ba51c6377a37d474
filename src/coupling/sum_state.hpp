#pragma once
// The state of a long sum in a checkpoint.
#include "io/field_list.hpp"
#include "kernels/launch/long_sum.hpp"

namespace vug {

/// Adds the parts of `sum` to a checkpoint under names that begin with `key`.
inline void add_state(StateList& list, const std::string& key, const LongSum& sum) {
  list.add(key, sum.recent());
  list.add(key + "_sum", sum.sum());
  list.add(key + "_carry", sum.carry());
}

}  // namespace vug
