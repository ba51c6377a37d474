// Several lists in one launch have the bits of one launch each.
#include "kernels/launch/launch_lists.hpp"

#include "kernels/nodes/opening.hpp"
#include "support/dress_one.hpp"
#include "support/flow_setup.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace vug {

/// x(i) of a list becomes its root; the body returns what that has changed.
struct TakeRoot {
  double* x;
  double scale;
  KOKKOS_FUNCTION double operator()(int i) const {
    const double before = x[i];
    x[i] = Kokkos::sqrt(scale * before);
    return x[i] - before;
  }
};

struct RootsOfLists {
  struct Entry {
    double *x, *total;
    double scale;
  };
  struct List {
    ScalarField<double> x, total;
    double scale;
  };
  static int count(const List& list) { return static_cast<int>(list.x.extent(0)); }
  static Entry entry(const List& list) { return {list.x.data(), list.total.data(), list.scale}; }
  template <class Run>
  KOKKOS_FUNCTION void operator()(const Entry& e, const Run& run) const {
    run(TakeRoot{e.x, e.scale});
  }
};

namespace {

using List = RootsOfLists::List;

/// More lists than a launch takes: empty ones, such with a part of a block, with whole ones, with several.
std::vector<List> some_lists() {
  std::vector<List> lists;
  for (const int n : {0, 1, 31, 32, 33, 512, 513, 0, 100, 2000, 7, 7, 7, 7, 300, 64, 65, 900, 5, 0, 1024}) {
    const ScalarField<double> x("x", n), total("total", block_count(n));
    const auto host = Kokkos::create_mirror_view(x);
    for (int i = 0; i < n; ++i) host(i) = 1.0 + 0.37 * i + static_cast<double>(lists.size());
    Kokkos::deep_copy(x, host);
    lists.push_back({x, total, 1.0 + 0.01 * static_cast<double>(lists.size())});
  }
  return lists;
}

void expect_same(const ScalarField<double>& a, const ScalarField<double>& b, std::size_t list) {
  const auto one = test::host_copy(a), other = test::host_copy(b);
  ASSERT_EQ(one.extent(0), other.extent(0));
  for (std::size_t i = 0; i < one.extent(0); ++i) EXPECT_EQ(one(i), other(i)) << "list " << list << ", item " << i;
}

TEST(ListsInOneLaunch, HaveTheBitsOfOneLaunchEach) {
  const Exec exec;
  const std::vector<List> each = some_lists(), together = some_lists();
  for (const List& list : each)
    for_each_node(exec, "each", RootsOfLists::count(list), TakeRoot{list.x.data(), list.scale});
  for_each_of_lists<RootsOfLists, List>(exec, "together", together, {});
  for (std::size_t l = 0; l < each.size(); ++l) expect_same(each[l].x, together[l].x, l);
}

TEST(ListsInOneLaunch, HaveTheSumsOfOneLaunchEach) {
  const Exec exec;
  const std::vector<List> each = some_lists(), together = some_lists();
  for (const List& list : each)
    add_per_block(exec, "each", RootsOfLists::count(list), TakeRoot{list.x.data(), list.scale}, list.total);
  add_per_block_of_lists<RootsOfLists, List>(exec, "together", together, {});
  for (std::size_t l = 0; l < each.size(); ++l) {
    expect_same(each[l].x, together[l].x, l);
    expect_same(each[l].total, together[l].total, l);
  }
}

/// Dresses the fluid between two outflows `gap` nodes apart, as a run does, and compares with left, then right on the
/// host. Returns whether that counts as narrow.
bool dress_between_outflows(int gap) {
  const Exec exec;
  const Lattice lattice(gap, 40);
  const FluidNodes nodes =
      make_fluid_nodes(exec, lattice, test::shape(lattice, [](int, int) { return false; }), {false, true});
  const SoluteFields<double> s = make_solute_fields<D2Q5, double>(exec, nodes, 1);
  const ScalarField<double> expected("expected", s.h.extent(0));
  const auto h = Kokkos::create_mirror_view(expected);
  for (std::size_t i = 0; i < h.extent(0); ++i) h(i) = std::sin(1.0 + static_cast<double>(i));
  Kokkos::deep_copy(s.h, h);
  std::vector<SoluteCondition<double>> conditions;
  std::vector<BoundaryLinks> links;
  std::vector<ScalarField<double>> gain;
  bool narrow = false;
  for (const auto& [side, x] : {std::pair{Side::left, 0}, {Side::right, gap - 1}}) {
    links.push_back(find_boundary_links(exec, nodes, side, 0, 39, D2Q5::Q));
    gain.emplace_back("gain", links.back().count);
    conditions.push_back(outflow_condition(links.back(), solute_parameters(0.2), s, gain.back()));
    narrow = narrow || is_narrow(exec, nodes, links.back());
    const int q = static_cast<int>(side);
    for (int i = x; i < nodes.count; i += gap) h(q * nodes.capacity + i) = h(D2Q5::opposite(q) * nodes.capacity + i);
  }
  dress<D2Q5, double>(exec, nodes, conditions, narrow);
  Kokkos::deep_copy(expected, h);
  expect_same(expected, s.h, 0);
  return narrow;
}

TEST(OutflowsFaceToFace, AreDressedOneAfterTheOtherWhereOneReadsWhatTheOtherWrites) {
  EXPECT_TRUE(dress_between_outflows(1));
  EXPECT_FALSE(dress_between_outflows(2));
}

/// The links in another order.
BoundaryLinks backwards(const BoundaryLinks& links) {
  BoundaryLinks turned = links;
  turned.fluid = IndexList("fluid", links.count);
  turned.direction = Kokkos::View<std::uint8_t*>("direction", links.count);
  const auto fluid = on_host(links.fluid);
  const auto direction = on_host(links.direction);
  const auto fluid_turned = Kokkos::create_mirror_view(turned.fluid);
  const auto direction_turned = Kokkos::create_mirror_view(turned.direction);
  for (int l = 0; l < links.count; ++l) {
    fluid_turned(l) = fluid(links.count - 1 - l);
    direction_turned(l) = direction(links.count - 1 - l);
  }
  Kokkos::deep_copy(turned.fluid, fluid_turned);
  Kokkos::deep_copy(turned.direction, direction_turned);
  return turned;
}

/// Where an opening lies on both sides of a slot one node wide, its own links meet: each reads what the other writes.
/// Whichever comes first in the list, what leads down or left is dressed first.
TEST(OutflowAroundASlot, HasTheSameBitsInWhateverOrderItsLinksRun) {
  const Exec exec;
  const Lattice lattice(60, 60);
  // columns of slots at x = 10, 14, ..., rows of them below
  const auto is_slot = [](int x, int y) { return y >= 30 ? x % 4 == 2 : y % 4 == 2; };
  const Kokkos::View<NodeType*> type("type", lattice.size());
  const auto host_type = Kokkos::create_mirror_view(type);
  Kokkos::deep_copy(host_type, NodeType::solid);
  std::vector<int> inside;
  for (int y = 5; y < 55; ++y)
    for (int x = 5; x < 55; ++x) {
      const int n = lattice.node(x, y);
      host_type(n) = is_slot(x, y) ? NodeType::fluid : NodeType::opening;
      if (!is_slot(x, y)) inside.push_back(n);
    }
  Kokkos::deep_copy(type, host_type);
  const FluidNodes nodes = make_fluid_nodes(exec, lattice, type);
  const Opening opening = make_opening(lattice, inside, [](const auto&, const auto& out) { return out; });
  const auto dress_links = [&](auto set, bool in_order) {
    using Set = decltype(set);
    const SoluteFields<double> s = make_solute_fields<Set, double>(exec, nodes, 1);
    const auto h = Kokkos::create_mirror_view(s.h);
    for (std::size_t i = 0; i < h.extent(0); ++i) h(i) = std::sin(1.0 + static_cast<double>(i));
    Kokkos::deep_copy(s.h, h);
    const BoundaryLinks found = find_opening_links(exec, nodes, opening, Set::Q);
    const BoundaryLinks links = in_order ? found : backwards(found);
    EXPECT_GT(links.count, 512);  // several blocks
    EXPECT_TRUE(is_narrow(exec, nodes, links));
    const ScalarField<double> gain("gain", links.count);
    const SoluteCondition<double> outflow = outflow_condition(links, solute_parameters(0.2), s, gain);
    dress<Set, double>(exec, nodes, {&outflow, 1}, true);
    return std::pair{s.h, h};
  };
  const auto compare = [&](auto set) {
    using Set = decltype(set);
    const auto [once, before] = dress_links(set, true);
    const auto [again, same] = dress_links(set, false);
    expect_same(once, again, 0);
    const auto dressed = test::host_copy(once);
    const auto index = on_host(nodes.index);
    const auto slot = [&](int q, int x, int y) { return q * nodes.capacity + index(lattice.node(x, y)); };
    for (const auto& [down, x, y] : {std::tuple{3, 18, 40}, {4, 20, 10}})  // uniform C: what comes in is what is there
      EXPECT_EQ(dressed(slot(down, x, y)), before(slot(Set::opposite(down), x, y)));
    for (const auto& [up, x, y] : {std::tuple{1, 18, 40}, {2, 20, 10}})
      EXPECT_EQ(dressed(slot(up, x, y)), before(slot(up, x, y)));
  };
  compare(D2Q5{});
  compare(D2Q9{});
}

}  // namespace
}  // namespace vug
