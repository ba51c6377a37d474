// Conduction in place gives what two lattices give, to the last bit, and convection behind it what it gives node by
// node.
#include "kernels/heat/heat_boundary.hpp"
#include "kernels/heat/heat_kernels.hpp"
#include "kernels/launch/row_launch.hpp"
#include "support/host_copy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <type_traits>

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
template <class Set, class T, class Matter>
HeatFields<T> after_plain_step(const Exec& exec, const HeatFields<T>& fields, const Matter& matter) {
  HeatFields<T> next = fields;
  next.g = ScalarField<T>("g", fields.g.extent(0));
  Kokkos::deep_copy(next.g, fields.g);
  for_each_dense_node(exec, "two lattices", fields.lattice, conduct_body<Set>(fields, matter, next.g));
  exec.fence();
  return next;
}

/// Nodes inside the lattice where any of `planes` fields differs by a bit.
template <class T>
int count_differences(const Lattice& lattice, int planes, const ScalarField<T>& a, const ScalarField<T>& b) {
  const auto one = test::host_copy(a);
  const auto other = test::host_copy(b);
  int found = 0;
  for (int q = 0; q < planes; ++q)
    for (int y = 0; y < lattice.ny; ++y)
      for (int x = 0; x < lattice.nx; ++x) {
        const int i = q * lattice.size() + lattice.node(x, y);
        found += !(one(i) == other(i));
      }
  return found;
}

/// The number of one of three minerals for every node.
Kokkos::View<std::uint8_t*> random_minerals(const Lattice& lattice, std::mt19937& random) {
  Kokkos::View<std::uint8_t*> mineral("mineral", lattice.size());
  const auto host = Kokkos::create_mirror_view(mineral);
  for (std::size_t n = 0; n < host.extent(0); ++n) host(n) = static_cast<std::uint8_t>(random() % 3);
  Kokkos::deep_copy(mineral, host);
  return mineral;
}

