// Tables of a case become sections of a Scene, in SI and with the documented defaults.
#include "base/require.hpp"
#include "io/case_keys.hpp"
#include "io/presets.hpp"
#include "io/scene.hpp"
#include "unit/case_files.hpp"
#include "unit/image_setup.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

namespace vug {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing_cases::open_flow;
using testing_cases::parsed;
using testing_cases::shipped;

TEST(CaseTables, QuickstartIsThePapersRockInSI) {
  const Scene scene = shipped("quickstart.toml");
  EXPECT_EQ(scene.name, "quickstart");
  EXPECT_EQ(scene.lattice.nx, 400);
  EXPECT_EQ(scene.lattice.ny, 280);
  EXPECT_DOUBLE_EQ(*scene.time.end, 0.16);
  EXPECT_EQ(scene.geometry.kind, GeometryKind::rock);
  EXPECT_DOUBLE_EQ(scene.rock->porosity, 0.15);
  EXPECT_DOUBLE_EQ(scene.rock->hole->to[1], 0.037);
  ASSERT_EQ(scene.rock->notches.size(), 1u);
  EXPECT_DOUBLE_EQ(scene.flow->viscosity, 2.2e-3);
  EXPECT_DOUBLE_EQ(scene.flow->pressure_scale, 25);
  EXPECT_DOUBLE_EQ(scene.heat->initial_temperature - scene.injections.at(0).conditions.heat.temperature.at(0), 200);
  ASSERT_EQ(scene.solute->species.size(), 2u);
  EXPECT_DOUBLE_EQ(scene.injections.at(0).conditions.solute.concentration.at("L1").at(0), 3000);
  EXPECT_DOUBLE_EQ(scene.injections.at(0).conditions.flow.pressure.at(0), 20e6);
  EXPECT_DOUBLE_EQ(scene.reaction->rate_constant, 1.5 * 5e-4 / 0.07);  // Eq. 13
  EXPECT_DOUBLE_EQ(scene.reaction->inverse_equilibrium_constant, 1e-7);
  EXPECT_DOUBLE_EQ(scene.mechanics->parameters.bond.cohesion, 58e6);
  EXPECT_DOUBLE_EQ(scene.mechanics->parameters.bond.normal_modulus, 24.03e9);
  EXPECT_EQ(scene.left.traction.load.support, Support::roller);
  EXPECT_DOUBLE_EQ(scene.right.traction.load.normal_stress.at(0), 5e6);
  EXPECT_DOUBLE_EQ(scene.top.traction.load.normal_stress.at(0), 7.5e6);
  EXPECT_EQ(scene.bottom.flow.kind, FlowBoundaryKind::pressure);
  EXPECT_EQ(scene.bottom.solute.kind, SoluteBoundaryKind::outflow);
  EXPECT_TRUE(scene.warnings.empty());
}

TEST(CaseTables, EveryShippedCaseIsValid) {
  EXPECT_EQ(shipped("poiseuille.toml").left.flow.kind, FlowBoundaryKind::periodic);
  const Scene cavity = shipped("diffusion_reaction.toml");
  EXPECT_EQ(cavity.lattice.ny, 81);
  EXPECT_FALSE(cavity.flow.has_value());
  EXPECT_DOUBLE_EQ(cavity.reaction->rate_constant, 4.8 * 1e-9 / 0.8e-3);
  EXPECT_EQ(cavity.reaction->inverse_equilibrium_constant, 0);
}

TEST(CaseTables, LaboratoryCasesHoldRockAloneAndTheirProfiles) {
  for (const char* name : {"compression", "tension", "brazilian", "quench"}) {
    const Scene scene = shipped(std::string("laboratory/") + name + ".toml");
    EXPECT_TRUE(scene.laboratory && scene.rock && scene.mechanics && !scene.flow) << name;
  }
  const Scene scale = shipped("laboratory/compression.toml", {"mechanics.profile=weibull-scale"});
  const MechanicsParameters& rock = scale.mechanics->parameters;
  EXPECT_NEAR(rock.bond.cohesion, 95e6 * 0.935437, 100);  // Gamma(8/7)
  EXPECT_NEAR(rock.bond.normal_strength, 15e6 * 0.935437, 20);
  EXPECT_EQ(rock.bond.weibull_shape, 7);
  for (const auto& [shape, mean] : {std::pair{"1", 1.0}, {"2", 0.886227}, {"0", 1.0}}) {  // Gamma(2), Gamma(1.5)
    const BondParameters bond =
        shipped("laboratory/compression.toml",
                {"mechanics.profile=weibull-scale", std::string("mechanics.bond.weibull_shape=") + shape})
            .mechanics->parameters.bond;
    EXPECT_NEAR(bond.cohesion, 95e6 * mean, 100) << shape;
    EXPECT_NEAR(bond.fracture_energy_II, 64 * mean / 1.2, 1e-4) << shape;
  }
  EXPECT_EQ(rock.bond.internal_friction, 0);
  EXPECT_FALSE(rock.chemical.normalised);
}

TEST(CaseTables, BondsGetTheFractureEnergiesOverThePathRatio) {
  const Scene scene =
      shipped("laboratory/compression.toml", {"mechanics.bond.path_ratio=1.25", "mechanics.bond.fracture_energy_I=30"});
  EXPECT_DOUBLE_EQ(scene.mechanics->parameters.bond.fracture_energy_I, 24);
  EXPECT_DOUBLE_EQ(scene.mechanics->parameters.bond.fracture_energy_II, 51.2);
}

TEST(CaseTables, FitsOfChemicalDamageAreThoseOfTheCase) {
  const auto law_of = [](const std::vector<std::string>& set) {
    return shipped("quickstart.toml", set).mechanics->parameters.chemical;
  };
  const ChemicalDamageLaw printed = law_of({});
  EXPECT_EQ(std::vector({printed.strength.square, printed.strength.linear, printed.strength.constant}),
            std::vector({-0.83, 0.017, 0.98}));
  EXPECT_EQ(std::vector({printed.energy.square, printed.energy.linear, printed.energy.constant}),
            std::vector({5.29, -3.34, 1.01}));
  const ChemicalDamageLaw own = law_of({"damage.strength_fit=[0, -1, 1]", "damage.energy_fit=[1, -2, 1.5]"});
  EXPECT_EQ(std::vector({own.strength.square, own.strength.linear, own.strength.constant}), std::vector({0., -1., 1.}));
  EXPECT_EQ(std::vector({own.energy.square, own.energy.linear, own.energy.constant}), std::vector({1., -2., 1.5}));
  // 0 at d_c = 1 is allowed, before it is not: 4 d^2 - 4 d + 1 is 0 at 0.5
  EXPECT_THROW(law_of({"damage.strength_fit=[4, -4, 1]"}), InputError);
  EXPECT_THROW(law_of({"damage.strength_fit=[0, -1, 0]"}), InputError);
  EXPECT_THROW(law_of({"damage.energy_fit=[0, 1, 1]"}), InputError);
}

TEST(CaseTables, AnAbsentTableIsPhysicsNotModelled) {
  const Scene scene = parsed("");
  EXPECT_TRUE(scene.flow.has_value());
  EXPECT_FALSE(scene.heat || scene.solute || scene.reaction || scene.rock || scene.mechanics || scene.damage);
  EXPECT_TRUE(scene.injections.empty());
  EXPECT_EQ(scene.geometry.kind, GeometryKind::open);
  EXPECT_EQ(scene.accuracy.preset, "careful");
  EXPECT_EQ(scene.left.flow.kind, FlowBoundaryKind::wall);
}

TEST(CaseTables, UnitsInTextAreConvertedToSI) {
  const Scene scene = parsed(R"(
initial_pressure = "10 MPa"
[heat]
fluid_diffusivity = "1.4 mm2/s"
solid_diffusivity = 1
initial_temperature = "15 degC"
[solute]
[[solute.species]]
name = "A"
diffusivity = 1
initial = "3 mol/L"
[boundary.top]
flow = { type = "pressure", pressure = "1bar", ramp_time = "5 ms" }
)",
                             {"lattice.size=[\"1 cm\", \"20 mm\"]", "lattice.time_step=100 us"});
  EXPECT_DOUBLE_EQ(scene.flow->initial_pressure, 10e6);
  EXPECT_DOUBLE_EQ(scene.heat->fluid_diffusivity, 1.4e-6);
  EXPECT_DOUBLE_EQ(scene.heat->solid_diffusivity, 1.0);  // an integer is a number
  EXPECT_DOUBLE_EQ(scene.heat->initial_temperature, 288.15);
  EXPECT_DOUBLE_EQ(scene.solute->species[0].initial, 3000);
  EXPECT_DOUBLE_EQ(scene.top.flow.pressure.at(0), 1e5);
  EXPECT_DOUBLE_EQ(scene.top.flow.ramp_time, 5e-3);
  EXPECT_DOUBLE_EQ(scene.lattice.time_step, 1e-4);
  EXPECT_EQ(scene.lattice.nx, 10);
  EXPECT_EQ(scene.lattice.ny, 20);
}

