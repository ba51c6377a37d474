#pragma once
// Damaged inputs without end: what is asked for by the same number is the same on every machine.
#include <cstdint>
#include <string>
#include <vector>

namespace vug::campaign {

/// Random numbers from a seed: splitmix64 (Steele, Lea, Flood, OOPSLA 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
  }
  /// One of 0 ... n - 1.
  std::size_t below(std::size_t n) { return n == 0 ? 0 : static_cast<std::size_t>(next() % n); }

 private:
  std::uint64_t state_;
};

/// Makes inputs from sound ones: flipped bits, bytes, cuts, doubled and moved pieces, pieces of another input, words of
/// the corpus and numbers that no reader likes.
class Mutator {
 public:
  explicit Mutator(std::vector<std::string> corpus);
  /// The input number `index` of the sequence `seed`.
  std::string input(std::uint64_t seed, std::uint64_t index) const;

 private:
  void change(std::string& data, Random& random) const;

  std::vector<std::string> corpus_, words_;
};

}  // namespace vug::campaign
