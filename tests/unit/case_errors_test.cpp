// What is wrong with a case is said in one line: where, which key, what was found, what is allowed.
#include "base/require.hpp"
#include "io/scene.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <utility>
#include <vector>

namespace vug {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// The message of the InputError that a case causes; a failure when it causes none.
std::string message(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    parse_scene(text, "a.toml", overrides);
  } catch (const InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "accepted:\n" << text;
  return "";
}

std::string quickstart_message(const std::vector<std::string>& overrides) {
  try {
    read_scene(VUG_SOURCE_DIR "/cases/quickstart.toml", overrides);
  } catch (const InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "accepted: " << testing::PrintToString(overrides);
  return "";
}

const std::string lattice = "[lattice]\nsize = [0.01, 0.02]\nspacing = 1e-3\ntime_step = 1e-4\n";
const std::string time = "[time]\nsteps = 10\n";
const std::string flow = "[flow]\nviscosity = 1e-3\n";

TEST(CaseErrors, NameFileLineColumnKeyValueAndRange) {
  EXPECT_EQ(message("[lattice]\nsize = [1, 1]\nspacing = 0.1\n  time_step = -1\n" + time + flow),
            "a.toml:4:15: lattice.time_step = -1 must be > 0 (s)");
}

TEST(CaseErrors, MisspeltKeyGetsTheNearestValidOne) {
  EXPECT_EQ(message(lattice + "spacin = 3\n" + time + flow),
            "a.toml:5:1: unknown key \"lattice.spacin\"; did you mean \"spacing\"?");
  EXPECT_THAT(message(lattice + time + "[flwo]\nviscosity = 1\n"),
              AllOf(StartsWith("a.toml:7:2: unknown table \"flwo\""), HasSubstr("did you mean \"flow\"?")));
  EXPECT_THAT(message(lattice + time + flow + "[boundary.rihgt]\n"), HasSubstr("did you mean \"right\"?"));
}

TEST(CaseErrors, AStudyIsSentToTheCommandThatRunsIt) {
  EXPECT_EQ(message("[study]\ncase = \"a.toml\"\n"), "a.toml:1:2: unknown table \"study\"; `vug sweep` runs a study");
}

TEST(CaseErrors, KeyOfAnotherTableIsSaidSo) {
  EXPECT_THAT(message(lattice + time + flow + "porosity = 0.1\n"), HasSubstr("table \"rock\" has a key of this name"));
}

TEST(CaseErrors, MissingKeySaysWhatItMustBe) {
  EXPECT_EQ(message("[lattice]\nsize = [1, 1]\nspacing = 0.1\n" + time + flow),
            "a.toml:1:1: lattice.time_step is missing; it must be given (number in s, > 0)");
  EXPECT_THAT(message(time + flow), HasSubstr("lattice.size is missing"));
}

TEST(CaseErrors, WordGetsTheListAndTheNearest) {
  EXPECT_THAT(
      message(lattice + time + flow + "collision = \"mtr\"\n"),
      AllOf(StartsWith("a.toml:9:13: flow.collision = \"mtr\" must be one of"), HasSubstr("did you mean \"trt\"?")));
}

TEST(CaseErrors, SizeMustBeWholeCells) {
  EXPECT_EQ(
      message("[lattice]\nsize = [0.0105, 0.02]\nspacing = 1e-3\ntime_step = 1e-4\n" + time + flow),
      "a.toml:2:9: lattice.size.0 = 0.0105 m is 10.5 cells of lattice.spacing = 0.001 m, it must be a whole number "
      "of them: use 0.01 or 0.011");
  EXPECT_THAT(message("[lattice]\nsize = [0.002, 0.02]\nspacing = 1e-3\ntime_step = 1e-4\n" + time + flow),
              HasSubstr("at least 3"));
  EXPECT_THAT(message("[lattice]\nsize = [100, 100]\nspacing = 1e-3\ntime_step = 1e-4\n" + time + flow),
              HasSubstr("2^31 / 9"));
}

/// The largest lattices of several shapes, by one row: slots of nine directions are numbered by an int.
TEST(CaseErrors, SlotsMustHaveNumbers) {
  const auto read = [](int nx, int ny) {
    const LatticeSection made =
        parse_scene(fmt::format("[lattice]\nsize = [{:.17g}, {:.17g}]\nspacing = 1e-3\ntime_step = 1e-3\n", nx * 1e-3,
                                ny * 1e-3) +
                        time + flow,
                    "a.toml")
            .lattice;
    return std::pair(made.nx, made.ny);
  };
  const std::vector<std::pair<int, int>> pitches{{3, 32},      {15, 32},       {16, 48},
                                                 {1000, 1024}, {15455, 15472}, {15456, 15488}};
  for (const auto& [nx, pitch] : pitches) {
    const int most = static_cast<int>(2147483647LL / 9 / pitch) - 2;  // rows, less the two of the halo
    EXPECT_EQ(read(nx, most), std::pair(nx, most));
    EXPECT_THROW(read(nx, most + 1), InputError) << nx;
  }
}

TEST(CaseErrors, TomlSyntaxKeepsLineAndColumn) {
  EXPECT_THAT(message("[lattice]\nsize = [1, \n"), StartsWith("a.toml:"));
  EXPECT_THAT(message(lattice + lattice), AllOf(StartsWith("a.toml:5:"), HasSubstr("not valid TOML")));
}

/// What new users write, and what they are told to write instead; the rest of a line, and other lines, have no part in
/// it.
TEST(CaseErrors, TomlMistakesSayWhatToWriteInstead) {
  const auto told = [](const std::string& line) {
    const std::string found = message("[case]\nname = \"x, yes: 5 um\"  # 1,5 mm\n[flow]\n" + line + "\n[time]\n");
    EXPECT_THAT(found, StartsWith("a.toml:4:")) << line;
    const auto hint = found.rfind("; ");
    return hint == std::string::npos ? std::string() : found.substr(hint + 2);
  };
  const std::string unit = "a number with a unit stands in quotes: ";
  EXPECT_EQ(told("viscosity = 1 mm2/s"), unit + "\"1 mm2/s\"");
  EXPECT_EQ(told("gravity = [0, 9.81 m/s2]"), unit + "\"9.81 m/s2\"");
  EXPECT_EQ(told("a = { pressure = 20MPa, b = \"1\" } # 1"), unit + "\"20MPa\"");
  for (const char* line : {"viscosity = 0,001", "viscosity = 1,5e-6", "end = 1,5 s"})
    EXPECT_EQ(told(line), "the decimal sign is a point: 0.5") << line;
  for (const char* line : {"viscosity = .5", "viscosity = 1.", "viscosity = 1.e-6", "a = [0.5, -.5]"})
    EXPECT_EQ(told(line), "digits stand on both sides of a decimal point: 0.5, 1.0e-6") << line;
  for (const char* line : {"viscosity = 4*10^-6", "viscosity = 10^-6", "viscosity = 1d-6", "viscosity = 4x10-6"})
    EXPECT_EQ(told(line), "powers of ten are written 4e-6") << line;
  EXPECT_EQ(told("porosity = 15 %"), "a fraction is a number from 0 to 1: 0.15 for 15 %");
  EXPECT_EQ(told("viscosity = 1 // water"), "a comment begins with #");
  EXPECT_EQ(told("viscosity = 1;"), "no semicolon ends a line");
  for (const char* line : {"flows = yes", "flows = True", "flows = FALSE # none"})
    EXPECT_EQ(told(line), "write true or false") << line;
  for (const char* line : {"file = rock.png", "file = ./rock.png", "type = pressure", "a = { type = pressure }"})
    EXPECT_EQ(told(line), "text, such as a word or a path, stands in quotes") << line;
  for (const char* line : {"file = \"C:\\Users\\me\\a.png\"", "file = \"..\\s1\\a.png\""})
    EXPECT_EQ(told(line), "\\ has a meaning of its own in double quotes: write a path with / instead") << line;
  EXPECT_EQ(told("file = \"a\\\\b \\\"c\\\" # d\" 5"), "");
  EXPECT_EQ(told("file = \"a.png"), "a quotation mark is missing");
  EXPECT_EQ(told("file = a.png\""), "a quotation mark is missing");
  EXPECT_EQ(told("viscosity: 1e-6"), "a key and its value are joined by =");
  for (const char* line : {"size = (1, 2)", "size = (\"1 mm\", \"2 mm\")"})
    EXPECT_EQ(told(line), "lists stand in square brackets: [1, 2]") << line;
  EXPECT_EQ(told("flow = { type = \"wall\""), "a table in braces ends with } on the same line");
  for (const char* line : {"viscosity =", "a = 1\na = 2", "[flow]", "x = \"1\" \"2\""})
    EXPECT_THAT(message("[flow]\n" + std::string(line) + "\n"), Not(HasSubstr("; "))) << line;
}

TEST(CaseErrors, DecimalCommaOfAQuantityIsNamed) {
  EXPECT_EQ(message(lattice + time + "[flow]\nviscosity = \"1,5 mm2/s\"\n"),
            "a.toml:8:13: flow.viscosity = \"1,5 mm2/s\" must have a decimal point instead of a comma");
}

TEST(CaseErrors, ContradictionsBetweenTables) {
  const auto broken = [](const std::string& override_text, const std::string& expected) {
    EXPECT_THAT(quickstart_message({override_text}), HasSubstr(expected)) << override_text;
  };
  broken("reaction.product=L1", "is the reactant");
  broken("reaction.product=L3", "is not the name of a [[solute.species]]; did you mean \"L1\"?");
  broken("reaction.reactant=acid", "is not the name of a [[solute.species]]; valid are L1, L2");
  broken("boundary.injection.centre=0.069", "reaches beyond the left side");
  broken("boundary.injection.width=0.08", "wider than the left side");
  broken("boundary.left.flow.type=periodic", "needs boundary.right.flow.type = \"periodic\" as well");
  broken("time.steps=10", "stands beside time.end");
  broken("time.end=1e-6", "shorter than one lattice.time_step");
  broken("output.interval=1e-7", "shorter than one lattice.time_step");
  broken("output.interval=1", "longer than the whole run");
  broken("rock.hole.to=[0.2, 0.04]", "outside the lattice");
  broken("rock.notches.0.to=[-0.1, 0.04]", "outside the lattice");
  broken("boundary.right.traction.support=fixed", "holds still");
  broken("boundary.injection.solute.concentration.L4=1", "which is not the name of a [[solute.species]]");
  broken("rock.mesh=none.msh", "rock.mesh replaces it");
  broken("geometry.type=open", "[rock] needs geometry.type");
  broken("reaction.rate_constant=1", "stands beside reaction.rate_constant");
  for (const char* without : {"solute.advective_form=false", "solute.velocity_set=d2q9"})
    EXPECT_THAT(quickstart_message({"solute.face_exchange=true", without}),
                HasSubstr("solute.face_exchange = true belongs to the advective form on d2q5"));
}

TEST(CaseErrors, WallsThatMoveThroughThemselves) {
  const auto wall = [](const std::string& place, const char* velocity) {
    return lattice + time + flow + "[boundary." + place + "flow = { type = \"wall\", velocity = " + velocity + " }\n";
  };
  const std::string stretch = "injection]\nside = \"left\"\ncentre = 0.01\nwidth = 4e-3\n";
  EXPECT_THAT(
      message(wall("left]\n", "[0.001, 0]")),
      HasSubstr("boundary.left.flow.velocity = [0.001, 0] moves a wall through itself; its first component must be 0"));
  EXPECT_THAT(message(wall(stretch, "[0.001, 0]")),
              HasSubstr("boundary.injection.flow.velocity = [0.001, 0] moves a wall through itself; its first"));
  EXPECT_NO_THROW(parse_scene(wall(stretch, "[0, 0.001]"), "a.toml"));
  const std::string below = "injection]\nside = \"bottom\"\ncentre = 0.005\nwidth = 4e-3\n";
  EXPECT_THAT(message(wall(below, "[0, 0.001]")), HasSubstr("its second component must be 0"));
  EXPECT_NO_THROW(parse_scene(wall(below, "[0.001, 0]"), "a.toml"));
}

TEST(CaseErrors, StepsThatLeaveNothingOfTheEquations) {
  EXPECT_EQ(
      message(lattice + time + flow, {"lattice.time_step=1e-300"}),
      "--set lattice.time_step=1e-300: lattice.time_step = 1e-300 s turns flow.viscosity = 0.001 m2/s into 1e-297 "
      "lattice units (value time_step / spacing^2); 1e-12 ... 1e+09 is accepted, and good ones lie between 1e-3 "
      "and 1");
  EXPECT_THAT(message(lattice + time + flow, {"lattice.time_step=1e8"}), HasSubstr("into 1e+11 lattice units"));
  EXPECT_THAT(quickstart_message({"solute.species.1.diffusivity=1e-20"}), HasSubstr("solute.species.1.diffusivity"));
}

TEST(CaseErrors, MoreTrianglesThanAnybodyHasAUseFor) {
  EXPECT_THAT(quickstart_message({"rock.element_size=1e-9"}),
              AllOf(HasSubstr("rock.element_size = 1e-09 m makes 1.62e+16 triangles, at most 2^22 are accepted; use "),
                    HasSubstr(" m or more")));
  try {
    read_scene(VUG_SOURCE_DIR "/cases/laboratory/compression.toml", {"rock.element_size=1e-9"});
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("triangles, at most 2^22 are accepted"));
  }
}

TEST(CaseErrors, TablesThatNeedOthers) {
  EXPECT_THAT(message(lattice + time + flow + "[reaction]\nreactant = \"A\"\nrate_constant = 1\n"),
              HasSubstr("[reaction] needs the table [solute]"));
  EXPECT_THAT(message(lattice + time + flow + "[damage]\n"), HasSubstr("[damage] needs the table [mechanics]"));
  EXPECT_THAT(message(lattice + time + flow + "[mechanics]\n"), HasSubstr("[mechanics] needs the table [rock]"));
  EXPECT_THAT(message(lattice + time + flow + "[geometry]\ntype = \"rock\"\n"), HasSubstr("needs the table [rock]"));
  EXPECT_THAT(message(lattice + time + flow + "[boundary.left.heat]\ntype = \"adiabatic\"\n"),
              HasSubstr("needs the table [heat]"));
  EXPECT_THAT(message(lattice + time + flow + "[boundary.top.traction]\nnormal_stress = 1\n"),
              HasSubstr("needs the table [mechanics]"));
  EXPECT_THAT(message(lattice + time), HasSubstr("models nothing"));
}

TEST(CaseErrors, OverridesAreNamed) {
  EXPECT_EQ(message(lattice + time + flow, {"lattice.spacin=1"}),
            "--set lattice.spacin=1: unknown key \"lattice.spacin\"; did you mean \"spacing\"?");
  EXPECT_EQ(message(lattice + time + flow, {"time.steps=-1"}),
            "--set time.steps=-1: time.steps = -1 must be a whole number 1 ... 1e+15");
  EXPECT_THAT(message(lattice + time + flow, {"nonsense"}), StartsWith("--set nonsense: expected table.key=value"));
  EXPECT_THAT(message(lattice + time + flow, {"=1"}), HasSubstr("expected table.key=value"));
  for (const char* no_table : {"time=3", "time=fast", "time=[1, 2]", "time=[{}, 1]"})
    EXPECT_THAT(message(lattice + time + flow, {no_table}),
                HasSubstr("expected table.key=value, or for a whole table"));
  EXPECT_THAT(message(lattice + time + flow, {"time=[]"}), StartsWith("--set time=[]: "));
  EXPECT_THAT(message(lattice + time + flow, {"haet={ x = 1 }"}), StartsWith("--set haet={ x = 1 }: "));
  EXPECT_THAT(message(lattice + time + flow, {"lattice..size=1"}), HasSubstr("expected table.key=value"));
  EXPECT_THAT(message(lattice + time + flow, {"lattice.size="}), HasSubstr("value is missing"));
  EXPECT_THAT(message(lattice + time + flow, {"lattice.size=[1, 2"}), HasSubstr("not valid TOML"));
  EXPECT_THAT(message(lattice + time + flow, {"lattice.spacing.x=1"}), HasSubstr("inside a plain value"));
  EXPECT_THAT(quickstart_message({"solute.species.7.name=x"}), HasSubstr("element 7 does not exist, there are 2"));
}

TEST(CaseErrors, FilesThatAreNoCase) {
  const auto refused = [](const std::string& path) {
    try {
      read_scene(path);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(refused("/nonexistent/case.toml"), HasSubstr("does not exist"));
  EXPECT_THAT(refused("/"), HasSubstr("is a folder"));
  EXPECT_THAT(message(""), HasSubstr("is empty"));
  EXPECT_THAT(message("\xEF\xBB\xBF"), HasSubstr("is empty"));
  EXPECT_THAT(message(std::string("\x7f"
                                  "ELF\0\0\1",
                                  7)),
              HasSubstr("is not a text file"));
  EXPECT_THAT(message("\xff\xfe[\0"), HasSubstr("UTF-16"));
}

TEST(CaseErrors, ByteOrderMarkOfUtf8IsAccepted) {
  EXPECT_NO_THROW(parse_scene("\xEF\xBB\xBF" + lattice + time + flow, "a.toml"));
}

TEST(CaseErrors, MeshOrImageThatIsNotThereIsAnInputError) {
  EXPECT_THAT(message(lattice + time + flow + "[geometry]\ntype = \"image\"\nfile = \"no.png\"\n"),
              AllOf(HasSubstr("geometry.file = \"no.png\" does not exist")));
  EXPECT_THAT(message(lattice + time + flow + "[geometry]\ntype = \"rock\"\n[rock]\nmesh = \"no.msh\"\n"),
              HasSubstr("rock.mesh = \"no.msh\" does not exist"));
}

}  // namespace
}  // namespace vug
