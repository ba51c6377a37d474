// `vug lab` as its users meet it.
#include "support/meshed_rock.hpp"
#include "support/run_vug.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace vug {
namespace {

using test::Outcome;
using test::run_command;
using test::run_vug;
using test::small_rock;
using test::TemporaryFolder;
using testing::HasSubstr;
using testing::Not;

/// A command that presses a small specimen fast.
std::string press(const TemporaryFolder& folder, const std::string& more) {
  return "lab " VUG_SOURCE_DIR
         "/cases/laboratory/compression.toml --quiet --set laboratory.size=[0.015,0.03]"
         " --set laboratory.platen_speed=2 -o " +
         (folder / "out") + more;
}

/// What Python makes of the run's record `record` and the results `r` in it.
std::string from_record(const TemporaryFolder& folder, const std::string& expression) {
  return run_command(VUG_PYTHON " -c \"import json; record = json.load(open('" + (folder / "out") +
                     "/run.json')); r = record['results']; print(" + expression + ", end='')\"")
      .output;
}

TEST(Laboratory, WritesCurvePicturesAndRecordAndPrintsWhatItFound) {
  const TemporaryFolder folder;
  const Outcome outcome = run_vug(press(folder, " --seeds 2"));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  for (const char* expected : {"Young's modulus", "strength", "bonds failed", "GPa"})
    EXPECT_THAT(outcome.output, HasSubstr(expected));
  EXPECT_THAT(test::contents((folder / "out") + "/stress_strain.csv"),
              testing::StartsWith("strain_1,stress_Pa,seed_1"));
  EXPECT_TRUE(std::filesystem::exists((folder / "out") + "/particles.xdmf"));
  EXPECT_EQ(
      from_record(folder, "20e9 < r['modulus_Pa'] < 35e9, record['status'], r['specimens_1'], r['steps_1'] > 1000"),
      "True done 2 True");
}

TEST(Laboratory, FindsTheCohesionOfAStrength) {
  const TemporaryFolder folder;
  const Outcome outcome = run_vug(press(folder, " --set rock.element_size=3e-3 --fit-cohesion 70 --seeds 2"));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("mechanics.bond.cohesion = "));
  // the cohesion found gives the strength asked for, to the one per cent of the search
  EXPECT_EQ(from_record(folder,
                        "abs(r['strength_Pa'] / 70e6 - 1) < 0.01, 30e6 < r['cohesion_Pa'] < 70e6,"
                        " r['wanted_strength_Pa'], r['specimens_1'], r['rounds_1'] > 1"),
            "True True 70000000 2 True");
}

/// Lower half of another density: its bonds are as strong as the rock's, and stay so while the cohesion is searched
/// for.
TEST(Laboratory, FindsACohesionThatMaterialsShare) {
  const TemporaryFolder folder;
  const std::string lab = press(folder,
                                " --overwrite --set rock.element_size=3e-3 --seeds 2"
                                " --set 'mechanics.material=[{type=\"rectangle\", from=[0.0,0.0], to=[0.015,0.015], "
                                "density=2700}");
  const Outcome fitted = run_vug(lab + "]' --fit-cohesion 70");
  EXPECT_EQ(fitted.exit_code, 0) << fitted.output;
  const std::string cohesion = from_record(folder, "'%.10g' % r['cohesion_Pa']"),
                    strength = from_record(folder, "r['strength_Pa']");
  EXPECT_EQ(run_vug(lab + "]' --set mechanics.bond.cohesion=" + cohesion).exit_code, 0);
  EXPECT_EQ(from_record(folder, "abs(r['strength_Pa'] / " + strength + " - 1) < 1e-6"), "True");
  // another cohesion of its own is not searched for
  const std::string own = ", {type=\"rectangle\", from=[0.0,0.0], to=[0.015,0.03], bond={cohesion=57e6}}]'";
  const Outcome stuck = run_vug(lab + own + " --fit-cohesion 40");
  EXPECT_EQ(stuck.exit_code, 2) << stuck.output;
  EXPECT_THAT(stuck.output, HasSubstr("where a material has a cohesion of its own"));
}