/// nu = mu / rho, whichever of the two stands first.
TEST(CaseTables, DynamicViscosityIsDividedByTheDensity) {
  const std::string lattice = open_flow.substr(0, open_flow.find("viscosity"));
  for (const char* flow :
       {"dynamic_viscosity = \"3 mPa s\"\ndensity = 800\n", "density = 800\ndynamic_viscosity = 3e-3\n"})
    EXPECT_DOUBLE_EQ(parse_scene(lattice + flow, "a.toml").flow->viscosity, 3.75e-6) << flow;
}

/// Bytes 1 and 2 are 1 + 2 x 256 where the least significant comes first.
TEST(CaseTables, RawImagesSayWhichByteComesFirst) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "a.raw", "\1\2");
  const auto value = [&](const std::string& order) {
    return test::values_of(parsed("[geometry]\ntype = \"image\"\nraw_size = [1, 1]\nraw_type = \"uint16\"\nfile = \"" +
                                  (folder / "a.raw") + "\"\n" + order)
                               .geometry.image);
  };
  EXPECT_THAT(value(""), ElementsAre(513));
  EXPECT_THAT(value("raw_order = \"little\""), ElementsAre(513));
  EXPECT_THAT(value("raw_order = \"big\""), ElementsAre(258));
}

TEST(CaseTables, ShapesKeepTheirOrderAndMaterial) {
  const Scene scene = parsed(R"([geometry]
type = "shapes"
background = "solid"
[[geometry.shapes]]
type = "disc"
centre = [0.005, 0.01]
radius = 0.002
material = "fluid"
[[geometry.shapes]]
type = "polygon"
points = [[0, 0], [0.01, 0], [0, 0.02]]
[[geometry.shapes]]
type = "rectangle"
from = [0, 0]
to = [0.001, 0.001]
)");
  EXPECT_EQ(scene.geometry.background, "solid");
  ASSERT_EQ(scene.geometry.shapes.size(), 3u);
  EXPECT_FALSE(scene.geometry.shapes[0].solid);
  EXPECT_DOUBLE_EQ(std::get<Disc>(scene.geometry.shapes[0].form).radius, 0.002);
  EXPECT_TRUE(scene.geometry.shapes[1].solid);
  EXPECT_DOUBLE_EQ(std::get<Polygon>(scene.geometry.shapes[1].form).points[2][1], 0.02);
  EXPECT_DOUBLE_EQ(std::get<Rectangle>(scene.geometry.shapes[2].form).to[0], 0.001);
}

