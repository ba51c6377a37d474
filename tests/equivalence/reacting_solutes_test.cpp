// Reaction and both sweeps in one pass, and its list of links, against the same one after the other and by hand.
#include "../reference/reactive_box.hpp"
#include "kernels/reaction/reactive_wall_kernel.hpp"
#include "support/host_copy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace vug {
namespace {

using reference::ReactiveBox;
using reference::uniform_rate;
using test::host_copy;

template <class Set, class T>
ReactiveBox<Set, T> porous_box(std::array<bool, 2> periodic = {false, false}) {
  std::mt19937 random(5);
  constexpr int nx = 130, ny = 90;
  std::vector<char> solid(nx * ny);
  for (char& s : solid) s = random() % 3 == 0;
  return {nx, ny, [&](int x, int y) { return solid[y * nx + x]; }, solute_parameters(0.07), 0.6, periodic};
}

enum class Carried { at_rest, by_flow, in_advective_form };

template <class Set, class T>
void expect_same_bits(ReactiveWallLaw law, Carried carried, bool with_product) {
  auto together = porous_box<Set, T>(), apart = porous_box<Set, T>();
  std::mt19937 random(7);
  std::uniform_real_distribution<double> small(-0.02, 0.02);
  const FluidNodes& nodes = together.nodes;
  const VectorField<T> u("u", nodes.capacity);
  const ScalarField<T> e("e", nodes.capacity);
  const auto u_host = Kokkos::create_mirror_view(u);
  const auto e_host = Kokkos::create_mirror_view(e);
  for (int i = 0; i < nodes.count; ++i) {
    for (int axis = 0; axis < 2; ++axis) u_host(i, axis) = T(small(random));
    e_host(i) = T(small(random));
  }
  Kokkos::deep_copy(u, u_host);
  Kokkos::deep_copy(e, e_host);
  SoluteCarrier<T> carrier;
  if (carried != Carried::at_rest) carrier.displacement = Displacement<T>(u, 2);
  if (carried == Carried::in_advective_form) carrier.defect = e;

  struct Sums {
    ScalarField<double> acid, product;
  };
  const auto run = [&](ReactiveBox<Set, T>& box, const auto& step) {
    box.wall.law = law;
    box.wall.inverse_equilibrium = with_product ? 0.3 : 0;
    box.wall.D_reactant = box.wall.D_product = box.parameters.diffusivity();
    if (with_product) box.add_product(0.1);
    find_reactive_links<Set>(box.exec, box.nodes, box.surface, law, box.links);
    set_conductances<Set>(box.exec, box.nodes, box.surface, box.wall, uniform_rate(0.05), box.normal, box.links);
    const int blocks = block_count(nodes.count);
    const Sums sums{ScalarField<double>("acid", blocks), ScalarField<double>("product", blocks)};
    for (int n = 0; n < 5; ++n) step(box, sums);  // an odd number: the populations stay turned
    return sums;
  };
  const Sums one = run(together, [&](ReactiveBox<Set, T>& box, const Sums& sums) {
    const SteppingSolute<T> product{box.parameters, box.product, sums.product};
    advance_reacting_solutes<Set>(box.exec, box.nodes, carrier, box.wall, box.links,
                                  SteppingSolute<T>{box.parameters, box.acid, sums.acid},
                                  with_product ? &product : nullptr);
  });
  const Sums other = run(apart, [&](ReactiveBox<Set, T>& box, const Sums& sums) {
    advance_solute<Set>(box.exec, box.nodes, carrier, SteppingSolute<T>{box.parameters, box.acid, sums.acid});
    if (with_product)
      advance_solute<Set>(box.exec, box.nodes, carrier, SteppingSolute<T>{box.parameters, box.product, sums.product});
    react_at_wall<Set>(box.exec, box.nodes, box.wall, box.links, box.acid, with_product ? &box.product : nullptr);
  });

  const auto expect_equal = [](const auto& a, const auto& b, const char* what) {
    const auto x = host_copy(a), y = host_copy(b);
    ASSERT_EQ(x.extent(0), y.extent(0));
    for (std::size_t i = 0; i < x.extent(0); ++i) ASSERT_EQ(x(i), y(i)) << what << ' ' << i;
  };
  EXPECT_GT(sum_in_order(together.links.acid), 1);
  expect_equal(together.acid.h, apart.acid.h, "population of the acid");
  expect_equal(together.acid.C, apart.acid.C, "concentration of the acid");
  expect_equal(together.links.acid, apart.links.acid, "turnover");
  expect_equal(one.acid, other.acid, "correction of the acid");
  EXPECT_EQ(together.acid.turned, 1);
  if (!with_product) return;
  expect_equal(together.product.h, apart.product.h, "population of the product");
  expect_equal(one.product, other.product, "correction of the product");
}

template <class Choice>
class ReactingSolutes : public testing::Test {};
template <class Set_, class T_>
struct Choice {
  using Set = Set_;
  using T = T_;
};
using Choices = testing::Types<Choice<D2Q5, double>, Choice<D2Q9, double>, Choice<D2Q5, float>, Choice<D2Q9, float>>;
TYPED_TEST_SUITE(ReactingSolutes, Choices);

TYPED_TEST(ReactingSolutes, HaveTheBitsOfTheirParts) {
  for (const auto law : {ReactiveWallLaw::kinetic, ReactiveWallLaw::paper})
    for (const auto carried : {Carried::at_rest, Carried::by_flow, Carried::in_advective_form})
      for (const bool with_product : {true, false})
        expect_same_bits<typename TypeParam::Set, typename TypeParam::T>(law, carried, with_product);
}

TYPED_TEST(ReactingSolutes, LinksAreAllThatLeadIntoRockInTheOrderOfTheFluid) {
  using Set = typename TypeParam::Set;
  auto box = porous_box<Set, typename TypeParam::T>({true, true});
  find_reactive_links<Set>(box.exec, box.nodes, box.surface, ReactiveWallLaw::kinetic, box.links);
  const FluidNodes& nodes = box.nodes;
  const Lattice& lattice = nodes.lattice;
  const auto type = host_copy(box.type);
  const auto node = host_copy(nodes.node), first = host_copy(box.links.first), slot = host_copy(box.links.slot),
             root = host_copy(box.links.root), surface = host_copy(box.surface.node),
             of_surface = host_copy(box.links.of_surface), of_surface_link = host_copy(box.links.of_surface_link);
  int link = 0;
  for (int i = 0; i < nodes.count; ++i) {
    ASSERT_EQ(first(i), link);
    for (int q = 1; q < Set::Q; ++q) {
      const int x = (lattice.x(node(i)) + Set::c(q, 0) + lattice.nx) % lattice.nx;
      const int y = (lattice.y(node(i)) + Set::c(q, 1) + lattice.ny) % lattice.ny;
      if (type(lattice.node(x, y)) != NodeType::solid) continue;
      ASSERT_EQ(slot(link), q * nodes.capacity + i);
      ASSERT_EQ(surface(root(link) / 8), lattice.node(x, y));
      ASSERT_EQ(root(link) % 8 + 1, Set::opposite(q));
      ++link;
    }
  }
  EXPECT_EQ(box.links.count, link);
  EXPECT_EQ(first(nodes.count), link);

  std::vector<int> seen;
  for (int s = 0; s < box.surface.count; ++s)
    for (int k = of_surface(s); k < of_surface(s + 1); ++k) {
      ASSERT_EQ(root(of_surface_link(k)) / 8, s);
      seen.push_back(of_surface_link(k));
    }
  std::sort(seen.begin(), seen.end());
  ASSERT_EQ(static_cast<int>(seen.size()), link);
  for (int l = 0; l < link; ++l) ASSERT_EQ(seen[l], l);
}

}  // namespace
}  // namespace vug
