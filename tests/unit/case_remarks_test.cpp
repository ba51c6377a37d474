// What a case may say but probably does not mean is remarked, and what is meant is not.
#include "support/case_shapes.hpp"
#include "unit/case_files.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace vug {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing_cases::parsed;
using testing_cases::shipped;

TEST(CaseRemarks, LowReferenceTemperatureIsRemarkedNotRefused) {
  const Scene scene = shipped("quickstart.toml", {"reaction.reference_temperature=237.15"});
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("reaction.reference_temperature = 237.15 K is below 250 K")));
}

/// exp(E_a/R (1/T_0 - 1/273.15 K)) of the case's own activation energy and temperature.
TEST(CaseRemarks, LowReferenceTemperatureHasTheFactorOfItsOwnRate) {
  const auto told = [](std::vector<std::string> set) {
    set.emplace_back("reaction.activation_energy=10000");
    return shipped("quickstart.toml", set).warnings;
  };
  EXPECT_THAT(shipped("quickstart.toml", {"reaction.reference_temperature=237.15"}).warnings,
              ElementsAre(HasSubstr("which makes the rate 66.5 times as high")));
  EXPECT_THAT(told({"reaction.reference_temperature=237.15"}),
              ElementsAre(HasSubstr("makes the rate 1.95 times as high")));
  EXPECT_THAT(told({"reaction.reference_temperature=249"}),
              ElementsAre(HasSubstr("makes the rate 1.53 times as high")));
}

/// 20 for 20 degC, at the start or at a side, also for a while; not what is written with its unit.
TEST(CaseRemarks, TemperaturesThatAreMeantInDegreesAreRemarked) {
  const auto warnings = [](const std::string& start, const std::string& side) {
    return parsed("[heat]\nfluid_diffusivity = 1e-5\nsolid_diffusivity = 1e-5\ninitial_temperature = " + start +
                  "\n[boundary.left]\nheat = { type = \"temperature\", temperature = " + side + " }\n")
        .warnings;
  };
  const auto told = Contains(HasSubstr("kelvin; in degrees Celsius it is written \"20 degC\""));
  EXPECT_THAT(warnings("20", "300"), told);
  EXPECT_THAT(warnings("215", "300"), Contains(HasSubstr("it is written \"215 degC\"")));
  EXPECT_THAT(warnings("260", "300"), Not(Contains(HasSubstr("kelvin"))));
  EXPECT_THAT(warnings("\"90 degC\"", "20"), told);
  EXPECT_THAT(warnings("\"90 degC\"", "[[0, 300], [1, 20]]"), told);
  EXPECT_THAT(warnings("\"90 degC\"", "\"20 degC\""), Not(Contains(HasSubstr("kelvin"))));
}

/// 15 for 15 MPa; not a weak rock.
TEST(CaseRemarks, StressesThatAreMeantInMegapascalsAreRemarked) {
  const auto warnings = [](const std::string& key, const std::string& value) {
    return shipped("laboratory/compression.toml", {key + "=" + value}).warnings;
  };
  for (const std::string key :
       {"mechanics.bond.normal_strength", "mechanics.bond.cohesion", "laboratory.confinement"}) {
    EXPECT_THAT(warnings(key, "15"), Contains(HasSubstr("is written \"15 MPa\""))) << key;
    EXPECT_THAT(warnings(key, "\"0.1 MPa\""), Not(Contains(HasSubstr("pascals")))) << key;
    EXPECT_THAT(warnings(key, "0"), Not(Contains(HasSubstr("pascals")))) << key;
  }
}

/// 6 and 0 for a difference of 6 Pa; not what is given beside an initial pressure of zero.
TEST(CaseRemarks, PressuresThatAreMeantAboveTheInitialOneAreRemarked) {
  const auto warnings = [](const std::string& initial, const std::string& left) {
    return parsed("[boundary.left]\nflow = { type = \"pressure\", pressure = " + left +
                      " }\n[boundary.right]\nflow = { type = \"pressure\", pressure = 0 }\n",
                  {"flow.initial_pressure=" + initial})
        .warnings;
  };
  EXPECT_THAT(warnings("1e5", "6"), Contains(HasSubstr("pressures are absolute")));
  EXPECT_THAT(warnings("0", "6"), Not(Contains(HasSubstr("pressures are absolute"))));
  EXPECT_THAT(warnings("1e5", "1.00006e5"), Not(Contains(HasSubstr("pressures are absolute"))));
}