template <class T, class Set, bool Openings, bool Minerals = false>
void expect_plain_steps(int nx, int ny, int bands) {
  std::mt19937 random(nx * 1000 + ny);
  const Exec exec;
  const Lattice lattice(nx, ny);
  const ScalarVelocitySet set = Set::Q == D2Q9::Q ? ScalarVelocitySet::d2q9 : ScalarVelocitySet::d2q5;
  HeatParameters parameters{0.056, 0.14, 0.625, set};
  if (Minerals) parameters.minerals = {{0.14, 0.625}, {0.3, 0.5}, {0.08, 0.9}};
  const auto type = random_types(lattice, Openings, random);
  HeatFields<T> fields = make_heat_fields<T>(exec, lattice, parameters, type, {true, false}, 0, Openings,
                                             random_minerals(lattice, random));
  if (runs_on_host && bands > 0) set_heat_bands(exec, bands, fields);
  const HeatSide lower = make_heat_side(Side::bottom, 0, lattice.nx - 1, HeatCondition::temperature, 0.3);
  fill_at_random(fields.g, random);
  for (int step = 0; step < 3; ++step) {
    join_heat_sides(exec, fields, 0);
    fill_heat_sides(exec, fields, {&lower, 1});
    using Matter = std::conditional_t<Minerals, ManyMinerals<T, Set>, TwoPhases<T, Set, Openings>>;
    const HeatFields<T> expected = after_plain_step<Set>(exec, fields, Matter(fields));
    conduct(exec, fields);
    exec.fence();
    EXPECT_EQ(count_differences(lattice, Set::Q, fields.g, expected.g), 0)
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

TYPED_TEST(ConductionInPlace, HasTheBitsOfTwoLatticesInMinerals) {
  expect_plain_steps<TypeParam, D2Q5, true, true>(131, 101, 4);
  expect_plain_steps<TypeParam, D2Q9, true, true>(131, 101, 4);
  expect_plain_steps<TypeParam, D2Q5, false, true>(37, 7, 0);
  expect_plain_steps<TypeParam, D2Q9, false, true>(37, 7, 0);
}

TYPED_TEST(ConductionInPlace, HasTheBitsOfTwoLatticesAroundOpenings) {
  expect_plain_steps_of_all_sizes<TypeParam, D2Q5, true>();
  expect_plain_steps_of_all_sizes<TypeParam, D2Q9, true>();
}

/// Fluid nodes of which every fifth was born later, so that neighbours do not follow each other in the list, with the
/// upper side open.
FluidNodes nodes_with_births(const Exec& exec, const Lattice& lattice, const Kokkos::View<NodeType*>& type) {
  const Kokkos::View<NodeType*> before("type", lattice.size());
  Kokkos::deep_copy(before, type);
  const auto host = test::host_copy(before);
  int fluid = 0;
  for (int y = 0; y < lattice.ny; ++y)
    for (int x = 0; x < lattice.nx; ++x)
      if (NodeType& kind = host(lattice.node(x, y)); kind == NodeType::fluid && ++fluid % 5 == 0)
        kind = NodeType::solid;
  Kokkos::deep_copy(before, host);
  FluidNodes nodes = make_fluid_nodes(exec, lattice, before, {true, false});
  EXPECT_EQ(append_births(exec, type, nodes), fluid / 5);
  mark_open(exec, nodes, find_boundary_links(exec, nodes, Side::top, 0, lattice.nx - 1, D2Q9::Q));
  return nodes;
}

/// `theta`, kept in the last step, is what the fields hold.
template <class T>
void expect_temperatures_of_now(const Exec& exec, const Kokkos::View<NodeType*>& type, const HeatFields<T>& fields,
                                const ScalarField<T>& theta) {
  const auto kind = test::host_copy(type);
  const auto kept = test::host_copy(theta);
  const auto taken = test::host_copy(temperatures(exec, fields));
  const Lattice& lattice = fields.lattice;
  for (int y = 0; y < lattice.ny; ++y)
    for (int x = 0; x < lattice.nx; ++x) {
      const int n = lattice.node(x, y);
      if (kind(n) == NodeType::opening)
        EXPECT_EQ(taken(n), 0);
      else
        EXPECT_EQ(kept(n), taken(n)) << x << ", " << y;
    }
}

template <class T, class Set, bool Openings>
void expect_convection_node_by_node(int nx, int ny, int bands, double tolerance) {
  std::mt19937 random(nx * 1000 + ny);
  const Exec exec;
  const Lattice lattice(nx, ny);
  const ScalarVelocitySet set = Set::Q == D2Q9::Q ? ScalarVelocitySet::d2q9 : ScalarVelocitySet::d2q5;
  const Kokkos::View<NodeType*> type = random_types(lattice, Openings, random);
  const FluidNodes nodes = nodes_with_births(exec, lattice, type);
  HeatFields<T> rows = make_heat_fields<T>(exec, lattice, {0.056, 0.14, 0.625, set}, type, {true, false}, 0, Openings);
  if (runs_on_host && bands > 0) set_heat_bands(exec, bands, rows);
  fill_at_random(rows.g, random);
  const VectorField<T> u("u", nodes.capacity);
  const ScalarField<T> defect("defect", nodes.capacity), lagged("lagged", nodes.capacity),
      lagged_apart("lagged", nodes.capacity);
  const auto velocity = Kokkos::create_mirror_view(u);
  const auto divergence = Kokkos::create_mirror_view(defect);
  std::uniform_real_distribution<T> small(-0.1, 0.1);
  for (int i = 0; i < nodes.count; ++i) {
    for (int axis = 0; axis < 2; ++axis) velocity(i, axis) = small(random);
    divergence(i) = small(random);
  }
  Kokkos::deep_copy(u, velocity);
  Kokkos::deep_copy(defect, divergence);
  HeatFields<T> apart = rows;
  apart.g = ScalarField<T>("g", rows.g.extent(0));
  Kokkos::deep_copy(apart.g, rows.g);

  const auto sums = [&] { return ScalarField<double>("created", std::max(block_count(lattice.size()), ny)); };
  const ScalarField<double> created = sums(), created_apart = sums();
  const ScalarField<T> theta("theta", lattice.size());
  for (int step = 0; step < 3; ++step) {
    join_heat_sides(exec, rows, 0);
    conduct_and_advect(exec, nodes, fluid_rows(exec, nodes), {u, 2}, defect, lagged, rows, created, theta);
    join_heat_sides(exec, apart, 0);
    conduct(exec, apart);
    add_per_block(exec, "node by node", nodes.count, advect_body<T, Set>(nodes, {u, 2}, defect, lagged_apart, apart),
                  created_apart);
    exec.fence();
  }
  const auto expect_near = [&](const auto& a, const auto& b, int first, int last, const char* what) {
    const auto one = test::host_copy(a);
    const auto other = test::host_copy(b);
    for (int i = first; i < last; ++i)
      ASSERT_NEAR(one(i), other(i), tolerance) << what << ' ' << i << " of " << nx << " x " << ny;
  };
  for (int y = 0; y < ny; ++y) {
    const int first = lattice.node(0, y), last = lattice.node(nx, y);
    for (int q = 0; q < Set::Q; ++q)
      expect_near(rows.g, apart.g, q * lattice.size() + first, q * lattice.size() + last, "population");
  }
  expect_near(lagged, lagged_apart, 0, nodes.count, "lagging defect");
  expect_temperatures_of_now(exec, type, rows, theta);
  EXPECT_NEAR(sum_in_order(created), sum_in_order(created_apart), tolerance * nx * ny);
  EXPECT_NE(sum_in_order(created), 0);
}

TYPED_TEST(ConductionInPlace, IsFollowedByTheConvectionOfEveryNode) {
  using T = TypeParam;
  const double tolerance = 100 * std::numeric_limits<T>::epsilon();
  for (const auto& [nx, ny, bands] : {std::array{37, 7, 0}, {37, 7, 3}, {131, 101, 0}, {131, 101, 4}, {333, 2, 0}}) {
    expect_convection_node_by_node<T, D2Q5, false>(nx, ny, bands, tolerance);
    expect_convection_node_by_node<T, D2Q9, false>(nx, ny, bands, tolerance);
    expect_convection_node_by_node<T, D2Q5, true>(nx, ny, bands, tolerance);
    expect_convection_node_by_node<T, D2Q9, true>(nx, ny, bands, tolerance);
  }
}

}  // namespace
}  // namespace vug