TEST(Laboratory, SaysInTheRecordWhyNoCohesionWasFound) {
  const TemporaryFolder folder;
  const Outcome outcome = run_vug(press(folder,
                                        " --set rock.element_size=3e-3 --seeds 1"
                                        " --set laboratory.largest_strain=3e-4 --fit-cohesion 700"));
  EXPECT_EQ(outcome.exit_code, 2) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("a specimen did not pass a peak of stress, so that it has no strength to fit"));
  EXPECT_THAT(test::contents(folder / "out/run.json"),
              testing::AllOf(HasSubstr("\"status\": \"failed\""), HasSubstr("\"exit_code\": 2")));
  EXPECT_THAT(run_vug("watch " + (folder / "out")).output, HasSubstr("failed, step 0"));
}

TEST(Laboratory, HasNoScheduleAndNoExplanation) {
  for (const char* option : {" --schedule", " --explain"}) {
    const Outcome outcome = run_vug(std::string("check " VUG_SOURCE_DIR "/cases/laboratory/compression.toml") + option);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.output, "vug: --schedule and --explain are of a lattice, and a laboratory test has none\n");
  }
}

/// What the platens have done by the curve itself: stress over the strain of what lies between them, its height being
/// that of the specimen less the centroids' distance from its ends.
constexpr const char* compare_energies = R"(
import csv, sys
rows = [{k: float(v) for k, v in row.items()} for row in csv.DictReader(open(sys.argv[1]))]
width, height = 0.012, 0.024
strain, stress = [0] + [r['strain_1'] for r in rows], [0] + [r['stress_Pa'] for r in rows]
area = sum((b - a) * (s + t) / 2 for a, b, s, t in zip(strain, strain[1:], stress, stress[1:]))
end, kinds = rows[-1], ('elastic_energy', 'kinetic_energy', 'fracture', 'friction', 'damping')
held = end['work_J_per_m'] / (width * area)
stored = max(r['elastic_energy_J_per_m'] / r['work_J_per_m'] for r in rows[5:])
print(0.92 * height < held < height, abs(end['missing_J_per_m']) < 1e-3 * end['work_J_per_m'],
      0.9 < stored < 1, end['fracture_J_per_m'] > 0.1 * end['work_J_per_m'], all(end[k + '_J_per_m'] >= 0 for k in kinds))
)";

TEST(Laboratory, KeepsAccountOfThePlatensWork) {
  const TemporaryFolder folder;
  const Outcome outcome = run_vug("lab " VUG_SOURCE_DIR
                                  "/cases/laboratory/tension.toml --quiet --set laboratory.energies=true"
                                  " --set laboratory.size=[0.012,0.024] -o " +
                                  (folder / "out"));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr(" missing\n"));
  std::ofstream(folder / "compare.py") << compare_energies;
  EXPECT_EQ(
      run_command(VUG_PYTHON " " + (folder / "compare.py") + " " + (folder / "out") + "/stress_strain.csv").output,
      "True True True True True\n");
}

const std::string heated_block =
    "[laboratory]\ntest = \"heating\"\nsize = [0.015, 0.03]\ntemperature_change = 3\n"
    "[rock]\nelement_size = 3e-3\n";

TEST(Laboratory, ClaimsNoStrengthOfRockThatDidNotBreakNorAModulusWithoutPoints) {
  const TemporaryFolder folder;
  const std::string out = folder / "out", cases = VUG_SOURCE_DIR "/cases/laboratory/";
  std::ofstream(folder / "heating.toml") << heated_block;
  const std::string little = " --set laboratory.largest_strain=1e-5 --set laboratory.platen_speed=2";
  for (const std::string& test :
       {cases + "tension.toml" + little, cases + "brazilian.toml" + little, folder / "heating.toml"}) {
    const Outcome outcome = run_vug("lab " + test + " --quiet --overwrite -o " + out);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr("\nlargest stress  "));
    EXPECT_THAT(outcome.output, HasSubstr("the specimen did not pass a peak: raise laboratory."));
    EXPECT_THAT(outcome.output, Not(HasSubstr("\nstrength")));
    EXPECT_THAT(outcome.output, Not(HasSubstr("nan")));
    const std::string record = test::contents(out + "/run.json");
    EXPECT_THAT(record, HasSubstr("\"largest_stress_Pa\": "));
    for (const char* unknown : {"strength_Pa", "modulus_Pa"}) EXPECT_THAT(record, Not(HasSubstr(unknown)));
    const bool curved = test.find("tension") != std::string::npos;
    EXPECT_EQ(outcome.output.find("not told: too few points of the curve") != std::string::npos, curved);
  }
}