/// Brine, of which [heat] still says water; not what differs by a few degrees.
TEST(CaseRemarks, TwoDensitiesOfOneFluidAreRemarked) {
  const auto warnings = [](const std::vector<std::string>& set) { return shipped("quickstart.toml", set).warnings; };
  const auto told = Contains(HasSubstr("heat.fluid_density = 1000 kg/m3 and flow.density = 1200 kg/m3"));
  EXPECT_THAT(warnings({"flow.density=1200"}), told);
  EXPECT_THAT(warnings({"flow.density=1200", "heat.fluid_density=1200"}), IsEmpty());
  EXPECT_THAT(warnings({"flow.density=958.4"}), IsEmpty());
}

/// At the peak of its table, as fast as a light platen would be.
TEST(CaseRemarks, FastPlatensAreRemarked) {
  const auto warnings = [](const std::string& top, const std::string& scaling = "1") {
    return parsed("[geometry]\ntype = \"rock\"\n[rock]\nelement_size = 4e-3\n[mechanics]\nmass_scaling = " + scaling +
                  "\n[boundary.bottom]\ntraction = { support = \"roller\" }\n[boundary.top.traction]\n" + top)
        .warnings;
  };
  const std::string roller = "support = \"roller\"\nvelocity = ";
  EXPECT_THAT(warnings(roller + "[0, -1]"), Not(Contains(HasSubstr("platen"))));
  EXPECT_THAT(warnings(roller + "[[0, 0, 0], [1, 0, -5], [2, 0, 2]]"),
              Contains(HasSubstr("boundary.top.traction.velocity moves a platen at up to 5 m/s: above 1 m/s")));
  EXPECT_THAT(warnings(roller + "[0, 0.6]", "4"),
              Contains(HasSubstr("at up to 0.6 m/s, which with mechanics.mass_scaling = 4 acts like 1.2 m/s: above")));
  EXPECT_THAT(warnings("parts = [{ from = 0, to = 1e-2, support = \"fixed\", velocity = [0.8, -0.8] }]"),
              Contains(HasSubstr("boundary.top.traction.parts.0.velocity moves a platen at up to 1.13")));
}

/// 20 mm at about 3.1 km/s and more, and twice that at four times the mass: a push that is over by then is an impact.
TEST(CaseRemarks, BlowsAreNoPresses) {
  const auto remarked = [](double end, const std::string& scaling) {
    const std::string time = std::to_string(1e6 * end) + " us\"";
    const auto warnings =
        parsed("[geometry]\ntype = \"rock\"\n[rock]\nelement_size = 4e-3\n[mechanics]\nmass_scaling = " + scaling +
               "\n[boundary.bottom]\ntraction = { support = \"roller\" }\n[boundary.top.traction]\nsupport = "
               "\"roller\"\nvelocity = [[0, 0, 0], [\"1 us\", 0, -5], [\"" +
               time + ", 0, 0]]\n")
            .warnings;
    return std::any_of(warnings.begin(), warnings.end(),
                       [](const std::string& line) { return line.find("moves a platen") != std::string::npos; });
  };
  EXPECT_FALSE(remarked(5e-6, "1"));
  EXPECT_TRUE(remarked(8e-6, "1"));
  EXPECT_FALSE(remarked(10e-6, "4"));
  EXPECT_TRUE(remarked(16e-6, "4"));
}

TEST(CaseRemarks, NotchesThatDamageWidensAreRemarked) {
  const auto warnings = [](const std::vector<std::string>& set) { return shipped("quickstart.toml", set).warnings; };
  const auto widened = HasSubstr("only until the first update");
  EXPECT_THAT(
      warnings({"rock.notches.0.aperture=1"}),
      ElementsAre(HasSubstr("is 1 cells wide only until the first update, and about 3 wide from then on, like every "
                            "broken bond: lower damage.minimum_aperture and damage.pathway_factor to")));
  EXPECT_THAT(warnings({"rock.notches.0.aperture=1", "damage.minimum_aperture=1", "damage.pathway_factor=0"}),
              Not(Contains(widened)));
  // c_d times the distance of the centroids, edge / sqrt(3)
  EXPECT_THAT(warnings({"damage.pathway_factor=1"}), ElementsAre(HasSubstr("lower damage.pathway_factor to keep")));
  EXPECT_THAT(warnings({"rock.notches.0.aperture=4", "damage.pathway_factor=1e-9"}), Not(Contains(widened)));
  EXPECT_THAT(warnings({"rock.notches.0.aperture=4", "damage.pathway_widening=added"}), Contains(widened));
  EXPECT_THAT(warnings({"rock.notches.0.aperture=0"}), Not(Contains(widened)));  // closed: what damage gives it
}

