// Specimens of a case with a [laboratory]: what they are, and what is warned of and refused before a test.
#include "coupling/specimen.hpp"

#include "base/require.hpp"
#include "support/meshed_rock.hpp"
#include "support/temporary_folder.hpp"
#include "unit/laboratory_case.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace vug {
namespace {

using test::laboratory;

/// The limit of a case's specimen that has this name.
Limit limit_of(const Scene& scene, const std::string& name) {
  const Assembly specimen = build_specimen(scene);
  for (const Limit& limit : limits_of_specimen(scene, specimen, Mechanics(specimen, scene.mechanics->parameters, {})))
    if (limit.name == name) return limit;
  throw InputError("no limit " + name);
}

/// 8e-6 x 100 K of 30 mm in 1 ms, and with 16 times the mass four times that.
TEST(SpecimenOfACase, KnowsHowFastHeatStrainsIt) {
  const std::string name = "speed of thermal strain over the height";
  const Limit slow = limit_of(laboratory("heating", {"laboratory.temperature_change=100"}), name);
  EXPECT_NEAR(slow.value, 0.024, 1e-12);
  EXPECT_TRUE(slow.inside());
  const std::vector<std::string> fast{"laboratory.temperature_change=100", "laboratory.duration=5e-5",
                                      "mechanics.mass_scaling=16"};
  EXPECT_NEAR(limit_of(laboratory("heating", fast), name).value, 0.48 * 4, 1e-12);
  EXPECT_FALSE(limit_of(laboratory("heating", fast), name).inside());
}

/// alpha dT, of the material that grows most.
TEST(SpecimenOfACase, KnowsItsThermalStrain) {
  const std::string name = "thermal strain of the named temperatures", change = "laboratory.temperature_change=100";
  EXPECT_NEAR(limit_of(laboratory("heating", {change}), name).value, 8e-4, 1e-15);
  const Limit large =
      limit_of(laboratory("quench", {change,
                                     "mechanics.material=[{type='rectangle', from=[0.0, 0.0], to=[0.015, "
                                     "0.015], thermal_expansion=3e-4}]"}),
               name);
  EXPECT_NEAR(large.value, 0.03, 1e-15);
  EXPECT_FALSE(large.inside());
}

/// The fastest tenth of a quench: 2 sqrt(kappa t) is then sqrt(0.1) of that at the end, and a half space has lost
/// length/(sqrt(pi) H) of its heat.
TEST(SpecimenOfACase, KnowsHowFastAQuenchStrainsIt) {
  const std::string name = "speed of thermal strain over the height", change = "laboratory.temperature_change=100";
  const auto limit = [&](const std::string& more) {
    return limit_of(laboratory("quench", {change, more, "laboratory.diffusion_length=0.03"}), name);
  };
  const double of_half_space = 0.024 / 0.1 * std::sqrt(0.1 / std::acos(-1.0));
  EXPECT_NEAR(limit("laboratory.samples=200").value, of_half_space, 1e-4 * of_half_space);
  EXPECT_EQ(limit("laboratory.samples=20").value, limit("laboratory.samples=200").value);
  EXPECT_TRUE(limit("laboratory.samples=200").inside());
  EXPECT_FALSE(limit("laboratory.duration=1e-4").inside());
  EXPECT_LT(limit("laboratory.biot=1").value, 0.5 * of_half_space);
}

/// Triangles about the middle of what is |x/width|^power + |y/height|^power = 2^-power, an ellipse or a lozenge or
/// nearly a rectangle, or of what two flats leave of it.
std::string mesh_of(double width, double height, double power, double flats = 0) {
  std::vector<std::array<double, 2>> vertices{{0, 0}};
  std::vector<std::array<int, 3>> triangles;
  const int parts = 16;
  for (int k = 0; k < parts; ++k) {
    const double a = 2 * std::acos(-1.0) * (k + 0.5) / parts, x = std::cos(a), y = std::sin(a);
    const double radius = 0.5 / std::pow(std::pow(std::abs(x), power) + std::pow(std::abs(y), power), 1 / power);
    const double cut = flats > 0 ? 0.5 * std::sqrt(1 - flats * flats) : 1;
    vertices.push_back({width * radius * x, height * std::clamp(radius * y, -cut, cut)});
    triangles.push_back({0, 1 + k, 1 + (k + 1) % parts});
  }
  return test::mesh_text(vertices, triangles);
}

TEST(SpecimenOfACase, IsADiscWhereItIsSplit) {
  const test::TemporaryFolder folder;
  const auto scene = [&](const std::string& mesh) {
    test::write_text(folder / "rock.msh", mesh);
    return parse_scene(
        "[laboratory]\ntest = \"brazilian\"\n[rock]\nmesh = \"" + (folder / "rock.msh") + "\"\n[mechanics]\n",
        "a.toml");
  };
  EXPECT_NO_THROW(build_specimen(scene(mesh_of(0.05, 0.05, 2))));
  EXPECT_NO_THROW(build_specimen(scene(mesh_of(0.05, 0.05, 2, 0.6))));
  for (const std::string& mesh :
       {mesh_of(0.03, 0.06, 2), mesh_of(0.06, 0.03, 2), mesh_of(0.05, 0.05, 30), mesh_of(0.05, 0.05, 1)}) {
    try {
      build_specimen(scene(mesh));
      ADD_FAILURE() << "accepted";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("is no disc, which test = \"brazilian\" splits"), std::string::npos)
          << error.what();
    }
  }
  const std::string name = "width of the flats over the diameter";
  const auto generated = [](const char* flats) {
    return parse_scene(std::string("[laboratory]\ntest = \"brazilian\"\ndiameter = 0.05\nflat_width = ") + flats +
                           "\n[rock]\nelement_size = 3e-3\n[mechanics]\n",
                       "a.toml");
  };
  EXPECT_TRUE(limit_of(generated("0.3"), name).inside());
  EXPECT_NEAR(limit_of(generated("0.4"), name).value, 0.4, 1e-9);
  EXPECT_FALSE(limit_of(generated("0.4"), name).inside());
}