/// Bonds fail at 60 % of what the rock bears: a test that ends while the stress still rises knows no strength.
TEST(Laboratory, ClaimsNoStrengthOfATestThatWasCutOff) {
  const TemporaryFolder folder;
  const std::string out = folder / "out";
  const std::string lab = "lab " VUG_SOURCE_DIR
                          "/cases/laboratory/compression.toml --quiet --overwrite --set rock.element_size=3e-3"
                          " --set laboratory.size=[0.03,0.06] --set laboratory.platen_speed=2"
                          " --set mechanics.bond.normal_strength=6e6 -o " +
                          out;
  const Outcome whole = run_vug(lab);
  EXPECT_THAT(whole.output, HasSubstr("\nstrength  "));
  const Outcome cut = run_vug(lab + " --set laboratory.largest_strain=3e-3");
  EXPECT_EQ(cut.exit_code, 0) << cut.output;
  EXPECT_THAT(cut.output, HasSubstr("the specimen did not pass a peak: raise laboratory.largest_strain"));
  EXPECT_THAT(cut.output, Not(HasSubstr("\nstrength")));
  const std::string record = test::contents(out + "/run.json");
  EXPECT_THAT(record, HasSubstr("\"largest_stress_Pa\": "));
  EXPECT_THAT(record, testing::ContainsRegex("\"failed_in_(tension|shear)_1\": [1-9]")) << "no bond failed before";
  const Outcome fitted = run_vug(lab + " --set laboratory.largest_strain=3e-3 --seeds 1 --fit-cohesion 50");
  EXPECT_EQ(fitted.exit_code, 2) << fitted.output;
  EXPECT_THAT(fitted.output, HasSubstr("no strength to fit; raise laboratory.largest_strain"));
}

/// Two triangles: none at 20 or 80 % of the height.
TEST(Laboratory, SaysWhereItsMeshHasNoTriangleAtAGauge) {
  const TemporaryFolder folder;
  test::write_text(folder / "rock.msh", test::mesh_text({{0, 0}, {1, 0}, {1, 2}, {0, 2}}, {{0, 1, 2}, {0, 2, 3}}));
  test::write_text(folder / "coarse.toml",
                   "[laboratory]\ntest = \"compression\"\nlargest_strain = 1e-3\n[rock]\nmesh = \"" +
                       (folder / "rock.msh") + "\"\n[mechanics]\n");
  const Outcome outcome = run_vug("lab " + (folder / "coarse.toml") + " --quiet -o " + (folder / "out"));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("not told: no triangle at a gauge"));
  EXPECT_THAT(outcome.output, Not(HasSubstr("lattice.spacing")));
  // an edge that no platen can hold is seen before the test
  test::write_text(folder / "rock.msh", test::mesh_text({{0, 0}, {1, 0}, {1, 2}, {0, 1}}, {{0, 1, 2}, {0, 2, 3}}));
  const Outcome checked = run_vug("check " + (folder / "coarse.toml"));
  EXPECT_EQ(checked.exit_code, 2) << checked.output;
  EXPECT_THAT(checked.output, HasSubstr("the rock has no edge on this side to hold"));
}

TEST(Laboratory, TellsWhatBreaksUnderItsConfinement) {
  const TemporaryFolder folder;
  const std::string lab = "lab " VUG_SOURCE_DIR
                          "/cases/laboratory/compression.toml --quiet --overwrite --set rock.element_size=3e-3"
                          " --set laboratory.size=[0.015,0.03] --set laboratory.largest_strain=1e-4 -o " +
                          (folder / "out") + " --set laboratory.confinement=";
  const std::string told = "failed while the confinement was put on, before the test";
  EXPECT_THAT(run_vug(lab + "10e6").output, Not(HasSubstr(told)));
  EXPECT_THAT(run_vug(lab + "400e6").output, HasSubstr(told));
  EXPECT_THAT(test::contents(folder / "out/run.json"), HasSubstr(told));
}