TEST(CaseRemarks, ShapesCutByAJoinedSideAreRemarkedUnlessTheirImageIsDrawn) {
  const auto warnings = [&](const std::string& shapes) {
    return parsed(
               "[geometry]\ntype = \"shapes\"\n[boundary.left]\nflow = { type = \"periodic\" }\n[boundary.right]\n"
               "flow = { type = \"periodic\" }\n" +
               shapes)
        .warnings;
  };
  const double length = parsed("").lattice.length_x, height = parsed("").lattice.length_y, radius = length / 8;
  EXPECT_THAT(
      warnings(test::disc(length, height / 2, radius, "")),
      ElementsAre(HasSubstr("geometry.shapes.0 reaches over the right side, which is periodic, and is cut there")));
  EXPECT_TRUE(warnings(test::disc(length, height / 2, radius, "") + test::disc(0, height / 2, radius, "")).empty());
  EXPECT_TRUE(warnings(test::disc(length / 2, 0, radius, "")).empty());  // a wall cuts it
  EXPECT_TRUE(warnings(test::rectangle(-length, 0, 2 * length, height / 4, "")).empty());
}

TEST(CaseRemarks, WidthsOfTheirOwnUnderScaledPressuresAreRemarked) {
  const auto warnings = [](const std::vector<std::string>& set) { return shipped("quickstart.toml", set).warnings; };
  const auto scaled = HasSubstr("the flow through them is");
  EXPECT_THAT(warnings({"damage.aperture=opening"}), Contains(scaled));
  EXPECT_THAT(warnings({"damage.aperture=opening", "flow.pressure_scale=1"}), Not(Contains(scaled)));
}

/// It is for pathways that are a number of cells wide.
TEST(CaseRemarks, ScaledPressuresWithoutRockAreRemarked) {
  const auto warnings = [](double scale) {
    return shipped("poiseuille.toml", {fmt::format("flow.pressure_scale={}", scale)}).warnings;
  };
  EXPECT_THAT(warnings(25), ElementsAre(HasSubstr("drive 25 times too little flow")));
  EXPECT_THAT(warnings(1), IsEmpty());
}

TEST(CaseRemarks, WhatFluidCarriesToAnOutletMayLeaveIsRemarked) {
  EXPECT_THAT(shipped("quickstart.toml", {"boundary.right.heat={type=\"adiabatic\"}"}).warnings,
              ElementsAre(HasSubstr("boundary.right lets fluid out, but heat is adiabatic")));
  const std::string with_heat =
      "[heat]\nfluid_diffusivity = 1e-3\nsolid_diffusivity = 1e-3\n[boundary.right]\nheat = { type = \"outflow\" }\n";
  const auto warnings = [&](const std::string& flow, const std::string& more = "") {
    return parsed(with_heat + "flow = { type = \"outflow\" }\n" + more + flow).warnings;
  };
  const std::string left = "[boundary.left]\nflow = { type = \"velocity\", velocity = ";
  EXPECT_TRUE(warnings(left + "[0.1, 0] }\n").empty());  // comes in with the initial temperature
  EXPECT_THAT(warnings(left + "[-0.1, 0] }\n"), ElementsAre(HasSubstr("boundary.left lets fluid out")));
  EXPECT_THAT(warnings(left + "[-0.1, 0] }\nheat = { type = \"flux\", flux = 1 }\n"),
              ElementsAre(HasSubstr("but heat is a flux")));
  EXPECT_TRUE(warnings(left + "[-0.1, 0] }\nheat = { type = \"temperature\", temperature = 300 }\n").empty());
  EXPECT_THAT(warnings("[boundary.top]\nflow = { type = \"velocity\", flow_rate = -1e-4 }\n"),
              ElementsAre(HasSubstr("boundary.top lets fluid out")));
}

