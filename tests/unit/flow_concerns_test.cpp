// Absolute pressures below 0: told of where something draws, and where the level of the pressures is known.
#include "support/watched.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace vug {
namespace {

using test::Watched;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Fluid is drawn out of a channel by 0.1 m/s.
const std::string channel = R"(
[lattice]
size = [20e-6, 10e-6]
spacing = 1e-6
time_step = 1e-7
[time]
steps = 800
[flow]
initial_pressure = 100
viscosity = 1e-6
[boundary.left]
flow = { type = "velocity", velocity = [-0.1, 0] }
[boundary.right]
flow = { type = "pressure", pressure = 100 }
)";
const auto told = AllOf(HasSubstr("warning: absolute pressures below 0 (down to -"),
                        HasSubstr("boundary.left draws faster than the pressures"));

TEST(PressuresBelowZero, AreToldOfWhereVelocitiesDraw) {
  EXPECT_THAT(Watched(channel).steps(400), ElementsAre(told));
  EXPECT_THAT(Watched(channel, {"flow.initial_pressure=1e5", "boundary.right.flow.pressure=1e5"}).steps(400),
              IsEmpty());
  EXPECT_THAT(Watched(channel, {"boundary.left.flow.velocity=[0.1, 0]"}).steps(400), IsEmpty());
}

/// A rate that is farther from 0 while it presses than when it draws.
TEST(PressuresBelowZero, AreToldOfWhereARateDrawsInTheEnd) {
  for (const char* rate : {"flow_rate = [[0, 2e-6], [1e-5, 2e-6], [2e-5, -1e-6]]",
                           "mass_flow_rate = [[0, 2e-3], [1e-5, 2e-3], [2e-5, -1e-3]]"})
    EXPECT_THAT(Watched(channel, {std::string("boundary.left.flow={ type = \"velocity\", ") + rate + " }"}).steps(800),
                ElementsAre(told))
        << rate;
}

/// From 0 pressures are counted as differences; between velocities their level follows from nothing.
TEST(PressuresBelowZero, AreMeantWherePressuresAreDifferences) {
  EXPECT_THAT(Watched(channel, {"flow.initial_pressure=0", "boundary.right.flow.pressure=0"}).steps(400), IsEmpty());
  EXPECT_THAT(Watched(channel, {"boundary.right.flow={ type = \"velocity\", velocity = [-0.1, 0] }"}).steps(400),
              IsEmpty());
}

}  // namespace
}  // namespace vug