/// Edges beside the bounding rectangle are not pressed: here half of each flank stands out.
TEST(SpecimenOfACase, KnowsWhichShareOfItsFlanksIsPressed) {
  const test::TemporaryFolder folder;
  const auto share = [&](double out) {
    const std::vector<std::array<double, 2>> vertices{{0, 0},       {0.01, 0}, {0.01 + out, 0.01}, {0.01 + out, 0.03},
                                                      {0.01, 0.04}, {0, 0.04}, {-out, 0.03},       {-out, 0.01},
                                                      {0.005, 0.02}};
    std::vector<std::array<int, 3>> triangles;
    for (int k = 0; k < 8; ++k) triangles.push_back({8, k, (k + 1) % 8});
    test::write_text(folder / "rock.msh", test::mesh_text(vertices, triangles));
    return limit_of(parse_scene("[laboratory]\ntest = \"compression\"\nconfinement = \"1 MPa\"\n[rock]\nmesh = \"" +
                                    (folder / "rock.msh") + "\"\n[mechanics]\n",
                                "a.toml"),
                    "share of a flank that the confinement presses");
  };
  EXPECT_NEAR(share(0).value, 1, 1e-12);
  EXPECT_TRUE(share(0).inside());
  EXPECT_NEAR(share(1e-5).value, 0.5, 1e-12);
  EXPECT_FALSE(share(1e-5).inside());
}

TEST(SpecimenOfACase, OfADiscHasNoOutlinesOfMaterials) {
  const auto warnings = [](const std::string& test) {
    return parse_scene("[laboratory]\n" + test +
                           "[rock]\nelement_size = 3e-3\n[[mechanics.material]]\ntype = \"rectangle\"\n"
                           "from = [0.02, 0.02]\nto = [0.03, 0.03]\n",
                       "a.toml")
        .warnings;
  };
  const auto told = ::testing::Contains(::testing::HasSubstr("a generated disc do not follow"));
  EXPECT_THAT(warnings("test = \"brazilian\"\ndiameter = 0.05\n"), told);
  EXPECT_THAT(warnings("test = \"compression\"\nsize = [0.05, 0.1]\n"), ::testing::Not(told));
}

/// The specimen of a case as it is tested.
void require(const Scene& scene) {
  const Assembly specimen = build_specimen(scene);
  const Mechanics rock(specimen, scene.mechanics->parameters, {});
  age_chemically(scene, rock);
  require_testable(scene, specimen, rock);
}

