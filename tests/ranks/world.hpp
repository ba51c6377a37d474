#pragma once
// The processes that mpirun has started for the tests.
#include "ranks/ranks.hpp"

namespace vug {

inline Ranks world;

}  // namespace vug