TEST(Laboratory, CountsNoNotchAmongWhatHasBroken) {
  const TemporaryFolder folder;
  const std::string out = folder / "out", record = out + "/run.json";
  const auto lab = [&](const std::string& test, const std::string& notch) {
    std::ofstream(folder / "notched.toml")
        << "[laboratory]\n" + test + "[rock]\nelement_size = 2e-3\n[[rock.notches]]\n" + notch + "[mechanics]\n";
    return run_vug("lab " + (folder / "notched.toml") + " --quiet --overwrite -o " + out);
  };
  const std::string upright = "from = [0.01, 0.008]\nto = [0.01, 0.02]\n";
  const Outcome pulled = lab("test = \"tension\"\nsize = [0.02, 0.04]\nlargest_strain = 1e-4\n", upright);
  EXPECT_THAT(pulled.output, HasSubstr("0 and 0 at the end; 0 % of them along the load"));
  EXPECT_THAT(test::contents(record), HasSubstr("\"failed_along_load_1\": 0}"));
  const Outcome cooled =
      lab("test = \"quench\"\nsize = [0.02, 0.02]\ntemperature_change = 1\ndiffusion_length = 0.02\nduration = 2e-4\n",
          upright);
  EXPECT_THAT(cooled.output, HasSubstr("no crack is deeper than two elements"));
  EXPECT_THAT(test::contents(record), Not(HasSubstr("spacing_m")));
  // whole steps of 2e-4 s
  EXPECT_EQ(from_record(folder, "0 <= 2e-4 - r['steps_1'] * r['time_step_s'] < r['time_step_s']"), "True");
}

TEST(Laboratory, RefusesSpecimensThatAQuenchDoesNotMake) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run_vug("lab " VUG_SOURCE_DIR "/cases/laboratory/quench.toml --seeds 2 -o " + (folder / "out"));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.output, HasSubstr("a quench is of one specimen; give others by mechanics.bond.seed"));
}

TEST(Laboratory, WantsPointsAndStepsForItsCurve) {
  const TemporaryFolder folder;
  const std::string tension = VUG_SOURCE_DIR "/cases/laboratory/tension.toml ", out = "-o " + (folder / "out");
  const Outcome coarse = run_vug("lab " + tension + "--set laboratory.sample_strain=0.05 " + out);
  EXPECT_EQ(coarse.exit_code, 2);
  EXPECT_THAT(coarse.output, HasSubstr("laboratory.sample_strain = 0.05 is more than laboratory.largest_strain"));
  std::ofstream(folder / "heating.toml") << heated_block;
  const Outcome cold = run_vug("lab " + (folder / "heating.toml") + " --set laboratory.temperature_change=0.1 " + out);
  EXPECT_EQ(cold.exit_code, 2);
  EXPECT_THAT(cold.output, HasSubstr("is more than the heat strains the specimen at the end"));
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
  const std::string fast = tension + "--set laboratory.platen_speed=500 --set laboratory.largest_strain=1e-4 ";
  const std::string expected = "warning: laboratory: steps of the test = ";
  EXPECT_THAT(run_vug("check " + fast).output, HasSubstr(expected));
  const Outcome warned = run_vug("lab " + fast + out);
  EXPECT_THAT(warned.output, HasSubstr(expected));
  EXPECT_THAT(warned.output, HasSubstr("is outside >= 50; lower laboratory.platen_speed"));
}

TEST(Laboratory, IsToldFromARunAndDivergesWithThree) {
  const TemporaryFolder folder;
  const std::string compression = VUG_SOURCE_DIR "/cases/laboratory/compression.toml";
  EXPECT_EQ(run_vug("run " + compression + " -o " + (folder / "out")).exit_code, 2);
  EXPECT_EQ(run_vug("check " + compression).exit_code, 0);
  EXPECT_EQ(run_vug("lab " + small_rock + " -o " + (folder / "out")).exit_code, 2);
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
  const Outcome diverged =
      run_vug("lab " + compression + " --quiet --set laboratory.platen_speed=1e5 -o " + (folder / "out"));
  EXPECT_EQ(diverged.exit_code, 3) << diverged.output;
  EXPECT_THAT(diverged.output,
              testing::MatchesRegex("warning: platens at [^\n]*\nwarning: laboratory: steps of the test [^\n]*\n"
                                    "warning: mechanics: mean edge of the bonds [^\n]*\nvug: [^\n]*\n"))
      << "quiet of no warning";
  EXPECT_THAT(test::contents((folder / "out") + "/run.json"), HasSubstr("diverged"));
}

}  // namespace
}  // namespace vug
