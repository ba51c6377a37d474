// Walls that slide and fluid that is given a velocity, where their stretch ends: a closed box keeps its mass, and rock,
// corners and neighbouring stretches make no difference that they do not make to the flow.
#include "support/case_shapes.hpp"
#include "support/coupled_run.hpp"
#include "verification/surface_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace vug {
namespace {

using namespace test::surfaces;

constexpr int n = 12;
constexpr double u = 0.05 * dx / dt;

/// A box as text, upright or lying: in the latter x and y are exchanged.
struct Box {
  bool lies = false;
  std::string text = lattice(n, n) + flow + told;

  std::string name(const std::string& side) const {
    if (!lies) return side;
    return side == "left" ? "bottom" : side == "bottom" ? "left" : side == "right" ? "top" : "right";
  }
  std::string pair(double x, double y) const {
    return lies ? fmt::format("[{:.17g}, {:.17g}]", y, x) : fmt::format("[{:.17g}, {:.17g}]", x, y);
  }
  Box& rock(double x0, double y0, double x1, double y1) {
    if (text.find("[geometry]") == std::string::npos) text += "[geometry]\ntype = \"shapes\"\n";
    text += "[[geometry.shapes]]\ntype = \"rectangle\"\nfrom = " + pair(x0 * dx, y0 * dx) +
            "\nto = " + pair(x1 * dx, y1 * dx) + "\n";
    return *this;
  }
  Box& side(const std::string& which, const std::string& type, double x, double y, const std::string& more = "") {
    text +=
        "[boundary." + name(which) + "]\nflow = { type = \"" + type + "\", velocity = " + pair(x, y) + more + " }\n";
    return *this;
  }
  Box& joined(const std::string& which) {
    text += "[boundary." + name(which) + "]\nflow = { type = \"periodic\" }\n";
    return *this;
  }
  /// Cells [first, last) of a side.
  Box& part(const std::string& which, const char* own, int first, int last, const std::string& type, double x,
            double y) {
    text += fmt::format("[[boundary.injection]]\nname = \"{}\"\nside = \"{}\"\ncentre = {:.17g}\nwidth = {:.17g}\n",
                        own, name(which), (first + last) * dx / 2, (last - first) * dx) +
            "flow = { type = \"" + type + "\", velocity = " + pair(x, y) + " }\n";
    return *this;
  }
};

std::vector<Box> closed_boxes(bool lies) {
  std::vector<Box> boxes;
  const auto box = [&]() -> Box& { return boxes.emplace_back(Box{lies}); };
  box().rock(9, 0, n, n).side("top", "wall", u, 0);
  box().rock(9, 7, n, n).side("top", "wall", u, 0);
  box().rock(0, 9, 3, n).rock(5, 9, 6, n).side("top", "velocity", u, 0);
  box().part("top", "belt", 0, 6, "wall", u, 0);
  box().part("top", "belt", 0, 6, "velocity", u, 0);
  box().part("top", "belt", 4, 9, "wall", u, 0);
  box().part("top", "belt", 2, 5, "wall", u, 0).part("top", "next", 5, n, "wall", -u / 3, 0);
  box().part("top", "belt", 2, 5, "wall", u, 0).side("top", "velocity", u / 2, 0);
  box().part("top", "belt", 0, 5, "wall", u, 0).joined("left").joined("right");
  box().part("top", "belt", 5, 6, "wall", u, 0).rock(6, 10, 8, n);
  box().side("top", "velocity", u, 0).side("right", "velocity", 0, u);
  box().side("top", "velocity", u, 0).side("right", "velocity", 0, 0);
  box().side("top", "wall", u, 0).side("right", "wall", 0, u / 2).side("left", "velocity", 0, u);
  box().side("top", "velocity", u, 0, ", profile = \"table\", profile_table = [[0, 0.2], [0.02, 1.7]]");
  box().joined("left").joined("right").side("top", "velocity", u, 0,
                                            ", profile = \"table\", profile_table = [[0, 0.2], [0.02, 1.7]]");
  // what one side brings in the next one takes out, also by the link that both have at the corner
  box().side("left", "velocity", u, u / 3).side("top", "velocity", u / 2, u);
  box().side("left", "velocity", u, 0).side("right", "wall", 0, u).side("top", "velocity", 0, u);
  return boxes;
}

TEST(SlidingWalls, AClosedBoxKeepsItsMass) {
  for (const bool lies : {false, true})
    for (const Box& box : closed_boxes(lies)) {
      test::CoupledRun run(box.text);
      run.steps(300);
      const double node = density * dx * dx;
      EXPECT_NEAR(run.now("fluid_mass_stored_kg_per_m") / node, 0, 1e-11) << box.text;
      EXPECT_GT(run.now("largest_mach_1"), 1e-3) << box.text;
    }
}

TEST(SlidingWalls, AClosedBoxKeepsItsMassWhereASpeedChanges) {
  Box box;
  box.text += fmt::format("[boundary.top]\nflow = {{ type = \"wall\", velocity = [[0, 0, 0], [0.1, {}, 0]] }}\n", u);
  box.part("right", "belt", 4, n, "wall", 0, -u).rock(0, 10, 2, n);
  test::CoupledRun run(box.text);
  run.steps(200);
  EXPECT_NEAR(run.now("fluid_mass_stored_kg_per_m") / (density * dx * dx), 0, 1e-11);
}

/// Rock at the end of a wall that slides is as good as a side there, and a wall in two parts as one.
TEST(SlidingWalls, EndAtRockAsAtASide) {
  const auto speeds = [](const Box& box, int wide) {
    test::CoupledRun run(box.text);
    run.steps(400);
    std::vector<double> found;
    const std::vector<double> all = run.nodes("velocity");
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < 9; ++x)
        for (int axis = 0; axis < 2; ++axis) found.push_back(all[2 * (y * wide + x) + axis] * dt / dx);
    return found;
  };
  Box narrow;
  narrow.text = lattice(9, n) + flow;
  narrow.side("top", "wall", u, 0);
  const std::vector<double> exact = speeds(narrow, 9);
  Box rock = Box().rock(9, 0, n, n).side("top", "wall", u, 0), parts = narrow;
  parts.part("top", "belt", 3, 6, "wall", u, 0);
  const std::vector<double> by_rock = speeds(rock, n), in_parts = speeds(parts, 9);
  for (std::size_t k = 0; k < exact.size(); ++k) {
    EXPECT_NEAR(by_rock[k], exact[k], 1e-15) << k;
    EXPECT_NEAR(in_parts[k], exact[k], 1e-15) << k;
  }
}

