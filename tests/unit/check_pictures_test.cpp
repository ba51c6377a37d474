// What a check tells of pictures: how they are read, and that they hold rock, pores and minerals.
#include "base/require.hpp"
#include "coupling/check.hpp"
#include "support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace vug {
namespace {

using testing::HasSubstr;

/// As of a grey_range that is not that of the picture.
TEST(Check, WarnsOfAPictureWithoutRock) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "a.raw", std::string(12, '\x20') + std::string(4, '\x40'));
  const std::string text =
      "[lattice]\nsize = [4, 4]\nspacing = 1\ntime_step = 1\n[time]\nsteps = 10\n[geometry]\ntype = \"image\"\n"
      "file = \"" +
      (folder / "a.raw") + "\"\nraw_size = [4, 4]\ngrey_range = [0, 64]\n[flow]\nviscosity = 0.1\n";
  const auto warnings = [&](const std::vector<std::string>& choices) {
    return check_case(parse_scene(text, "a.toml", choices)).warnings;
  };
  const auto warning = [](const std::string& why) {
    return testing::Contains(HasSubstr("a.raw: has values 32 ... 64, and " + why + " no rock of any of them"));
  };
  EXPECT_THAT(warnings({}), testing::Not(warning("")));
  EXPECT_THAT(warnings({"geometry.grey_range=[0, 1]"}), warning("geometry.grey_range, threshold and invert make"));
  EXPECT_THAT(
      warnings({"geometry.grey_range=[0, 1]"}),
      testing::Contains(HasSubstr("all is pore (rock below 0.5); geometry.grey_range = [32, 64] tells them apart")));
}

/// Heat alone has no list of fluid nodes.
TEST(Check, TellsThePoresOfACaseWithHeatAlone) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "a.raw", std::string(12, '\1') + std::string(4, '\0'));
  const std::string text =
      "[lattice]\nsize = [4, 4]\nspacing = 1\ntime_step = 1\n[time]\nsteps = 10\n[geometry]\ntype = \"image\"\n"
      "file = \"" +
      (folder / "a.raw") + "\"\nraw_size = [4, 4]\n[heat]\nfluid_diffusivity = 0.1\nsolid_diffusivity = 0.1\n";
  const CheckReport apart = check_case(parse_scene(text, "a.toml", {"geometry.grey_range=[0, 1]"}));
  EXPECT_EQ(apart.fluid_nodes, 12);
  EXPECT_EQ(apart.porosity, 0.75);
  const auto all_rock = testing::Contains(HasSubstr("rock of them all: there is no fluid (rock below 127.5)"));
  EXPECT_THAT(apart.warnings, testing::Not(all_rock));
  EXPECT_THAT(check_case(parse_scene(text, "a.toml")).warnings, all_rock);
}

/// A page of a stack may lack a mineral; shapes that hold no rock are a mistake.
TEST(Check, WarnsOfAMineralWhoseLabelsAPictureDoesNotHave) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "a.raw", std::string("\1\1\1\2\2\2\0\0\0\0\0\0", 12));
  const std::string text =
      "[lattice]\nsize = [4, 3]\nspacing = 1\ntime_step = 1\n[time]\nsteps = 10\n[geometry]\ntype = \"image\"\n"
      "file = \"" +
      (folder / "a.raw") +
      "\"\nraw_size = [4, 3]\nsolid_labels = [1, 2, 3]\n[[solute.species]]\nname = \"A\"\ndiffusivity = 0.1\n"
      "[reaction]\nreactant = \"A\"\nrate_constant = 1e-3\nmolar_volume = 1e-3\n"
      "[[mineral]]\nname = \"calcite\"\nlabels = [2]\nrate_constant = 1e-2\n"
      "[[mineral]]\nname = \"quartz\"\nlabels = [{}]\nrate_constant = 1e-4\n";
  const auto warnings = [&](const char* label) {
    return check_case(parse_scene(fmt::format(fmt::runtime(text), label), "a.toml")).warnings;
  };
  const auto absent = testing::Contains(HasSubstr("mineral.1: no node of rock is \"quartz\""));
  EXPECT_THAT(warnings("3"), absent);
  EXPECT_THAT(warnings("1"), testing::Not(absent));
}

/// A mask of 0 and 1 taken for grey values up to 255.
TEST(Check, TellsHowAPictureThatIsAllRockIsRead) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "a.raw", std::string(12, '\1') + std::string(4, '\0'));
  const std::string text =
      "[lattice]\nsize = [4, 4]\nspacing = 1\ntime_step = 1\n[time]\nsteps = 10\n[geometry]\ntype = \"image\"\n"
      "file = \"" +
      (folder / "a.raw") + "\"\nraw_size = [4, 4]\n[flow]\nviscosity = 0.1\n";
  const auto told = [&](const std::vector<std::string>& choices) {
    try {
      return to_text(check_case(parse_scene(text, "a.toml", choices)));
    } catch (const InputError& error) {
      return std::string(error.what());
    }
  };
  EXPECT_THAT(told({}),
              HasSubstr("rock of them all: there is no fluid (rock below 127.5); geometry.grey_range = [0, 1] "
                        "tells them apart"));
  EXPECT_THAT(told({"geometry.grey_range=[0, 1]"}), HasSubstr("12 fluid nodes"));
  EXPECT_THAT(told({"geometry.grey_range=[0, 1]"}), HasSubstr("values 0 ... 1, rock below 0.5, pixel size"));
  EXPECT_THAT(told({"geometry.grey_range=[0, 1]", "geometry.invert=true"}),
              HasSubstr("values 0 ... 1, rock from 0.5, "));
  EXPECT_THAT(told({"geometry.grey_range=[2, 0]", "geometry.threshold=0.75"}), HasSubstr("1, rock from 0.5, "));
  EXPECT_THAT(told({"geometry.grey_range=[2, 0]", "geometry.threshold=0.75", "geometry.invert=true"}),
              HasSubstr("values 0 ... 1, rock below 0.5, "));
  EXPECT_THAT(told({"geometry.solid_labels=[0]", "geometry.fluid_labels=[1]"}),
              HasSubstr("values 0 ... 1, pixel size"));
}

}  // namespace
}  // namespace vug
