// Where the solid of an opened pathway goes.
#include "coupling/solid_spread.hpp"

#include "kernels/launch/launch.hpp"
#include "support/host_copy.hpp"
#include "support/no_neighbours.hpp"
#include "support/nodes_of_groups.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace vug {
namespace {

using test::edit;

/// A row of triangles, each of which owns 8 x 8 nodes of a strip of the lattice.
struct RowOfTriangles {
  static constexpr int count = 5, size = 8;
  Lattice lattice{size * count, size};
  Kokkos::View<NodeType*> type{"type", std::size_t(lattice.size())};
  Kokkos::View<std::uint8_t*> opening{"opening", std::size_t(lattice.size())};
  ScalarField<double> volume{"volume", std::size_t(lattice.size())};
  ScalarField<double> dissolved{"dissolved", std::size_t(lattice.size())};
  NodeGroups nodes;
  std::vector<std::vector<int>> nodes_of;  ///< (triangle)
  TriangleNeighbours neighbours = test::no_neighbours(count);

  RowOfTriangles() {
    std::vector<int> key;
    for (int n = 0; n < size * size * count; ++n) key.push_back(n % (size * count) / size);
    nodes = group_nodes(key, count, lattice);
    nodes_of = test::nodes_of_groups(nodes);
    edit(neighbours, [](const auto& beyond) {
      for (int t = 0; t < count; ++t) beyond(t, 0) = t - 1, beyond(t, 1) = t + 1 < count ? t + 1 : -1;
    });
    edit(type, [&](const auto& kind) {
      for (int t = 0; t < count; ++t)
        for (const int n : nodes_of[t]) kind(n) = NodeType::solid;
    });
    edit(volume, [&](const auto& V) {
      for (int t = 0; t < count; ++t)
        for (const int n : nodes_of[t]) V(n) = 1;
    });
  }
  /// Opens those nodes of a triangle that `which` picks and that are still solid.
  template <class Which>
  void open_nodes(int t, const Which& which) {
    edit(type, [&](const auto& kind) {
      edit(opening, [&](const auto& opens) {
        for (const int n : nodes_of[t])
          if (which(n) && kind(n) != NodeType::fluid) kind(n) = NodeType::fluid, opens(n) = 1;
      });
    });
  }
  /// All nodes of a triangle but those of its last `left` columns.
  void open(int t, int left) {
    open_nodes(t, [&](int n) { return lattice.x(n) % size < size - left; });
  }
  double held(int t) const {
    const auto V = test::host_copy(volume);
    double sum = 0;
    for (const int n : nodes_of[t]) sum += V(n);
    return sum;
  }
  double most() const {
    const auto V = test::host_copy(volume), gone = test::host_copy(dissolved);
    double most = 0;
    for (const auto& nodes_of_one : nodes_of)
      for (const int n : nodes_of_one) most = std::max(most, V(n) + gone(n));
    return most;
  }
};

TEST(SolidSpread, StaysInTheTriangleWhereThereIsRoom) {
  RowOfTriangles rock;
  SolidSpread spread(rock.nodes, rock.neighbours);
  rock.open(2, 5);
  spread(Exec{}, rock.type, rock.opening, rock.volume, rock.dissolved);
  EXPECT_NEAR(rock.held(2), 64, 1e-12);
  EXPECT_NEAR(rock.most(), 8.0 / 5, 1e-14);
  EXPECT_EQ(rock.held(1), 64);
  const auto opening = test::host_copy(rock.opening);
  for (int n = 0; n < rock.lattice.size(); ++n) EXPECT_EQ(opening(n), 0);
}

TEST(SolidSpread, GoesOnToTheNeighboursBeforeANodeHoldsMoreThanTheBound) {
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
  RowOfTriangles rock;
  const auto mineral = [&](int n) { return (rock.lattice.y(n) + 2) % 2; };
  std::vector<std::uint8_t> minerals;
  for (int n = 0; n < rock.lattice.size(); ++n) minerals.push_back(static_cast<std::uint8_t>(mineral(n)));
  SolidSpread spread(rock.nodes, rock.neighbours, {to_device<Kokkos::View<std::uint8_t*>>("mineral", minerals), 2});
  const auto held = [&](int m) {
    const auto V = test::host_copy(rock.volume);
    double sum = 0;
    for (const auto& nodes : rock.nodes_of)
      for (const int n : nodes) sum += mineral(n) == m ? V(n) : 0.0;
    return sum;
  };
  rock.open(2, 3);
  spread(Exec{}, rock.type, rock.opening, rock.volume, rock.dissolved);
  for (const int m : {0, 1}) EXPECT_NEAR(held(m), 5 * 32, 1e-12) << m;
  rock.open_nodes(1, [&](int n) { return mineral(n) == 1; });  // all of it in the second triangle
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