TEST(CaseRemarks, InertiaThatStrengthensTheRockIsRemarked) {
  EXPECT_TRUE(shipped("laboratory/compression.toml", {"mechanics.mass_scaling=4"}).warnings.empty());
  EXPECT_THAT(shipped("laboratory/compression.toml", {"mechanics.mass_scaling=16"}).warnings,
              ElementsAre(HasSubstr("act like 2 m/s")));
  for (const auto& [test, slow, fast] :
       {std::array{"tension", "0.2", "0.3"}, {"brazilian", "1", "1.5"}, {"compression", "1", "1.5"}}) {
    const auto at = [name = std::string("laboratory/") + test + ".toml"](const std::string& speed) {
      return shipped(name, {"laboratory.platen_speed=" + speed}).warnings;
    };
    EXPECT_TRUE(at(slow).empty()) << test;
    EXPECT_THAT(at(fast), ElementsAre(HasSubstr("inertia adds to the strength"))) << test;
  }
  EXPECT_THAT(shipped("quickstart.toml", {"mechanics.mass_scaling=100"}).warnings,
              ElementsAre(AllOf(HasSubstr("slows waves down by a factor of 10"), Not(HasSubstr("local_damping")))));
  EXPECT_THAT(shipped("quickstart.toml", {"mechanics.mass_scaling=100", "mechanics.local_damping=0"}).warnings,
              ElementsAre(HasSubstr("with mechanics.local_damping = 0 these waves hardly decay and break bonds")));
}

/// By heat alone as well: nothing flows there.
TEST(CaseRemarks, ALatticeThatIsPeriodicWhereTheRockIsNot) {
  const auto warnings = [](const char* at_the_ends) {
    return parse_scene(std::string("[lattice]\nsize = [40, 30]\nspacing = 1\ntime_step = 1e-6\n[time]\nsteps = 10\n"
                                   "[geometry]\ntype = \"rock\"\n[rock]\nelement_size = 10\n[mechanics]\n"
                                   "[heat]\nfluid_diffusivity = 1e3\nsolid_diffusivity = 1e3\n"
                                   "[boundary.bottom]\ntraction = { support = \"roller\" }\n") +
                           at_the_ends,
                       "a.toml")
        .warnings;
  };
  EXPECT_TRUE(warnings("").empty());
  EXPECT_THAT(warnings("heat = { type = \"periodic\" }\n[boundary.top]\nheat = { type = \"periodic\" }\n"),
              ElementsAre("the lattice is periodic across bottom and top, the rock never is"));
}

TEST(CaseRemarks, OutputThatAddsNoColumn) {
  const auto joined = [](const char* low, const char* high) {
    return std::string("[boundary.") + low + "]\nflow = { type = \"periodic\" }\n[boundary." + high +
           "]\nflow = { type = \"periodic\" }\n";
  };
  const auto warnings = [](const std::string& output, const std::string& sides) {
    return parsed("[output]\n" + output + sides).warnings;
  };
  const std::string all = joined("left", "right") + joined("bottom", "top"), some = joined("left", "right");
  EXPECT_THAT(warnings("forces = true\n", all), ElementsAre(HasSubstr("output.forces = true adds no column")));
  EXPECT_TRUE(warnings("forces = true\n", some).empty());
  EXPECT_THAT(warnings("flows = true\n", some), ElementsAre(HasSubstr("output.flows = true adds no column")));
  EXPECT_TRUE(warnings("flows = true\n", some + "[boundary.top]\nflow = { type = \"outflow\" }\n").empty());
  EXPECT_TRUE(warnings("", all).empty());
}

TEST(CaseRemarks, AFlowThatIsNotHeldWhileCracksFill) {
  const auto warnings = [](const std::string& aperture) {
    return shipped("quickstart.toml", {"accuracy.flow_tolerance=1e-3", "damage.aperture=" + aperture}).warnings;
  };
  const auto held = HasSubstr("the flow is not held while there are cracks narrower than a cell");
  EXPECT_THAT(warnings("opening"), Contains(held));
  EXPECT_THAT(warnings("damage"), Not(Contains(held)));
}

}  // namespace
}  // namespace vug
