#pragma once
// Random numbers that are the same on every machine and compiler (std::distributions are not).
#include <cstdint>

namespace vug {

/// One round of splitmix64 (Steele, Lea & Flood 2014): every bit of the result depends on every bit of the argument.
constexpr std::uint64_t splitmix64(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/// A stream of random numbers whose state is one counter.
struct CounterRandom {
  std::uint64_t counter;

  constexpr std::uint64_t next() {
    const std::uint64_t bits = splitmix64(counter);
    counter += 0x9e3779b97f4a7c15u;
    return bits;
  }
  /// The next number, uniform in [0, 1).
  constexpr double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }
};

}  // namespace vug
