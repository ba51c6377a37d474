// Where the solid of an opened pathway goes.
#include "coupling/solid_spread.hpp"

#include "kernels/launch/launch.hpp"
#include "support/no_neighbours.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace vug {
namespace {

/// A row of triangles, each of which owns 8 x 8 nodes of a strip of the lattice.
struct RowOfTriangles {
  static constexpr int count = 5, size = 8;
  Lattice lattice{size * count, size};
  Kokkos::View<NodeType*> type{"type", std::size_t(lattice.size())};
  Kokkos::View<std::uint8_t*> opening{"opening", std::size_t(lattice.size())};
  ScalarField<double> volume{"volume", std::size_t(lattice.size())};
  ScalarField<double> dissolved{"dissolved", std::size_t(lattice.size())};
  NodeGroups nodes;
  TriangleNeighbours neighbours = test::no_neighbours(count);

  RowOfTriangles() {
    std::vector<int> key;
    for (int n = 0; n < size * size * count; ++n) key.push_back(n % (size * count) / size);
    nodes = group_nodes(key, count, lattice);
    for (int t = 0; t < count; ++t) {
      neighbours(t, 0) = t - 1;
      neighbours(t, 1) = t + 1 < count ? t + 1 : -1;
      nodes.for_each(t, [&](int n) {
        type(n) = NodeType::solid;
        volume(n) = 1;
      });
    }
  }
  /// All nodes of a triangle but those of its last `left` columns.
  void open(int t, int left) {
    nodes.for_each(t, [&](int n) {
      if (lattice.x(n) % size >= size - left || type(n) == NodeType::fluid) return;
      type(n) = NodeType::fluid;
      opening(n) = 1;
    });
  }
  double held(int t) const {
    double sum = 0;
    nodes.for_each(t, [&](int n) { sum += volume(n); });
    return sum;
  }
  double most() const {
    double most = 0;
    for (int t = 0; t < count; ++t) nodes.for_each(t, [&](int n) { most = std::max(most, volume(n) + dissolved(n)); });
    return most;
  }
};

TEST(SolidSpread, StaysInTheTriangleWhereThereIsRoom) {
  if constexpr (!shares_host_memory) GTEST_SKIP() << "reads views on the host";
  RowOfTriangles rock;
  SolidSpread spread(rock.nodes, rock.neighbours);
  rock.open(2, 5);
  spread(Exec{}, rock.type, rock.opening, rock.volume, rock.dissolved);
  EXPECT_NEAR(rock.held(2), 64, 1e-12);
  EXPECT_NEAR(rock.most(), 8.0 / 5, 1e-14);
  EXPECT_EQ(rock.held(1), 64);
  for (int n = 0; n < rock.lattice.size(); ++n) EXPECT_EQ(rock.opening(n), 0);
}

TEST(SolidSpread, GoesOnToTheNeighboursBeforeANodeHoldsMoreThanTheBound) {
  if constexpr (!shares_host_memory) GTEST_SKIP() << "reads views on the host";
  RowOfTriangles rock;
  SolidSpread spread(rock.nodes, rock.neighbours);
  for (const int left : {3, 1, 0}) {
    rock.open(2, left);
    spread(Exec{}, rock.type, rock.opening, rock.volume, rock.dissolved);
    EXPECT_NEAR(rock.held(2), 2 * 8 * left, 1e-12);
    EXPECT_NEAR(rock.held(1), rock.held(3), 1e-12);
    EXPECT_NEAR(rock.held(0) + rock.held(1) + rock.held(2) + rock.held(3) + rock.held(4), 5 * 64, 1e-12);
    EXPECT_EQ(sum_in_order(spread.waiting()), 0);
    EXPECT_LE(rock.most(), most_solid);
  }
  for (const int t : {1, 3}) rock.open(t, 0);  // 128 nodes are left for the solid of 320
  spread(Exec{}, rock.type, rock.opening, rock.volume, rock.dissolved);
  EXPECT_NEAR(rock.held(0), 128, 1e-12);
  EXPECT_NEAR(sum_in_order(spread.waiting()), 320 - 256, 1e-12);
  rock.open(0, 4);  // what has been waiting waits on beside what is freed now
  spread(Exec{}, rock.type, rock.opening, rock.volume, rock.dissolved);
  EXPECT_NEAR(rock.held(0) + rock.held(4), 64 + 128, 1e-12);
  EXPECT_NEAR(sum_in_order(spread.waiting()), 320 - 192, 1e-12);
}

/// The rows of the lattice are two minerals in turn, of which one opens in the middle triangle.
TEST(SolidSpread, KeepsTheVolumeOfEachMineral) {
  if constexpr (!shares_host_memory) GTEST_SKIP() << "reads views on the host";
  RowOfTriangles rock;
  const Kokkos::View<std::uint8_t*> mineral("mineral", rock.lattice.size());
  for (int n = 0; n < rock.lattice.size(); ++n) mineral(n) = static_cast<std::uint8_t>((rock.lattice.y(n) + 2) % 2);
  SolidSpread spread(rock.nodes, rock.neighbours, {mineral, 2});
  const auto held = [&](int m) {
    double sum = 0;
    for (int t = 0; t < RowOfTriangles::count; ++t)
      rock.nodes.for_each(t, [&](int n) { sum += mineral(n) == m ? rock.volume(n) : 0.0; });
    return sum;
  };
  rock.open(2, 3);
  spread(Exec{}, rock.type, rock.opening, rock.volume, rock.dissolved);
  for (const int m : {0, 1}) EXPECT_NEAR(held(m), 5 * 32, 1e-12) << m;
  rock.nodes.for_each(1, [&](int n) {  // mineral 1 of the second triangle opens, all of it
    if (mineral(n) == 0 || rock.type(n) == NodeType::fluid) return;
    rock.type(n) = NodeType::fluid;
    rock.opening(n) = 1;
  });
  const double of_other = held(0);
  spread(Exec{}, rock.type, rock.opening, rock.volume, rock.dissolved);
  EXPECT_EQ(held(0), of_other);
  EXPECT_NEAR(held(1) + sum_in_order(spread.waiting(1)), 5 * 32, 1e-12);
  EXPECT_EQ(sum_in_order(spread.waiting(0)), 0);
}

TEST(SolidSpread, GivesAWallThatIsNearlyGoneNoMoreThanItHolds) {
  EXPECT_DOUBLE_EQ(room_for_solid(1, 0), most_solid - 1);
  EXPECT_DOUBLE_EQ(room_for_solid(0.1, 0.9), 0.1);
  EXPECT_DOUBLE_EQ(room_for_solid(1.5, 0.25), most_solid - 1.75);
  EXPECT_EQ(room_for_solid(1.5, 1), 0);
  EXPECT_EQ(room_for_solid(-0.1, 1.1), 0);
}

}  // namespace
}  // namespace vug
