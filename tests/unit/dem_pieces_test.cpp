// Pieces of rock whose bonds have failed, against a flood fill over the triangles.
#include "dem/pieces.hpp"
#include "dem_support.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <utility>

namespace {

using namespace vug;
using vug::test::edit;
using vug::test::host_copy;

/// A block whose triangles and bonds tests change by hand.
struct Block {
  explicit Block(const Loads& loads = {}) : rock(test::block(0.012, 0.008, 1e-3, 0.2), test::elastic(), loads) {}
  const Particles& particles() const { return rock.particles(); }
  const Bonds& bonds() const { return rock.bonds(); }
  /// Breaks the bonds whose triangles are on different sides of the predicate.
  template <class Inside>
  void cut(const Inside& inside) const {
    const auto pair = host_copy(bonds().pair);
    edit(bonds().state, [&](const auto& state) {
      for (int b = 0; b < bonds().count; ++b)
        if (inside(pair(b, 0)) != inside(pair(b, 1))) state(b) = BondState::failed_in_shear;
    });
  }
  /// The triangle whose centroid is at x and y, about.
  int at(double x, double y) const {
    const auto x0 = host_copy(particles().x0);
    int nearest = 0;
    for (int i = 1; i < particles().count; ++i)
      if (std::hypot(x0(i, 0) - x, x0(i, 1) - y) < std::hypot(x0(nearest, 0) - x, x0(nearest, 1) - y)) nearest = i;
    return nearest;
  }
  Mechanics rock;
};

/// (triangle) The lowest triangle that a walk over intact bonds reaches from it.
std::vector<int> flooded(const Block& block) {
  const auto pair = host_copy(block.bonds().pair);
  const auto state = host_copy(block.bonds().state);
  const auto fraction = host_copy(block.particles().solid_fraction);
  std::multimap<int, int> beside;
  for (int b = 0; b < block.bonds().count; ++b) {
    const int i = pair(b, 0), j = pair(b, 1);
    if (state(b) >= BondState::failed_in_tension || fraction(i) < 0.05 || fraction(j) < 0.05) continue;
    beside.emplace(i, j);
    beside.emplace(j, i);
  }
  std::vector<int> lowest(static_cast<std::size_t>(block.particles().count), -1);
  for (int start = 0; start < block.particles().count; ++start) {
    std::set<int> reached{start};
    while (!reached.empty()) {
      const int i = reached.extract(reached.begin()).value();
      if (lowest[static_cast<std::size_t>(i)] >= 0) continue;
      lowest[static_cast<std::size_t>(i)] = start;
      for (auto [k, end] = beside.equal_range(i); k != end; ++k) reached.insert(k->second);
    }
  }
  return lowest;
}

TEST(Pieces, AreWhatAWalkOverIntactBondsReaches) {
  const Block block;
  EXPECT_EQ(find_pieces(block.particles(), block.bonds()), flooded(block));
  edit(block.bonds().state, [&](const auto& state) {
    for (int b = 0; b < block.bonds().count; ++b)
      if (uniform_of(7, static_cast<std::uint64_t>(b), 0, 0) < 0.45)
        state(b) = b % 3 == 0 ? BondState::dissolved : BondState::failed_in_tension;
      else if (b % 5 == 0)
        state(b) = BondState::damaged_in_shear;  // still holds
  });
  edit(block.particles().solid_fraction, [&](const auto& fraction) {
    for (int i = 0; i < block.particles().count; i += 11) fraction(i) = 0.04;
  });
  const std::vector<int> expected = flooded(block), found = find_pieces(block.particles(), block.bonds());
  const std::set<int> pieces(expected.begin(), expected.end());
  ASSERT_GT(pieces.size(), 20u);
  ASSERT_LT(pieces.size(), expected.size() / 2);
  EXPECT_EQ(found, expected);
}

TEST(LoosePieces, AreThoseThatNothingHoldsExceptTheHeaviest) {
  Loads held;
  held.support[static_cast<std::size_t>(RockSide::left)] = Support::roller;
  for (const bool supported : {true, false}) {
    const Block block(supported ? held : Loads{});
    const auto x0 = host_copy(block.particles().x0);
    const auto loose = [&] { return find_loose_pieces(block.particles(), block.bonds()); };
    EXPECT_EQ(loose(), std::vector<int>(x0.extent(0), -1)) << "all of it is one piece";
    block.cut([&](int i) { return x0(i, 0) > 0.009; });  // a quarter, on the right
    block.cut([&](int i) { return x0(i, 0) < 0.002; });  // a sixth, which the left side holds
    const std::vector<int> found = loose();
    for (std::size_t i = 0; i < found.size(); ++i) {
      const bool goes = x0(i, 0) > 0.009 || (x0(i, 0) < 0.002 && !supported);
      EXPECT_EQ(found[i] >= 0, goes) << i << supported;
    }
  }
}

/// Of two halves in rock that nothing holds, the sound one is the rock.
TEST(LoosePieces, WeighWhatIsLeft) {
  const Block block;
  const auto x0 = host_copy(block.particles().x0);
  const auto larger = [&](int i) { return x0(i, 0) < 0.007; };
  block.cut(larger);
  EXPECT_EQ(find_loose_pieces(block.particles(), block.bonds())[static_cast<std::size_t>(block.at(0.002, 0.004))], -1);
  for (int i = 0; i < block.particles().count; ++i)
    if (larger(i)) test::set_entry(block.particles().solid_fraction, i, 0.3);
  const std::vector<int> found = find_loose_pieces(block.particles(), block.bonds());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i] >= 0, larger(static_cast<int>(i))) << i;
}

TEST(UnsupportedPieces, AreAnyThatNoSideHolds) {
  Loads held;
  held.support[static_cast<std::size_t>(RockSide::left)] = Support::roller;
  const Block free, block(held);
  EXPECT_TRUE(has_unsupported_piece(free.particles(), free.bonds()));
  EXPECT_FALSE(has_unsupported_piece(block.particles(), block.bonds()));
  const auto x0 = host_copy(block.particles().x0);
  block.cut([&](int i) { return x0(i, 0) > 0.009; });
  EXPECT_TRUE(has_unsupported_piece(block.particles(), block.bonds()));
}

TEST(LoosePieces, DoNotHoldOnToRockThatIsGone) {
  const Block block;
  const int lone = block.at(0.006, 0.004);
  block.cut([&](int i) { return i == lone; });
  EXPECT_EQ(find_loose_pieces(block.particles(), block.bonds())[static_cast<std::size_t>(lone)], lone);
  test::set_entry(block.particles().solid_fraction, lone, 0.0);
  EXPECT_EQ(find_loose_pieces(block.particles(), block.bonds())[static_cast<std::size_t>(lone)], -1);
}

/// Of the rock as it is.
TEST(LoosePieces, FollowTheRock) {
  const Block block;
  const auto piece_of = [&](int triangle) { return find_loose_pieces(block.particles(), block.bonds()).at(triangle); };
  const int first = block.at(0.003, 0.004), second = block.at(0.009, 0.004);
  for (const int lone : {first, second}) {
    block.cut([&](int i) { return i == lone; });
    EXPECT_EQ(piece_of(lone), lone);
  }
  test::set_entry(block.particles().solid_fraction, first, 0.0);
  EXPECT_EQ(piece_of(first), -1);
}

}  // namespace
