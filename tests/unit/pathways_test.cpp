// Pathways that bonds open with damage or as they gape, and cracks narrower than a cell within them.
#include "coupling/pathways.hpp"

#include "coupling/rock.hpp"
#include "coupling/slits.hpp"
#include "coupling/strip.hpp"
#include "kernels/launch/launch.hpp"
#include "support/host_copy.hpp"
#include "support/no_neighbours.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug {
namespace {

TEST(PathwayAperture, GrowsLinearlyWithDamage) {
  EXPECT_EQ(pathway_aperture(0, 0, 3), 0);
  EXPECT_EQ(pathway_aperture(0.5, 1, 3), 2);
  EXPECT_EQ(pathway_aperture(1, 0, 3), 3);
}

/// One bond along y = 4 through one particle that owns the whole 8 x 8 lattice.
struct BondOfAPathway {
  Lattice lattice{8, 8};
  Kokkos::View<NodeType*> type{"type", std::size_t(Lattice(8, 8).size())};
  ScalarField<double> volume{"volume", std::size_t(Lattice(8, 8).size())};
  ScalarField<double> dissolved{"dissolved", std::size_t(Lattice(8, 8).size())};
  ScalarField<double> d_m{"d_m", 1};
  NodeGroups particle;
  PathwayNodes nodes;

  BondOfAPathway() {
    Kokkos::deep_copy(type, NodeType::solid);
    const auto v = Kokkos::create_mirror_view(volume);
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 8; ++x) v(lattice.node(x, y)) = 1 - 0.01 * x;
    Kokkos::deep_copy(volume, v);
    particle = group_nodes(std::vector<int>(64, 0), 1, lattice);
    const auto strip = strip_nodes({0, 4}, {8, 4}, 3, lattice, 1.0);
    const int n = static_cast<int>(strip.size());
    nodes = {.node = IndexList("node", n),
             .offset = IndexList("offset", n + 1),
             .bond = IndexList("bond", n),
             .least = ScalarField<double>("least", n),
             .closed = ScalarField<double>("closed", 1),
             .open = ScalarField<double>("open", 1),
             .slope = ScalarField<double>("slope", 1),
             .filled = ScalarField<double>("filled", n),
             .in_order = IndexList("in_order", n),
             .first = IndexList("first", 2)};
    const auto node = Kokkos::create_mirror_view(nodes.node), offset = Kokkos::create_mirror_view(nodes.offset);
    const auto least = Kokkos::create_mirror_view(nodes.least);
    const auto in_order = Kokkos::create_mirror_view(nodes.in_order), first = Kokkos::create_mirror_view(nodes.first);
    first(1) = n;
    Kokkos::deep_copy(nodes.first, first);
    for (int c = 0; c < n; ++c) {
      node(c) = lattice.node(strip[c].node % 8, strip[c].node / 8);
      least(c) = strip[c].aperture;
      offset(c + 1) = c + 1;
      in_order(c) = n - 1 - c;
    }
    Kokkos::deep_copy(nodes.in_order, in_order);
    Kokkos::deep_copy(nodes.node, node);
    Kokkos::deep_copy(nodes.offset, offset);
    Kokkos::deep_copy(nodes.least, least);
    Kokkos::deep_copy(nodes.open, 3.0);
  }
  double total() const {
    const auto v = test::host_copy(volume);
    double sum = 0;
    for (std::size_t i = 0; i < v.extent(0); ++i) sum += v(i);
    return sum;
  }
};

