// The same rock seen turned, mirrored, shifted, by one thread or two, in float or double dissolves the same.
#include "../reference/reactive_box.hpp"
#include "support/host_copy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace vug {
namespace {

using reference::ReactiveBox;

constexpr int side = 24;

std::vector<char> some_rock() {
  std::mt19937 random(7);
  std::vector<char> rock(side * side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      rock[y * side + x] = std::hypot(x % 12 - 5.3, y % 12 - 6.1) < 4.4 || random() % 17 == 0;
  return rock;
}

/// Solid volume after `steps` steps of reaction, diffusion and births, as a function of the pixel of some_rock; `image`
/// takes a pixel of the lattice to a pixel of the rock.
template <class Set, class T>
std::vector<double> dissolve(const std::function<std::array<int, 2>(int, int)>& image, int steps,
                             ReactiveWallLaw law = ReactiveWallLaw::kinetic) {
  const std::vector<char> rock = some_rock();
  const auto pixel = [&](int x, int y) {
    const auto [i, j] = image(x, y);
    return j * side + i;
  };
  ReactiveBox<Set, T> box(side, side, [&](int x, int y) { return rock[pixel(x, y)]; }, solute_parameters(0.1), 1.0,
                          {true, true});
  box.use_normals = law == ReactiveWallLaw::kinetic;
  box.renew_normals();
  box.wall.law = law;
  box.wall.D_reactant = 0.1;
  box.wall.molar_volume = 0.8;
  box.k = 0.02;
  for (int n = 1; n <= steps; ++n) {
    box.step();
    if (n % 5 == 0) {
      box.births(BirthFill::mean);
      box.renew_normals();
    }
  }
  std::vector<double> V(side * side);
  const auto V_host = test::host_copy(box.V);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) V[pixel(x, y)] = V_host(box.lattice.node(x, y));
  return V;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

std::array<int, 2> as_it_is(int x, int y) {
  return {x, y};
}

template <class Set>
class DissolvingRock : public ::testing::Test {};
using VelocitySets = ::testing::Types<D2Q5, D2Q9>;
TYPED_TEST_SUITE(DissolvingRock, VelocitySets);

TYPED_TEST(DissolvingRock, TurnedMirroredAndShiftedIsTheSame) {
  // 900 steps, some 60 births; sums run in another order
  const auto straight = dissolve<TypeParam, double>(as_it_is, 900);
  EXPECT_LT(*std::min_element(straight.begin(), straight.end()), 0.5);
  const std::vector<std::pair<std::string, std::function<std::array<int, 2>(int, int)>>> ways = {
      {"turned",
       [](int x, int y) {
         return std::array{y, side - 1 - x};
       }},
      {"mirrored",
       [](int x, int y) {
         return std::array{side - 1 - x, y};
       }},
      {"shifted", [](int x, int y) {
         return std::array{(x + 5) % side, (y + 9) % side};
       }}};
  for (const auto& [way, place] : ways) {
    const double difference = largest_difference(straight, dissolve<TypeParam, double>(place, 900));
    std::printf("    %s: %.1e of a pixel\n", way.c_str(), difference);
    EXPECT_LT(difference, 1e-12) << way;
  }
}

TYPED_TEST(DissolvingRock, BeforeTheFirstBirthSymmetryIsExactToRounding) {
  const auto straight = dissolve<TypeParam, double>(as_it_is, 20);
  const auto turned = dissolve<TypeParam, double>([](int x, int y) { return std::array{y, side - 1 - x}; }, 20);
  EXPECT_LT(largest_difference(straight, turned), 1e-14);
}

TYPED_TEST(DissolvingRock, FloatFollowsDouble) {
  const auto a = dissolve<TypeParam, double>(as_it_is, 400), b = dissolve<TypeParam, float>(as_it_is, 400);
  EXPECT_LT(largest_difference(a, b), 2e-3);
}

TYPED_TEST(DissolvingRock, RunsTheSameTwice) {
  for (const ReactiveWallLaw law : {ReactiveWallLaw::kinetic, ReactiveWallLaw::paper}) {
    const auto a = dissolve<TypeParam, double>(as_it_is, 300, law), b = dissolve<TypeParam, double>(as_it_is, 300, law);
    EXPECT_EQ(largest_difference(a, b), 0);
  }
}

}  // namespace
}  // namespace vug
