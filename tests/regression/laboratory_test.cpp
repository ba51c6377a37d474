// `vug lab` as its users meet it.
#include "support/run_vug.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>

namespace vug {
namespace {

using test::Outcome;
using test::run_command;
using test::run_vug;
using test::small_rock;
using test::TemporaryFolder;
using testing::HasSubstr;

TEST(Laboratory, WritesCurvePicturesAndRecordAndPrintsWhatItFound) {
  const TemporaryFolder folder;
  const std::string lab = "lab " VUG_SOURCE_DIR
                          "/cases/laboratory/compression.toml --quiet"
                          " --set laboratory.size=[0.015,0.03] --set laboratory.platen_speed=2 -o " +
                          (folder / "out");
  const Outcome outcome = run_vug(lab + " --seeds 2");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  for (const char* expected : {"Young's modulus", "strength", "bonds failed", "GPa"})
    EXPECT_THAT(outcome.output, HasSubstr(expected));
  EXPECT_THAT(test::contents((folder / "out") + "/stress_strain.csv"),
              testing::StartsWith("strain_1,stress_Pa,seed_1"));
  EXPECT_TRUE(std::filesystem::exists((folder / "out") + "/particles.xdmf"));
  const Outcome record = run_command(VUG_PYTHON " -c \"import json; r = json.load(open('" + (folder / "out") +
                                     "/run.json')); print(20e9 < r['results']['modulus_Pa'] < 35e9, r['status'])\"");
  EXPECT_EQ(record.output, "True done\n");
}

TEST(Laboratory, FindsTheCohesionOfAStrength) {
  const TemporaryFolder folder;
  const std::string lab = "lab " VUG_SOURCE_DIR
                          "/cases/laboratory/compression.toml --quiet --set rock.element_size=3e-3"
                          " --set laboratory.size=[0.015,0.03] --set laboratory.platen_speed=2 -o " +
                          (folder / "out");
  const Outcome outcome = run_vug(lab + " --fit-cohesion 70 --seeds 2");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("mechanics.bond.cohesion = "));
  // the cohesion found gives the strength asked for, to the one per cent of the search
  const Outcome check = run_command(
      VUG_PYTHON " -c \"import json; r = json.load(open('" + (folder / "out") +
      "/run.json'))['results']; print(abs(r['strength_Pa'] / 70e6 - 1) < 0.01, 30e6 < r['cohesion_Pa'] < 70e6)\"");
  EXPECT_EQ(check.output, "True True\n");
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
  EXPECT_EQ(std::count(diverged.output.begin(), diverged.output.end(), '\n'), 1) << diverged.output;
  EXPECT_THAT(test::contents((folder / "out") + "/run.json"), HasSubstr("diverged"));
}

}  // namespace
}  // namespace vug