/// Why a case is refused before its test.
std::string refusal(const Scene& scene) {
  try {
    require(scene);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(SpecimenOfACase, IsRefusedATestWithoutEnd) {
  EXPECT_EQ(refusal(laboratory("compression", {"laboratory.platen_speed=1e-9"})), "accepted");
  EXPECT_EQ(refusal(laboratory("compression", {"laboratory.platen_speed=1e-300"})),
            "a.toml: laboratory.platen_speed: the test needs more than 9e15 steps; make it faster or shorter");
  const std::string change = "laboratory.temperature_change=50";
  for (const char* test : {"heating", "quench"}) {
    EXPECT_EQ(refusal(laboratory(test, {change, "laboratory.duration=1e5"})), "accepted");
    EXPECT_EQ(refusal(laboratory(test, {change, "laboratory.duration=1e9", "mechanics.critical_fraction=1e-4"})),
              "a.toml: laboratory.duration: the test needs more than 9e15 steps; make it faster or shorter");
  }
}

TEST(SpecimenOfACase, HasNoMoreTemperaturesThanSteps) {
  const std::vector<std::string> change{"laboratory.temperature_change=50", "laboratory.duration=1e-5",
                                        "laboratory.samples=100000"};
  EXPECT_NE(refusal(laboratory("quench", change)).find("a.toml: laboratory.samples = 100000 is more than the steps of"),
            std::string::npos);
  // chemical damage makes bonds softer and steps longer: there are fewer
  const Scene sound = laboratory("quench", change);
  const Mechanics rock(build_specimen(sound), sound.mechanics->parameters, {});
  const int steps = static_cast<int>(1e-4 / (sound.mechanics->critical_fraction * rock.critical_step()));
  const std::vector<std::string> as_many{change[0], "laboratory.duration=1e-4",
                                         fmt::format("laboratory.samples={}", steps)};
  EXPECT_EQ(refusal(laboratory("quench", as_many)), "accepted");
  EXPECT_NE(refusal(laboratory("quench", {as_many[0], as_many[1], as_many[2], "laboratory.chemical_damage=0.9"}))
                .find("is more than the steps of"),
            std::string::npos);
  const Scene fine = laboratory("quench", {change[0], "laboratory.duration=1e-4", "laboratory.samples=300"});
  const Assembly slab = build_specimen(fine);
  const QuenchResult result = quench(Exec(), slab, fine.mechanics->parameters, quench_test(fine));
  const double time = static_cast<double>(result.steps) * result.time_step;
  EXPECT_NEAR(time, 1e-4, result.time_step) << result.steps << " steps of 300 temperatures";
}

/// At five heights 88 % of the heat has left in the first tenth, at six 91 %: 1 - 8/pi^2 exp(-pi^2/40 (length/H)^2).
TEST(SpecimenOfACase, IsNotCooledInOneJump) {
  const std::string change = "laboratory.temperature_change=50";
  const auto told = [&](const char* length, const std::string& more = "laboratory.samples=200") {
    return refusal(laboratory("quench", {change, std::string("laboratory.diffusion_length=") + length, more}));
  };
  EXPECT_EQ(told("0.16"), "accepted");
  EXPECT_NE(
      told("0.19").find("a.toml: laboratory.diffusion_length = 0.19 m cools the slab, 0.03 m high, almost through"),
      std::string::npos);
  EXPECT_NE(told("10"), "accepted");
  EXPECT_EQ(told("0.19", "laboratory.biot=0.5"), "accepted");
}

/// Of triangles as high as the slab no row of edges lies two of them deep.
TEST(SpecimenOfACase, IsHighEnoughToCountCracks) {
  const test::TemporaryFolder folder;
  const auto scene = [&](const std::string& mesh) {
    test::write_text(folder / "slab.msh", mesh);
    return parse_scene(
        "[laboratory]\ntest = \"quench\"\ntemperature_change = 200\nduration = \"10 us\"\nsamples = 10\n"
        "[rock]\nmesh = \"" +
            (folder / "slab.msh") + "\"\n[mechanics]\n",
        "a.toml");
  };
  const std::vector<std::array<double, 2>> square{{0, 0}, {0.01, 0}, {0.01, 0.01}, {0, 0.01}};
  const std::vector<std::array<int, 3>> halves{{0, 1, 2}, {0, 2, 3}};
  const Scene low = scene(test::mesh_text(square, halves));
  EXPECT_EQ(refusal(low),
            "a.toml: the slab is 0.930605 edges of its triangles high; a quench counts cracks from two edges below the "
            "face on: mesh it finer");
  EXPECT_THROW(quench(Exec(), build_specimen(low), low.mechanics->parameters, quench_test(low)), InputError);
  const Scene high = scene(mesh_of(0.05, 0.05, 30));
  EXPECT_EQ(refusal(high), "accepted");
  EXPECT_FALSE(quench(Exec(), build_specimen(high), high.mechanics->parameters, quench_test(high)).depth.empty());
}

}  // namespace
}  // namespace vug