TEST(CaseTables, PresetsAreOverriddenBySingleKeys) {
  const Scene fast = parsed("[accuracy]\npreset = \"fast\"\nheat_interval = 8\n");
  EXPECT_EQ(fast.accuracy.precision, Precision::single_precision);
  EXPECT_EQ(fast.accuracy.heat_interval, 8);
  EXPECT_EQ(fast.accuracy.solute_interval, accuracy_of(Preset::fast).solute_interval);
  const Scene reference = parsed("[accuracy]\npreset = \"reference\"\n");
  EXPECT_EQ(reference.accuracy.precision, Precision::double_precision);
  EXPECT_EQ(reference.accuracy.update_interval, 1);
  EXPECT_EQ(reference.accuracy.wall_interval, 1);
}

TEST(CaseTables, APresetReachesTheMechanics) {
  for (const Preset preset : {Preset::fast, Preset::balanced, Preset::careful, Preset::reference}) {
    const std::string name = accuracy_of(preset).preset;
    EXPECT_EQ(preset_of(name), preset);
    const Scene scene = shipped("quickstart.toml", {"accuracy.preset=" + name});
    EXPECT_EQ(scene.mechanics->critical_fraction, mechanics_of(preset).critical_fraction) << name;
    EXPECT_EQ(scene.mechanics->parameters.mass_scaling, mechanics_of(preset).parameters.mass_scaling) << name;
    EXPECT_EQ(scene.mechanics->parameters.rest_tolerance, mechanics_of(preset).parameters.rest_tolerance) << name;
    const Scene own = shipped("quickstart.toml", {"accuracy.preset=" + name, "mechanics.rest_tolerance=0.02",
                                                  "mechanics.critical_fraction=0.2"});
    EXPECT_EQ(own.mechanics->parameters.rest_tolerance, 0.02) << name;
    EXPECT_EQ(own.mechanics->critical_fraction, 0.2) << name;
  }
}

