// Conduction in place gives what two lattices give, to the last bit.
#include "kernels/heat_boundary.hpp"
#include "kernels/heat_kernels.hpp"
#include "kernels/row_launch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace vug {
namespace {

/// Rock at random, with a tenth of the nodes in openings if `openings`.
Kokkos::View<NodeType*> random_types(const Lattice& lattice, bool openings, std::mt19937& random) {
  Kokkos::View<NodeType*> type("type", lattice.size());
  const auto host = Kokkos::create_mirror_view(type);
  for (int y = 0; y < lattice.ny; ++y)
    for (int x = 0; x < lattice.nx; ++x)
      host(lattice.node(x, y)) = openings && random() % 10 == 0 ? NodeType::opening
                                 : random() % 2                 ? NodeType::solid
                                                                : NodeType::fluid;
  Kokkos::deep_copy(type, host);
  return type;
}

/// Any populations, in the halo too.
template <class T>
void fill_at_random(const ScalarField<T>& field, std::mt19937& random) {
  const auto host = Kokkos::create_mirror_view(field);
  std::uniform_real_distribution<T> value(-1, 1);
  for (std::size_t i = 0; i < host.extent(0); ++i) host(i) = value(random);
  Kokkos::deep_copy(field, host);
}

/// One step from `fields` with two lattices, by the law of one node.
template <class T, class Set, bool Openings>
HeatFields<T> after_plain_step(const Exec& exec, const HeatFields<T>& fields) {
  HeatFields<T> next = fields;
  next.g = ScalarField<T>("g", fields.g.extent(0));
  next.theta = ScalarField<T>("theta", fields.theta.extent(0));
  Kokkos::deep_copy(next.g, fields.g);
  Kokkos::deep_copy(next.theta, fields.theta);
  Conduct<T, Set, Openings> node = conduct_body<T, Set, Openings>(fields, next.g);
  node.theta = next.theta;
  for_each_dense_node(exec, "two lattices", fields.lattice, node);
  exec.fence();
  return next;
}

/// Nodes inside the lattice where any of `planes` fields differs by a bit.
template <class T>
int count_differences(const Lattice& lattice, int planes, const ScalarField<T>& a, const ScalarField<T>& b) {
  const auto one = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, a);
  const auto other = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, b);
  int found = 0;
  for (int q = 0; q < planes; ++q)
    for (int y = 0; y < lattice.ny; ++y)
      for (int x = 0; x < lattice.nx; ++x) {
        const int i = q * lattice.size() + lattice.node(x, y);
        found += !(one(i) == other(i));
      }
  return found;
}

template <class T, class Set, bool Openings>
void expect_plain_steps(int nx, int ny, int bands) {
  std::mt19937 random(nx * 1000 + ny);
  const Exec exec;
  const Lattice lattice(nx, ny);
  const ScalarVelocitySet set = Set::Q == D2Q9::Q ? ScalarVelocitySet::d2q9 : ScalarVelocitySet::d2q5;
  HeatFields<T> fields = make_heat_fields<T>(exec, lattice, {0.056, 0.14, 0.625, set},
                                             random_types(lattice, Openings, random), {true, false}, 0, Openings);
  if (runs_on_host && bands > 0) set_heat_bands(exec, bands, fields);
  const HeatSide lower = make_heat_side(lattice, Side::bottom, HeatCondition::temperature, 0.3);
  fill_at_random(fields.g, random);
  for (int step = 0; step < 3; ++step) {
    join_heat_sides(exec, fields, 0);
    fill_heat_side(exec, fields, lower);
    const HeatFields<T> expected = after_plain_step<T, Set, Openings>(exec, fields);
    conduct(exec, fields);
    exec.fence();
    EXPECT_EQ(count_differences(lattice, Set::Q, fields.g, expected.g), 0)
        << nx << " x " << ny << " in " << bands << " bands, step " << step;
    EXPECT_EQ(count_differences(lattice, 1, fields.theta, expected.theta), 0)
        << nx << " x " << ny << " in " << bands << " bands, step " << step;
  }
}

template <class T, class Set, bool Openings>
void expect_plain_steps_of_all_sizes() {
  for (const int bands : {0, 1, 2, 5, 7})
    expect_plain_steps<T, Set, Openings>(37, 7, bands);  // 7: a row each; 0: as a run
  expect_plain_steps<T, Set, Openings>(1, 1, 1);
  expect_plain_steps<T, Set, Openings>(1, 9, 4);
  expect_plain_steps<T, Set, Openings>(333, 1, 0);   // several segments of one row
  expect_plain_steps<T, Set, Openings>(128, 32, 0);  // exactly one band of one thread, whole segments
  expect_plain_steps<T, Set, Openings>(131, 101, 0);
  expect_plain_steps<T, Set, Openings>(131, 101, 4);
}

template <class T>
class ConductionInPlace : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(ConductionInPlace, Precisions);

TYPED_TEST(ConductionInPlace, HasTheBitsOfTwoLattices) {
  expect_plain_steps_of_all_sizes<TypeParam, D2Q5, false>();
  expect_plain_steps_of_all_sizes<TypeParam, D2Q9, false>();
}

TYPED_TEST(ConductionInPlace, HasTheBitsOfTwoLatticesAroundOpenings) {
  expect_plain_steps_of_all_sizes<TypeParam, D2Q5, true>();
  expect_plain_steps_of_all_sizes<TypeParam, D2Q9, true>();
}

}  // namespace
}  // namespace vug
