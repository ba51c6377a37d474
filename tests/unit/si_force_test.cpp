// What the fluid does to triangles, in SI: Archimedes' law gives force and torque exactly, on the stair-step as well.
#include "dem_support.hpp"
#include "support/coupled_run.hpp"
#include "support/meshed_rock.hpp"
#include "support/rock_output.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace vug {
namespace {

using test::Point;

constexpr int nx = 24, ny = 20;
constexpr double dx = 2e-3, dt = 1e-3, density = 800;

const std::string box = R"(
[lattice]
size = [0.048, 0.040]
spacing = 2e-3
time_step = 1e-3
[time]
steps = 100000
[geometry]
type = "rock"
[flow]
density = 800
viscosity = 1.2e-3
initial_pressure = 3e5
pressure_scale = 5
[mechanics]
density = 1e6  # hardly moves
substeps = 3
force_unstable = true  # nothing that it could swing against
[mechanics.bond]
normal_strength = 1e12
cohesion = 1e12
)";

Point at(double x, double y) {
  return {x * dx, y * dx};
}

/// One triangle in the middle of the water.
class SubmergedTriangle : public testing::Test {
 protected:
  SubmergedTriangle() { test::write_text(folder_ / "rock.msh", test::mesh_text({a_, b_, c_}, {{0, 1, 2}})); }
  test::CoupledRun run(std::vector<std::string> overrides) const {
    overrides.push_back("rock.mesh=\"" + (folder_ / "rock.msh") + "\"");
    return test::CoupledRun(box, overrides);
  }

  const Point a_ = at(8.3, 4.2), b_ = at(17.6, 8.1), c_ = at(10.2, 15.7);
  const std::vector<Point> nodes_ = test::nodes_inside(a_, b_, c_, nx, ny, dx);

 private:
  test::TemporaryFolder folder_;
};

/// A force that sets in at once leaves a momentum in a closed box whose sign changes with every step and which nothing
/// damps (bounce-back): 2e-4 of the force here. The mean of two steps is free of it.
TEST_F(SubmergedTriangle, IsLiftedByTheWeightOfTheFluidThatItDisplaces) {
  const Point g{2.0, -9.81};  // m/s2
  test::CoupledRun rock = run({"flow.body_force=[2.0, -9.81]"});
  rock.steps(12000);
  Point force{0, 0};
  double turned = 0;
  for (int step = 0; step < 2; ++step) {
    rock.steps(1);
    const std::vector<double> now = test::of_triangles(rock.rock(), "force");
    for (int axis = 0; axis < 2; ++axis) force[axis] += now[axis] / 2;
    turned += test::host_copy(rock.rock().particles().torque)(0) / 2;
  }
  const Point centre = test::centroid(a_, b_, c_);
  double torque = 0;
  for (const Point& p : nodes_) torque -= density * dx * dx * ((p[0] - centre[0]) * g[1] - (p[1] - centre[1]) * g[0]);
  const double volume = static_cast<double>(nodes_.size()) * dx * dx, weight = density * 9.81 * volume;
  for (int axis = 0; axis < 2; ++axis) EXPECT_NEAR(force[axis], -density * g[axis] * volume, 1e-7 * weight);
  EXPECT_NEAR(turned, torque, 1e-7 * weight * dx);
  EXPECT_GT(std::abs(torque), 0.05 * weight * dx);  // there is one
}

/// Newton's law in SI, with the mass of what is solid: the step is a lattice step in three.
TEST_F(SubmergedTriangle, FollowsItsForce) {
  test::CoupledRun rock = run({"flow.body_force=[2.0, -9.81]"});
  const double mass = 1e6 * test::double_area(a_, b_, c_) / 2, h = dt / 3;
  Point v{0, 0}, u{0, 0};
  for (int step = 0; step < 200; ++step) {
    rock.steps(1);
    const std::vector<double> force = test::of_triangles(rock.rock(), "force");
    for (int part = 0; part < 3; ++part)
      for (int axis = 0; axis < 2; ++axis) {
        v[axis] += h * force[axis] / mass;
        u[axis] += h * v[axis];
      }
  }
  const std::vector<double> moved = test::of_triangles(rock.rock(), "displacement");
  EXPECT_GT(u[1], 0);
  for (int axis = 0; axis < 2; ++axis) EXPECT_NEAR(moved[axis] / u[axis], 1, 1e-10);
}

/// It turns about its centroid: (a^2 + b^2 + c^2) / 36 is the square of its radius of gyration.
TEST_F(SubmergedTriangle, TurnsWithItsTorque) {
  test::CoupledRun rock = run({"flow.body_force=[2.0, -9.81]"});
  const auto side2 = [](const Point& p, const Point& q) { return std::pow(p[0] - q[0], 2) + std::pow(p[1] - q[1], 2); };
  const double mass = 1e6 * test::double_area(a_, b_, c_) / 2, h = dt / 3;
  const double inertia = mass * (side2(a_, b_) + side2(b_, c_) + side2(c_, a_)) / 36;
  double spin = 0, angle = 0;
  for (int step = 0; step < 200; ++step) {
    rock.steps(1);
    const double torque = test::host_copy(rock.rock().particles().torque)(0);
    for (int part = 0; part < 3; ++part) {
      spin += h * torque / inertia;
      angle += h * spin;
    }
  }
  EXPECT_NE(angle, 0);
  EXPECT_NEAR(test::of_triangles(rock.rock(), "rotation")[0] / angle, 1, 1e-10);
}

/// Two triangles make a block of 10 x 6 cells; each is pressed against the other by p over its outer faces. Where a
/// face ends, the diagonal links count with either neighbour: up to half a cell.
TEST(SubmergedBlock, IsSqueezedByThePressureOnItsFaces) {
  test::TemporaryFolder folder;
  test::write_text(folder / "rock.msh",
                   test::mesh_text({at(7, 7), at(17, 7), at(17, 13), at(7, 13)}, {{0, 1, 2}, {0, 2, 3}}));
  std::string sides;
  for (const std::string side : {"left", "right", "bottom", "top"})
    sides += "[boundary." + side + "]\nflow = { type = \"pressure\", pressure = 302e3 }\n";
  test::CoupledRun run(box + sides, {"rock.mesh=\"" + (folder / "rock.msh") + "\""});
  run.steps(3000);
  const double p = 2000;  // Pa, gauge
  const std::vector<double> force = test::of_triangles(run.rock(), "force");
  EXPECT_NEAR(force[0], -p * 6 * dx, 0.5 * p * dx);  // the lower right one, by its right face
  EXPECT_NEAR(force[1], p * 10 * dx,
              2.5 * p * dx);  // by its lower face, of which the diagonal takes a cell at each end
  EXPECT_NEAR(force[0] + force[2], 0, 1e-8 * p * dx);
  EXPECT_NEAR(force[1] + force[3], 0, 1e-8 * p * dx);
}

}  // namespace
}  // namespace vug
