// Eight nodes at a time against the table of sources, slot by slot.
#include "kernels/nodes/fluid_nodes.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace vug {
namespace {

/// Loose rock, a quarter of it fluid, joined left and right, with nodes born late among the others.
FluidNodes loose_rock() {
  const Lattice lattice(61, 47);
  std::mt19937 random(3);
  const Kokkos::View<NodeType*, Kokkos::HostSpace> early("early", lattice.size()), late("late", lattice.size());
  Kokkos::deep_copy(early, NodeType::solid);
  for (int y = 0; y < lattice.ny; ++y)
    for (int x = 0; x < lattice.nx; ++x)
      if (y % 6 < 2 || random() % 8 == 0) early(lattice.node(x, y)) = NodeType::fluid;
  Kokkos::deep_copy(late, early);
  for (int y = 0; y < lattice.ny; ++y) late(lattice.node(y % lattice.nx, y)) = NodeType::fluid;
  const Kokkos::View<NodeType*> type("type", lattice.size());
  Kokkos::deep_copy(type, early);
  FluidNodes nodes = make_fluid_nodes(Exec{}, lattice, type, {true, false});
  Kokkos::deep_copy(type, late);
  append_births(Exec{}, type, nodes);
  return nodes;
}

template <class T, class Set>
void expect_as_the_table() {
  if constexpr (has_source_windows) {
    const FluidNodes nodes = loose_rock();
    const EightFromHome<T, Set> eight{nodes.windows.data(), nodes.source.data(), nodes.capacity};
    const int slots = Set::Q * nodes.capacity;
    std::vector<T> f(slots), turned(slots, T(-1)), expected(slots, T(-1));
    for (int s = 0; s < slots; ++s) f[s] = static_cast<T>(s);
    int windows = 0, irregular = 0, aligned = 0;
    for (int i = 0; i + nodes_per_window <= nodes.count; i += nodes_per_window) {
      typename Eight<T>::Register g[Set::Q];
      eight.pull(f.data(), i, g);
      for (int q = 1; q < Set::Q; ++q) {
        ++windows;
        const SourceWindow& w = nodes.windows(i + q - 1);
        const auto plane = static_cast<std::uint32_t>(q * nodes.capacity);
        if (w.is_irregular())
          ++irregular;
        else if ((w.near - plane) % nodes_per_window == 0 && (w.far - plane) % nodes_per_window == 0)
          ++aligned;
      }
      for (int q = 0; q < Set::Q; ++q)
        for (int l = 0; l < nodes_per_window; ++l) {
          const int slot = nodes.source(q * nodes.capacity + i + l);
          ASSERT_EQ(g[q][l], f[slot]) << "direction " << q << ", node " << i + l;
          expected[nodes.source(Set::opposite(q) * nodes.capacity + i + l)] = f[slot];
        }
      eight.push(turned.data(), i, g);
    }
    EXPECT_EQ(turned, expected);
    EXPECT_GT(irregular, 0);  // every way is taken
    EXPECT_GT(aligned, windows / 8);
    EXPECT_LT(irregular + aligned, windows);
    EXPECT_LT(irregular, windows / 2);
  } else {
    GTEST_SKIP() << "this host has no registers of eight numbers with masks";
  }
}

TEST(SourceWindows, PullAndPushWhatTheTableSays) {
  expect_as_the_table<double, D2Q9>();
  expect_as_the_table<float, D2Q9>();
  expect_as_the_table<double, D2Q5>();
  expect_as_the_table<float, D2Q5>();
}

}  // namespace
}  // namespace vug
