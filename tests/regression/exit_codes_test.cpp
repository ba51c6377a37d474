// What a user sees when something is wrong: one line, the right exit code, and nothing written.
#include "support/run_vug.hpp"

#include <gmock/gmock.h>

#include <filesystem>

namespace vug {
namespace {

using test::lines_in;
using test::Outcome;
using test::run_command;
using test::run_vug;
using test::small_rock;
using test::TemporaryFolder;
using testing::HasSubstr;

TEST(ExitCodes, EveryBrokenCaseGivesTwoOneLineAndNoFiles) {
  const TemporaryFolder folder;
  int broken = 0;
  for (const auto& entry : std::filesystem::directory_iterator(VUG_SOURCE_DIR "/tests/cases/broken")) {
    if (entry.path().extension() != ".toml") continue;
    const Outcome outcome = run_vug("run " + entry.path().string() + " -o " + (folder / "out"));
    EXPECT_EQ(outcome.exit_code, 2) << entry.path() << outcome.output;
    EXPECT_EQ(lines_in(outcome.output), 1) << entry.path() << outcome.output;
    ++broken;
  }
  EXPECT_GE(broken, 200);
  EXPECT_EQ(run_vug("run " + (folder / "nonexistent.toml") + " -o " + (folder / "out")).exit_code, 2);
  EXPECT_EQ(run_vug("run " + folder.path() + " -o " + (folder / "out")).exit_code, 2);
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

TEST(ExitCodes, MeshBeyondTheLatticeGivesTwo) {
  const TemporaryFolder folder;
  test::write_text(folder / "rock.msh",
                   "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 0.01 0 0\n3 0.01 0.03 0\n4 0 0.02 0\n"
                   "$EndNodes\n$Elements\n2\n1 2 2 1 1 1 2 3\n2 2 2 1 1 1 3 4\n$EndElements\n");
  test::write_text(folder / "case.toml",
                   "[lattice]\nsize = [0.01, 0.02]\nspacing = 1e-3\ntime_step = 1e-4\n[time]\nsteps = 10\n"
                   "[geometry]\ntype = \"rock\"\n[rock]\nmesh = \"rock.msh\"\n[mechanics]\n");
  const Outcome outcome = run_vug("run " + (folder / "case.toml") + " -o " + (folder / "out"));
  EXPECT_EQ(outcome.exit_code, 2) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("rock.msh: the point (0.01, 0.03) m lies outside the lattice"));
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

TEST(ExitCodes, WrongArgumentsGiveTwo) {
  for (const char* arguments :
       {"", "walk", "run", "run --steps -1 x.toml", "run --threads zero x.toml", "check", "info --fast"}) {
    const Outcome outcome = run_vug(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments << outcome.output;
    EXPECT_EQ(lines_in(outcome.output), 1) << outcome.output;
  }
  EXPECT_EQ(run_vug("--help").exit_code, 0);
  for (const char* number : {"-1", "1e3", "99999999999999999999", "x"}) {
    const Outcome outcome = run_vug(std::string("run x.toml --steps ") + number);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr("must be a whole number, 0 or more"));
    EXPECT_LT(outcome.output.size(), 120u) << outcome.output;
  }
  for (const char* strength : {"0", "-1", "nan", "inf", "1e999"})
    EXPECT_THAT(run_vug(std::string("lab x.toml --fit-cohesion ") + strength).output,
                HasSubstr("must be a number above 0"));
}

/// As where Slurm's srun is not told which MPI there is: each of them would be a run of its own, in the same folder.
TEST(ExitCodes, ProcessesThatMpiDoesNotKnowGiveTwo) {
  const TemporaryFolder folder;
  const auto with = [](const std::string& environment, const std::string& arguments) {
    return run_command(environment + " OMP_PROC_BIND=false " VUG_EXECUTABLE " " + arguments);
  };
  const std::string channel = VUG_SOURCE_DIR "/cases/tutorial/channel.toml",
                    run = "run " + channel + " --quiet --threads 1 --steps 2 -o " + (folder / "out");
  const Outcome refused = with("SLURM_STEP_NUM_TASKS=2", run);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.output, HasSubstr("vug: srun started 2 processes that MPI does not know: srun --mpi=pmix"));
  EXPECT_EQ(lines_in(refused.output), 1);
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
  for (const char* rank : {"PMIX_RANK", "PALS_RANKID"}) {  // MPI knows them: Slurm says how many
    const Outcome without_mpi = with("SLURM_STEP_NUM_TASKS=2 " + std::string(rank) + "=0", run);
    EXPECT_EQ(without_mpi.exit_code, 2) << rank << without_mpi.output;
    EXPECT_THAT(without_mpi.output, HasSubstr("2 processes were started together, but this vug has no MPI"));
  }
  for (const char* environment : {"SLURM_STEP_NUM_TASKS=2 PMI_RANK=0", "SLURM_STEP_NUM_TASKS=1"})
    EXPECT_EQ(with(environment, run + " --overwrite").exit_code, 0) << environment;
  test::write_text(folder / "study.toml",
                   "[study]\ncase = \"" + std::filesystem::absolute(VUG_SOURCE_DIR "/cases/poiseuille.toml").string() +
                       "\"\nset = [\"time.steps=20\", \"output.interval_steps=10\"]\n[[study.keys]]\nkey = "
                       "\"flow.viscosity\"\nvalues = [1e-6]\n");
  for (const char* more : {" --member 0", " --resume --quiet"})
    EXPECT_EQ(with("SLURM_STEP_NUM_TASKS=2", "sweep " + (folder / "study.toml") + " -o " + (folder / "study") + more)
                  .exit_code,
              0)
        << test::contents(folder / "study/runs/0001.log");
}

/// One rule: a name that leads to no file and a file of the wrong content are mistakes of the input.
TEST(ExitCodes, InputFilesThatAreNoneOrDamagedGiveTwoAtOnce) {
  const TemporaryFolder folder;
  test::write_text(folder / "damaged.png", "\x89PNG\r\n\x1a\n and no more");
  test::write_text(folder / "damaged.msh", "$MeshFormat\n\x1b[31m 0 8\n");
  ASSERT_EQ(run_command("mkfifo " + (folder / "pipe.png") + " " + (folder / "pipe.msh") + " " + (folder / "pipe.toml"))
                .exit_code,
            0);
  const auto refused = [&](const std::string& path, const std::string& why) {
    const Outcome outcome =
        run_command("OMP_PROC_BIND=false timeout 20 " VUG_EXECUTABLE " run " + path + " -o " + (folder / "out"));
    EXPECT_EQ(outcome.exit_code, 2) << path << outcome.output;
    EXPECT_EQ(lines_in(outcome.output), 1) << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr(why));
    EXPECT_EQ(outcome.output.find('\x1b'), std::string::npos);
  };
  refused(folder / "pipe.toml", "is a pipe");
  refused("/dev/zero", "is a device");
  refused(folder.path(), "is a folder");
  const std::string head =
      "[lattice]\nsize = [0.01, 0.02]\nspacing = 1e-3\ntime_step = 1e-4\n[time]\nsteps = 10\n"
      "[heat]\nfluid_diffusivity = 1e-3\nsolid_diffusivity = 1e-3\n[geometry]\n";
  const struct {
    const char *file, *why;
  } files[] = {{"damaged", "damaged."}, {"pipe", "is a pipe"}, {"missing", "does not exist"}};
  for (const auto& [file, why] : files) {
    test::write_text(folder / "case.toml", head + "type = \"image\"\nfile = \"" + file + ".png\"\n");
    refused(folder / "case.toml", why);
    test::write_text(folder / "case.toml", head + "type = \"rock\"\n[rock]\nmesh = \"" + file + ".msh\"\n");
    refused(folder / "case.toml", why);
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

TEST(ExitCodes, UnknownFieldIsRefusedBeforeAnythingIsWritten) {
  const TemporaryFolder folder;
  const std::string out = folder / "out", wrong = " --set output.fields=[\\\"velocty\\\"]";
  ASSERT_EQ(run_vug("run " + small_rock + " --quiet --steps 1 -o " + out).exit_code, 0);
  const std::string before = test::contents(out + "/run.json");
  for (const std::string& command :
       {"check " + small_rock, "run " + small_rock + " --quiet -o " + out,
        "run " + small_rock + " --quiet -o " + (folder / "new"),
        std::string("lab " VUG_SOURCE_DIR "/cases/laboratory/compression.toml -o ") + (folder / "new")}) {
    const Outcome outcome = run_vug(command + wrong);
    EXPECT_EQ(outcome.exit_code, 2) << command << outcome.output;
    EXPECT_EQ(lines_in(outcome.output), 1) << outcome.output;
  }
  EXPECT_EQ(test::contents(out + "/run.json"), before);
  EXPECT_FALSE(std::filesystem::exists(folder / "new"));
}

TEST(ExitCodes, MemoryThatDoesNotSufficeGivesFiveAndNumbers) {
#if defined(__SANITIZE_ADDRESS__) || defined(VUG_SEPARATE_MEMORY)
  GTEST_SKIP() << "the memory that these builds set aside is beyond any limit";
#endif
  const TemporaryFolder folder;
  const auto limited = [&](int mebibytes, const std::string& size) {
    return run_command("ulimit -v " + std::to_string(1024 * mebibytes) +
                       "; OMP_PROC_BIND=false OMP_NUM_THREADS=1 " VUG_EXECUTABLE " run " VUG_SOURCE_DIR
                       "/cases/poiseuille.toml --quiet --steps 1 --set flow.body_force=[1e-6,0] --set lattice.size=" +
                       size + " -o " + (folder / std::to_string(mebibytes)));
  };
  const Outcome hopeless = limited(2000, "[1.5,1.5]");  // 225 million nodes: 1.1 GB of node numbers and 37 GB of fluid
  EXPECT_EQ(hopeless.exit_code, 5) << hopeless.output;
  EXPECT_EQ(lines_in(hopeless.output), 1) << hopeless.output;
  EXPECT_THAT(hopeless.output, testing::ContainsRegex("needs [0-9.]+ GiB of memory at least, and ulimit -v leaves"));
  EXPECT_FALSE(std::filesystem::exists(folder / "2000"));
  // 176 MB of fluid: what passes the prediction and does not suffice after all ends in the same way
  for (const int mebibytes : {60, 100, 140, 180, 200}) {
    const Outcome outcome = limited(mebibytes, "[0.1,0.1]");
    EXPECT_EQ(outcome.exit_code, 5) << mebibytes << outcome.output;
    EXPECT_EQ(lines_in(outcome.output), 1) << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr("leaves"));
    const std::string record = folder / (std::to_string(mebibytes) + "/run.json");
    if (std::filesystem::exists(record)) {
      EXPECT_THAT(test::contents(record), HasSubstr("\"status\": \"failed\""));
      EXPECT_THAT(test::contents(record), HasSubstr("\"exit_code\": 5"));
    }
  }
}

TEST(ExitCodes, UnwritableFolderAndFullDiskGiveFour) {
  const TemporaryFolder folder;
  test::write_text(folder / "file", "not a folder");
  const Outcome unwritable = run_vug("run " + small_rock + " --quiet -o " + (folder / "file") + "/out");
  EXPECT_EQ(unwritable.exit_code, 4) << unwritable.output;
  EXPECT_EQ(lines_in(unwritable.output), 1) << unwritable.output;
  // a limit on the size of files is what a full disk looks like to a program
  const Outcome full = run_command("ulimit -f 8; trap '' XFSZ; OMP_PROC_BIND=false " VUG_EXECUTABLE " run " +
                                   small_rock + " --quiet -o " + (folder / "full"));
  EXPECT_EQ(full.exit_code, 4) << full.output;
  EXPECT_EQ(lines_in(full.output), 1) << full.output;
}

TEST(ExitCodes, DivergingRunGivesThreeAndNamesTheLastGoodState) {
  const TemporaryFolder folder;
  // a viscosity far below what the pressure allows, and no limiter to save it
  const Outcome outcome = run_vug("run " + small_rock + " --quiet -o " + (folder / "out") +
                                  " --set flow.viscosity=2e-6 --set flow.speed_limit=0 --set flow.pressure_scale=1"
                                  " --set output.checkpoint_interval=2.5e-5 --set accuracy.guard_interval=10");
  EXPECT_EQ(outcome.exit_code, 3) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("diverged at step"));
  EXPECT_THAT(outcome.output, HasSubstr("the last good state is the checkpoint of step"));
  EXPECT_THAT(test::contents((folder / "out") + "/run.json"),
              testing::AllOf(HasSubstr("\"status\": \"diverged\""), HasSubstr("\"exit_code\": 3")));
}

}  // namespace
}  // namespace vug
