// The dimensionless numbers of a case, by hand.
#include "coupling/dimensionless.hpp"

#include "coupling/check.hpp"

#include <gmock/gmock.h>

#include <map>
#include <numbers>

namespace vug {
namespace {

const char* const reacting = R"(
[lattice]
size = [0.008, 0.004]
spacing = 2e-4
time_step = 1e-3
[time]
end = 2.0
[geometry]
type = "shapes"
[[geometry.shapes]]
type = "disc"
centre = [0.004, 0.002]
radius = 0.0008
[flow]
viscosity = 4e-6
[heat]
fluid_diffusivity = 2e-7
solid_diffusivity = 1e-6
[[solute.species]]
name = "acid"
diffusivity = 1e-6
[[solute.species]]
name = "salt"
diffusivity = 5e-7
[reaction]
reactant = "acid"
rate_constant = 1e-3
[[mineral]]
name = "quartz"
rate_constant = 1e-4
[[mineral.shapes]]
type = "rectangle"
from = [0, 0]
to = [0.004, 0.004]
)";
const char* const sides = R"(
[boundary.left]
flow = { type = "velocity", velocity = [0.01, 0] }
[boundary.right]
flow = { type = "pressure", pressure = "1 bar" }
)";

std::map<std::string, double> numbers_of(const std::string& text, const std::vector<std::string>& set = {}) {
  std::map<std::string, double> values;
  for (const DimensionlessNumber& number : dimensionless_numbers(parse_scene(text, "case.toml", set)).numbers)
    values[number.name] = number.value;
  return values;
}

void expect_near(const std::map<std::string, double>& found, const std::map<std::string, double>& expected) {
  EXPECT_EQ(found.size(), expected.size());
  for (const auto& [name, value] : expected) {
    ASSERT_TRUE(found.contains(name)) << name;
    EXPECT_NEAR(found.at(name) / value, 1, 1e-12) << name;
  }
}

/// L = 0.004 m, U = 0.01 m/s, t = 2 s.
TEST(Dimensionless, NumbersAreThoseOfTheCase) {
  expect_near(numbers_of(std::string(reacting) + sides), {{"Re", 10},
                                                          {"Pr", 20},
                                                          {"Pe of heat", 200},
                                                          {"Fo of the fluid", 0.025},
                                                          {"Fo of the rock", 0.125},
                                                          {"Sc of acid", 4},
                                                          {"Pe of acid", 40},
                                                          {"Da of acid", 4},
                                                          {"Da of acid on quartz", 0.4},
                                                          {"Sc of salt", 8},
                                                          {"Pe of salt", 80}});
}

/// Without a prescribed velocity neither Re nor Pe; Da of Eq. 13 is the one given, formed with reaction.length.
TEST(Dimensionless, NumbersThatAreNotKnownAreLeftOut) {
  std::string text = reacting;
  text.replace(text.find("rate_constant = 1e-3"), 20, "damkohler = 1.5\nlength = 0.07");
  const std::string pressures = "[boundary.left]\nflow = { type = \"pressure\", pressure = \"2 bar\" }\n";
  expect_near(numbers_of(text + pressures), {{"Pr", 20},
                                             {"Fo of the fluid", 2e-7 * 2 / 0.0049},
                                             {"Fo of the rock", 1e-6 * 2 / 0.0049},
                                             {"Sc of acid", 4},
                                             {"Da of acid", 1.5},
                                             {"Da of acid on quartz", 7},
                                             {"Sc of salt", 8}});
}

/// A flow rate counts with its mean over the stretch: 8e-5 m2/s over a side of 0.004 m, a stretch of 0.001 m, or what
/// that leaves of the side.
TEST(Dimensionless, AFlowRateGivesAMeanSpeed) {
  const std::string rate = "flow = { type = \"velocity\", flow_rate = 8e-5 }\n";
  EXPECT_NEAR(numbers_of(reacting + ("[boundary.left]\n" + rate)).at("Re"), 20, 1e-12);
  const std::string injection = "[boundary.injection]\nside = \"left\"\ncentre = 0.002\nwidth = 0.001\n";
  EXPECT_NEAR(numbers_of(reacting + (injection + rate)).at("Re"), 80, 1e-12);
  EXPECT_NEAR(numbers_of(reacting + ("[boundary.left]\n" + rate + injection)).at("Re"), 80.0 / 3, 1e-12);
}

/// The rate of a well is spread over its outline.
TEST(Dimensionless, AFlowRateOfAShapeGivesAMeanSpeed) {
  std::string text = reacting;
  text.insert(text.find("centre = [0.004"), "name = \"well\"\n");
  for (const char* rate : {"flow_rate = 8e-5", "mass_flow_rate = 8e-2"})
    EXPECT_NEAR(numbers_of(text + "[boundary.right]\nflow = { type = \"outflow\" }\n[boundary.shape.well]\nflow = { " +
                           "type = \"velocity\", " + rate + " }\n")
                    .at("Re"),
                8e-5 / (2 * std::numbers::pi * 0.0008) * 0.004 / 4e-6, 1e-9)
        << rate;
}

TEST(Dimensionless, NumbersAreInBothFormsOfTheReport) {
  const CheckReport report = check_case(parse_scene(std::string(reacting) + sides, "case.toml"));
  const std::string text = to_text(report), json = to_json(report);
  EXPECT_THAT(text, testing::HasSubstr("dimensionless numbers with L = 0.004 m, the shorter side of the lattice; U = "
                                       "0.01 m/s, the largest prescribed velocity; t = 2 s, the end of the run\n"));
  EXPECT_THAT(text, testing::ContainsRegex("\n  Pe of acid +40  U L / D\n"));
  EXPECT_THAT(json, testing::HasSubstr(R"({"name": "Da of acid", "value": 4, "definition": "k_r^0 L / D"})"));
  EXPECT_TRUE(dimensionless_numbers(parse_scene("[laboratory]\ntest = \"compression\"\nsize = [0.02, 0.04]\n[rock]\n"
                                                "element_size = 2e-3\n",
                                                "a.toml"))
                  .numbers.empty());
}

}  // namespace
}  // namespace vug