TEST(PathwayOpener, OpensWithDamageNeverClosesAndKeepsTheSolidVolume) {
  BondOfAPathway rock;
  PathwayOpener opener(rock.lattice, rock.nodes, SolidSpread(rock.particle, test::no_neighbours(1)));
  const double before = rock.total();
  const auto open = [&](double d_m) {
    Kokkos::deep_copy(rock.d_m, d_m);
    return opener.look(Exec{}, rock.d_m).changed > 0 ? opener.open(Exec{}, rock.type, rock.volume, rock.dissolved) : 0;
  };
  EXPECT_EQ(open(0), 0);
  EXPECT_EQ(open(0.3), 0);       // narrower than a cell
  EXPECT_EQ(open(2.0 / 3), 16);  // the two rows beside the line
  EXPECT_NEAR(rock.total(), before, 1e-12 * before);
  EXPECT_EQ(open(0.2), 0);
  EXPECT_EQ(open(1.0), 8);  // the third row, the lower one of two as near
  EXPECT_NEAR(rock.total() + sum_in_order(opener.waiting()), before, 1e-12 * before);
  const auto type = test::host_copy(rock.type);
  const auto volume = test::host_copy(rock.volume);
  for (int x = 0; x < 8; ++x) {
    EXPECT_EQ(type(rock.lattice.node(x, 3)), NodeType::fluid);
    EXPECT_EQ(volume(rock.lattice.node(x, 3)), 0);
    EXPECT_EQ(type(rock.lattice.node(x, 2)), NodeType::fluid);
    EXPECT_EQ(type(rock.lattice.node(x, 5)), NodeType::solid);
    EXPECT_GT(volume(rock.lattice.node(x, 0)), 1.3);
    EXPECT_LE(volume(rock.lattice.node(x, 0)), most_solid * (1 + 1e-14));
  }
}

/// Given in metres, a width may be less than a cell: the row of the line opens and conducts by the cubic law.
TEST(PathwayOpener, OpensARowForASlotNarrowerThanACell) {
  BondOfAPathway rock;
  rock.nodes.cubic = true;
  PathwayOpener opener(rock.lattice, rock.nodes, SolidSpread(rock.particle, test::no_neighbours(1)));
  for (const auto& [d_m, rows] : {std::pair{0.003, 0}, {0.1, 1}, {1 / 3.0, 1}, {0.9, 2}, {1.0, 3}}) {
    Kokkos::deep_copy(rock.d_m, d_m);
    const double width = 3 * d_m;
    EXPECT_EQ(opener.look(Exec{}, rock.d_m).narrow, width >= 0.01 && width < 1.144 ? 1 : 0) << width;
    opener.open(Exec{}, rock.type, rock.volume, rock.dissolved);
    const auto type = test::host_copy(rock.type);
    int open = 0;
    for (int y = 0; y < 8; ++y) open += type(rock.lattice.node(0, y)) == NodeType::fluid;
    EXPECT_EQ(open, rows) << width;
    EXPECT_DOUBLE_EQ(test::host_copy(opener.bonds().conductivity)(0), width * width * width / 12);
  }
}

/// Its nodes stay open and must be dragged, also where it closes at once and for good.
TEST(PathwayOpener, SeesACrackThatIsNarrowerThanItHasBeen) {
  BondOfAPathway rock;
  PathwayOpener opener(rock.lattice, rock.nodes, SolidSpread(rock.particle, test::no_neighbours(1)));
  const auto narrow = [&](double d_m) {
    Kokkos::deep_copy(rock.d_m, d_m);
    return opener.look(Exec{}, rock.d_m).narrow;
  };
  EXPECT_EQ(narrow(0), 0);
  EXPECT_EQ(narrow(1), 0);        // three whole rows
  EXPECT_EQ(narrow(2.0 / 3), 1);  // two of them
  EXPECT_EQ(narrow(0), 1);
  EXPECT_EQ(narrow(1), 0);
}

