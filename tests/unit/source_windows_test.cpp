// Packs of nodes against the table of sources, slot by slot.
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

/// By windows, whether this host's library uses them or not, or one by one.
template <class T, class Set, bool by_windows>
void expect_as_the_table() {
  if constexpr (runs_on_host) {
    const FluidNodes nodes = loose_rock();
    std::vector<SourceWindow> windows(nodes.capacity);
    const SourcePacks<T, Set, by_windows> packs{windows.data(), nodes.source.data(), nodes.capacity};
    const int slots = Set::Q * nodes.capacity;
    std::vector<T> f(slots), turned(slots, T(-1)), expected(slots, T(-1));
    for (int s = 0; s < slots; ++s) f[s] = static_cast<T>(s);
    int regular = 0, irregular = 0, aligned = 0;
    for (int i = 0; i + pack_size <= nodes.count; i += pack_size) {
      for (int q = 1; q < Set::Q; ++q) {
        const int plane = q * nodes.capacity;
        const SourceWindow w = windows[i + q - 1] = source_window(&nodes.source(plane + i), plane, nodes.capacity);
        ASSERT_TRUE(!has_source_windows || w == nodes.windows(i + q - 1)) << i << ' ' << q;
        if (w.is_irregular())
          ++irregular;
        else if ((w.near - plane) % nodes_per_window == 0 && (w.far - plane) % nodes_per_window == 0)
          ++aligned;
        else
          ++regular;
      }
      Pack<T> g[Set::Q];
      packs.pull(f.data(), i, g);
      T upstream[2][Set::Q][pack_size];  // of two fields, the second without direction 3
      for (T& left : upstream[1][3]) left = T(-1);
      packs.upstream({f.data(), f.data() + 1}, i, upstream, [](int q, int field) { return field == 0 || q != 3; });
      for (int q = 0; q < Set::Q; ++q)
        for (int l = 0; l < pack_size; ++l) {
          const int slot = nodes.source(q * nodes.capacity + i + l), from = slot - q * nodes.capacity;
          ASSERT_EQ(g[q][l], f[slot]) << "direction " << q << ", node " << i + l;
          const int there = from >= 0 && from < nodes.capacity ? from : i + l;
          ASSERT_EQ(upstream[0][q][l], f[there]) << q << ' ' << i + l;
          ASSERT_EQ(upstream[1][q][l], q == 3 ? T(-1) : f[there + 1]) << q << ' ' << i + l;
          expected[nodes.source(Set::opposite(q) * nodes.capacity + i + l)] = f[slot];
        }
      packs.push(turned.data(), i, g);
    }
    EXPECT_EQ(turned, expected);
    EXPECT_GT(irregular, 0);  // every way is taken
    EXPECT_GT(aligned, (regular + aligned) / 8);
    EXPECT_GT(regular + aligned, irregular);
    EXPECT_GT(regular, 0);
  } else {
    GTEST_SKIP() << "a GPU has no packs";
  }
}

TEST(SourceWindows, PullAndPushWhatTheTableSays) {
  expect_as_the_table<double, D2Q9, true>();
  expect_as_the_table<float, D2Q9, true>();
  expect_as_the_table<double, D2Q5, true>();
  expect_as_the_table<float, D2Q5, true>();
}

TEST(SourcePacks, PullAndPushWhatTheTableSaysOneByOne) {
  expect_as_the_table<double, D2Q9, false>();
  expect_as_the_table<float, D2Q9, false>();
  expect_as_the_table<double, D2Q5, false>();
  expect_as_the_table<float, D2Q5, false>();
}

}  // namespace
}  // namespace vug
