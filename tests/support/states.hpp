#pragma once
// What a checkpoint keeps of a simulation, in memory.
#include "coupling/simulation.hpp"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace vug::test {

using State = std::map<std::string, std::vector<std::byte>>;

/// The blocks of a list by name.
inline State saved(const StateList& list) {
  State state;
  for (const StateBlock& block : list.blocks) state[block.name] = block.saved();
  return state;
}

inline State state_of(Simulation& simulation) {
  return saved(simulation.state());
}

inline void restore(Simulation& simulation, const State& state) {
  simulation.restore([&](StateList& list) {
    for (const StateBlock& block : list.blocks) block.load_all(state.at(block.name));
  });
}

}  // namespace vug::test