/// A crack half a cell wide: one row is open, and its resistance is that of the cubic law and of what acid adds.
TEST(Slits, HaveTheResistanceOfTheCrackThatAcidWidens) {
  BondOfAPathway rock;
  Geometry geometry;
  geometry.lattice = rock.lattice;
  geometry.type = rock.type;
  geometry.dissolved = rock.dissolved;
  const BondPathways bonds{ScalarField<double>("strip", 1), ScalarField<double>("widest", 1),
                           ScalarField<double>("conductivity", 1)};
  Kokkos::deep_copy(bonds.strip, 1.0);
  Kokkos::deep_copy(bonds.widest, 1.0);
  Kokkos::deep_copy(bonds.conductivity, cubic_law(0.5));
  const auto type = Kokkos::create_mirror_view(rock.type);
  Kokkos::deep_copy(type, rock.type);
  for (int x = 0; x < 8; ++x) type(rock.lattice.node(x, 3)) = NodeType::fluid;
  Kokkos::deep_copy(rock.type, type);
  geometry.fluid = make_fluid_nodes(Exec{}, rock.lattice, rock.type);
  const auto dissolved = Kokkos::create_mirror_view(rock.dissolved);
  dissolved(rock.lattice.node(2, 4)) = 0.1;  // one wall of column 2, both of column 5, all of that of column 7
  dissolved(rock.lattice.node(5, 2)) = 0.2;
  dissolved(rock.lattice.node(5, 4)) = 0.3;
  dissolved(rock.lattice.node(7, 4)) = 1;
  Kokkos::deep_copy(rock.dissolved, dissolved);
  Slits slits(rock.nodes);
  slits.update(Exec{}, bonds, geometry);
  ASSERT_EQ(geometry.slits.count, 7);
  EXPECT_EQ(geometry.slit_changes, 1);
  slits.update(Exec{}, bonds, geometry);
  EXPECT_EQ(geometry.slit_changes, 1);
  const auto fluid = test::host_copy(geometry.slits.fluid);
  const auto resistance = test::host_copy(geometry.slits.resistance);
  const auto first = test::host_copy(geometry.slits.first);
  const auto openness = test::host_copy(geometry.slits.openness);
  EXPECT_EQ(first(0), 0);
  EXPECT_EQ(first(1), 7);
  for (int k = 0; k < 7; ++k) {
    const int x = fluid(k);  // numbered along the row
    const double w = x == 2 ? 0.6 : x == 5 ? 1.0 : 0.5;
    EXPECT_NEAR(resistance(k), 12 / (w * w * w) - 8, 1e-9) << x;
    EXPECT_NEAR(openness(fluid(k)), w, 1e-12) << x;
  }
  EXPECT_EQ(openness(7), 1);  // no slit: one of its walls is gone
  // the crack closes: what it has opened is a hundredth of a cell wide
  Kokkos::deep_copy(bonds.strip, 0.0);
  slits.update(Exec{}, bonds, geometry);
  ASSERT_EQ(geometry.slits.count, 8);
  EXPECT_EQ(test::host_copy(geometry.slits.fluid)(7), 0);
  EXPECT_NEAR(test::host_copy(geometry.slits.resistance)(7) / (12 / 1e-6 - 8), 1, 1e-9);
  EXPECT_NEAR(test::host_copy(geometry.slits.openness)(0), 0.01, 1e-12);
}

/// The same bonds have pathways, as wide in metres, whatever the spacing; they take the porosity asked for.
TEST(RockPathways, AreTheSameOnAnyLatticeWhereTheirWidthIsInMetres) {
  const auto widths = [](double spacing) {
    const Scene scene = parse_scene(fmt::format(R"(
[lattice]
size = [0.04, 0.03]
spacing = {}
time_step = 1e-6
[time]
steps = 1
[geometry]
type = "rock"
[rock]
element_size = 2e-3
porosity = 0.1
pathway_width = 1.5e-4
[[rock.notches]]
from = [0.01, 0.015]
to = [0.02, 0.015]
width = 3e-4
[flow]
viscosity = 1e-6
[mechanics]
[damage]
)",
                                                spacing),
                                    "case.toml");
    const Rock rock = build_rock(scene, Lattice(scene.lattice.nx, scene.lattice.ny));
    if (spacing < 1e-4) {
      EXPECT_NEAR(rock.porosity, 0.1, 0.01);
    }
    std::vector<double> metres;
    const auto closed = test::host_copy(rock.pathways.closed);
    for (std::size_t b = 0; b < closed.extent(0); ++b) metres.push_back(std::round(closed(b) * spacing * 1e9));
    return metres;
  };
  const auto fine = widths(5e-5);
  EXPECT_GT(std::count(fine.begin(), fine.end(), 1.5e5), 50);
  EXPECT_GE(std::count(fine.begin(), fine.end(), 3e5), 4);
  EXPECT_EQ(widths(2.5e-4), fine);
  EXPECT_EQ(widths(1e-4), fine);
}

}  // namespace
}  // namespace vug