/// No fluid goes to one side on the whole in a closed box: sum of the velocities over each column, second order in the
/// cell. (A wall that kept its mass node by node would drive U/6 of a cell.)
TEST(SlidingWalls, DriveNoNetFlowInAClosedBox) {
  for (const bool lies : {false, true}) {
    test::CoupledRun run(Box{lies}.rock(10, 0, n, n).side("top", "wall", u, 0).text);
    run.steps(3000);
    const std::vector<double> all = run.nodes("velocity");
    double net = 0;
    for (int across = 0; across < n; ++across) net += lies ? all[2 * (5 * n + across) + 1] : all[2 * (across * n + 5)];
    EXPECT_LT(std::abs(net), 0.02 * u) << lies;
  }
}

/// Fluid that crosses the whole box at an angle, with a velocity given on all sides, is a uniform flow; its corners
/// have the flow of both sides.
TEST(SlidingWalls, AUniformFlowCrossesAllSides) {
  Box box;
  for (const char* side : {"left", "right", "bottom", "top"}) box.side(side, "velocity", u, -u / 3);
  test::CoupledRun run(box.text);
  run.steps(4000);
  const std::vector<double> all = run.nodes("velocity");
  for (std::size_t k = 0; k < all.size(); k += 2) {
    EXPECT_NEAR(all[k], u, 1e-12 * u) << k / 2;
    EXPECT_NEAR(all[k + 1], -u / 3, 1e-12 * u) << k / 2;
  }
  for (const auto& [side, part] : {std::pair{"left", 1.0}, {"right", -1.0}, {"bottom", -1 / 3.0}, {"top", 1 / 3.0}})
    EXPECT_NEAR(run.now(std::string(side) + "_mass_flow_kg_per_m_s"), part * density * u * n * dx, 1e-9) << side;
}

/// A rate is spread over the link at a corner as well, which a stretch of the other side has.
TEST(SlidingWalls, RatesAtACornerAreGivenInFull) {
  for (const bool lies : {false, true}) {
    Box box{lies};
    const auto rate = [&](const std::string& side, double value) {
      box.text +=
          fmt::format("[boundary.{}]\nflow = {{ type = \"velocity\", flow_rate = {} }}\n", box.name(side), value);
    };
    rate("left", 3e-5);
    rate("top", -3e-5);
    test::CoupledRun run(box.text);
    run.steps(300);
    EXPECT_NEAR(run.now(box.name("left") + "_mass_flow_kg_per_m_s") / density, 3e-5, 1e-15);
    EXPECT_NEAR(run.now(box.name("top") + "_mass_flow_kg_per_m_s") / density, -3e-5, 1e-15);
    EXPECT_NEAR(run.now("fluid_mass_stored_kg_per_m") / (density * dx * dx), 0, 1e-11);
  }
}

/// What only moves along the side, from one stretch into the next one, enters through neither.
TEST(SlidingWalls, FlowsBesideThemAreThoseThatCrossTheSide) {
  for (const bool lies : {false, true}) {
    Box box{lies};
    box.side("bottom", "wall", u, 0);
    box.text += fmt::format(
        "[[boundary.injection]]\nname = \"in\"\nside = \"{}\"\ncentre = {}\nwidth = {}\n"
        "flow = {{ type = \"velocity\", flow_rate = 3e-5 }}\n",
        box.name("bottom"), 5 * dx, 4 * dx);
    box.part("top", "out", 2, 5, "velocity", u, u / 4).part("top", "back", 5, 9, "velocity", -u / 3, -u / 8);
    box.text += "[boundary." + box.name("right") + "]\nflow = { type = \"pressure\", pressure = 3e5 }\n";
    test::CoupledRun run(box.text);
    run.steps(50);
    EXPECT_NEAR(run.now("injection_in_mass_flow_kg_per_m_s") / density, 3e-5, 1e-15) << lies;
    EXPECT_NEAR(run.now("injection_out_mass_flow_kg_per_m_s") / density, -3 * dx * u / 4, 1e-15) << lies;
    EXPECT_NEAR(run.now("injection_back_mass_flow_kg_per_m_s") / density, 4 * dx * u / 8, 1e-15) << lies;
  }
}

}  // namespace
}  // namespace vug