TEST(CaseTables, MechanicsProfilesDifferInCohesionOnly) {
  EXPECT_DOUBLE_EQ(shipped("quickstart.toml", {"mechanics.profile=paper-literal"}).mechanics->parameters.bond.cohesion,
                   95e6);
  const Scene own = shipped("quickstart.toml", {"mechanics.bond.cohesion=60 MPa"});
  EXPECT_EQ(own.mechanics->profile, "calibrated");
  EXPECT_DOUBLE_EQ(own.mechanics->parameters.bond.cohesion, 60e6);
}

TEST(CaseOverrides, ReachTablesElementsAndThingsNotThereYet) {
  const Scene scene =
      shipped("quickstart.toml", {"solute.species.1.diffusivity=1e-9", "rock.notches.0.to=[0.03, 0.035]",
                                  "rock.notches.1.from=[0.02, 0.03]", "rock.notches.1.to=[0.03, 0.03]",
                                  "mechanics.contact.friction=0.5", "case.name=other", "output.fields.0=pressure"});
  EXPECT_DOUBLE_EQ(scene.solute->species[1].diffusivity, 1e-9);
  EXPECT_DOUBLE_EQ(scene.rock->notches[0].to[0], 0.03);
  ASSERT_EQ(scene.rock->notches.size(), 2u);
  EXPECT_DOUBLE_EQ(scene.mechanics->parameters.contact.friction, 0.5);
  EXPECT_EQ(scene.name, "other");
  EXPECT_THAT(scene.output.fields, ElementsAre("pressure"));
  EXPECT_EQ(scene.overrides.size(), 7u);
}

TEST(CaseOverrides, MayBeWholeTables) {
  const Scene scene =
      shipped("quickstart.toml", {"time={ steps = 64000 }", "rock.seed=9",
                                  "mineral=[{ name = \"salt\", shapes = [{ type = \"disc\", centre = [0.05, "
                                  "0.03], radius = 0.01 }] }]"});
  EXPECT_EQ(*scene.time.steps, 64000);
  EXPECT_FALSE(scene.time.end);
  ASSERT_EQ(scene.minerals.size(), 1u);
  EXPECT_EQ(scene.minerals[0].name, "salt");
  EXPECT_TRUE(shipped("minerals.toml", {"mineral=[]"}).minerals.empty());
}

TEST(CaseOverrides, TheLastOfTwoWins) {
  EXPECT_EQ(*parsed("", {"time.steps=5", "time.steps=7"}).time.steps, 7);
}

}  // namespace
}  // namespace vug
