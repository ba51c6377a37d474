#include "dem/pieces.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace vug {

namespace {

/// Disjoint sets of numbers; the root of a set is its lowest member.
class Sets {
 public:
  explicit Sets(int count) : above_(count) { std::iota(above_.begin(), above_.end(), 0); }
  int root(int i) {
    while (above(i) != i) i = above(i) = above(above(i));  // halves the way for the next search
    return i;
  }
  void join(int i, int j) {
    const auto [low, high] = std::minmax({root(i), root(j)});
    above(high) = low;
  }

 private:
  int& above(int i) { return above_[i]; }
  std::vector<int> above_;
};

}  // namespace

std::vector<int> find_pieces(const Particles& particles, const Bonds& bonds) {
  const auto pair = on_host(bonds.pair);
  const auto state = on_host(bonds.state);
  const auto fraction = on_host(particles.solid_fraction);
  Sets sets(particles.count);
  for (int b = 0; b < bonds.count; ++b)
    if (!has_failed(state(b)) && !is_gone(fraction(pair(b, 0))) && !is_gone(fraction(pair(b, 1))))
      sets.join(pair(b, 0), pair(b, 1));
  std::vector<int> piece(particles.count);
  for (int t = 0; t < particles.count; ++t) piece[t] = sets.root(t);
  return piece;
}

std::vector<int> find_loose_pieces(const Particles& particles, const Bonds& bonds) {
  std::vector<int> piece = find_pieces(particles, bonds);
  const auto mass = on_host(particles.mass), fraction = on_host(particles.solid_fraction);
  const auto held = on_host(particles.held);
  std::vector<double> weight(piece.size(), 0.0);  // of each piece, at its lowest triangle
  std::vector<bool> stays(piece.size(), false);
  for (std::size_t t = 0; t < piece.size(); ++t) {
    const auto own = static_cast<std::size_t>(piece[t]);
    if (is_gone(fraction(t))) {
      stays[own] = true;  // it is nowhere, and cannot leave
      continue;
    }
    weight[own] += mass(t) * mass_fraction(fraction(t));
    if (held(t) != 0) stays[own] = true;
  }
  if (!piece.empty()) {
    const auto heaviest = std::max_element(weight.begin(), weight.end());
    stays[heaviest - weight.begin()] = true;
  }
  for (int& own : piece)
    if (stays[own]) own = -1;
  return piece;
}

bool has_unsupported_piece(const Particles& particles, const Bonds& bonds) {
  const std::vector<int> piece = find_pieces(particles, bonds);
  const auto fraction = on_host(particles.solid_fraction);
  const auto held = on_host(particles.held);
  std::vector<bool> stays(piece.size(), false);
  for (std::size_t t = 0; t < piece.size(); ++t)
    if (held(t) != 0 || is_gone(fraction(t))) stays[piece[t]] = true;
  return std::any_of(piece.begin(), piece.end(), [&](int own) { return !stays[own]; });
}

}  // namespace vug
