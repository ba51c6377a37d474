// What the disk can do to a run: be full, be forbidden, or lose its writer at any moment.
#include "base/require.hpp"
#include "io/checkpoint.hpp"
#include "io/detail/hdf5_file.hpp"
#include "io/history_writer.hpp"
#include "io/run_record.hpp"
#include "io/snapshot_writer.hpp"
#include "support/made_field.hpp"
#include "support/refused_in_child.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <random>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace vug {
namespace {

using test::refused_in_child;
using test::refused_without_rights;
using ::testing::HasSubstr;

/// While it lives, no file can grow beyond `bytes`: write() fails as it does on a full disk, with another reason.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) {
    old_handler_ = std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &old_);
    const rlimit small{bytes, old_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  ~SmallDisk() {
    setrlimit(RLIMIT_FSIZE, &old_);
    std::signal(SIGXFSZ, old_handler_);
  }

 private:
  rlimit old_{};
  void (*old_handler_)(int);
};

constexpr int side = 100;

// Numbers that do not compress: a snapshot takes 40 kB and more.
FieldList noise() {
  FieldList list;
  std::vector<double> values(side * side);
  std::mt19937 random(1);
  for (double& value : values) value = static_cast<double>(random()) / 7;
  list.lattice.push_back(test::made_field("noise", "1", 1, [values](std::size_t i) { return values[i]; }));
  return list;
}

SnapshotWriter noise_writer(const std::string& folder, std::optional<std::int64_t> resume = std::nullopt) {
  SnapshotOptions options;
  options.resume_step = resume;
  return {folder, Lattice(side, side), 1e-3, noise(), options};
}

void expect_file_error(const std::function<void()>& action, const std::string& path, const std::string& reason) {
  try {
    action();
    ADD_FAILURE() << path << ": no error";
  } catch (const FileError& e) {
    EXPECT_THAT(e.what(), HasSubstr(path));
    EXPECT_THAT(e.what(), HasSubstr(reason));
  }
}

int files_in(const std::string& folder) {
  return static_cast<int>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

// How many snapshots a user finds, every one read to its end; -1 when that fails.
int read_groups(const std::string& path) {
  const std::string script =
      "import h5py,sys; f=h5py.File(sys.argv[1],'r'); [g[k][...] for g in f.values() for k in g]; "
      "sys.exit(100 + min(len(f), 100))";
  const int status = std::system((std::string(VUG_PYTHON) + " -c \"" + script + "\" " + path).c_str());
  return WIFEXITED(status) && WEXITSTATUS(status) >= 100 ? WEXITSTATUS(status) - 100 : -1;
}

TEST(FullDisk, StopsSnapshotsWithTheReasonAndKeepsTheOnesBefore) {
  const test::TemporaryFolder folder;
  {
    auto writer = noise_writer(folder.path());
    writer.write(0, 0);
    writer.write(1, 1);
  }
  for (const int room : {0, 1, 100, 2000, 8000, 30000}) {  // fails at different places
    EXPECT_TRUE(refused_in_child(
        [&] {
          auto writer = noise_writer(folder.path(), 1);
          const SmallDisk disk(room);
          writer.write(2, 2);
        },
        folder / "fields/step_000000000002.h5: cannot write: File too large"))
        << room;
    EXPECT_EQ(read_groups(folder / "fields.h5"), 2) << room;
  }
  EXPECT_EQ(files_in(folder / "fields"), 2) << "nothing half-written is left";
  noise_writer(folder.path(), 1).write(2, 2);  // space has been made: the run goes on
  EXPECT_EQ(read_groups(folder / "fields.h5"), 3);
}

TEST(FullDisk, StopsCheckpointsWithTheReasonAndKeepsTheOneBefore) {
  const test::TemporaryFolder folder;
  StateList state;
  const std::vector<std::byte> bytes(200000);
  state.add({"block", bytes.size(), [&](const TakeBytes& take) { take(bytes); }, {}});
  write_checkpoint(folder.path(), state, 1, 0, {"abc", "r1"});
  {
    const SmallDisk disk(100 * 1024);
    expect_file_error(
        [&] {
          write_checkpoint(folder.path(), state, 2, 0, {"abc", "r1"});
        },
        "step_000000000002.checkpoint", "File too large");
  }
  EXPECT_EQ(Checkpoint::latest(folder.path(), {"abc", "r1"})->step(), 1);
  EXPECT_EQ(files_in(folder.path()), 1) << "nothing half-written is left";
}

TEST(FullDisk, StopsTheHistoryAndTheRecordWithTheReason) {
  const test::TemporaryFolder folder;
  HistoryWriter history(folder / "history.csv", {"time_s", "x"});
  RunRecord record;
  record.case_text = std::string(5000, 'x');
  write_run_record(folder.path(), record);
  const auto before = test::contents(folder / "run.json");
  const SmallDisk disk(1000);
  expect_file_error(
      [&] {
        for (int i = 0; i < 1000; ++i) history.write(std::vector<double>{1.0 / 3, 1.0 / 3});
      },
      folder / "history.csv", "File too large");
  record.status = "done";
  expect_file_error([&] { write_run_record(folder.path(), record); }, folder / "run.json", "File too large");
  EXPECT_EQ(test::contents(folder / "run.json"), before);
}

TEST(ForbiddenFolder, IsRefusedWithTheReason) {
  const test::TemporaryFolder folder;
  std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec |
                                                  std::filesystem::perms::others_exec);
  const std::string reason = "Permission denied";
  StateList state;
  EXPECT_TRUE(refused_without_rights([&] { noise_writer(folder.path()); }, reason));
  EXPECT_TRUE(refused_without_rights([&] { write_checkpoint(folder / "checkpoint", state, 1, 0, {}); }, reason));
  EXPECT_TRUE(refused_without_rights([&] { HistoryWriter(folder / "history.csv", {"time_s"}); }, reason));
  EXPECT_TRUE(refused_without_rights([&] { write_run_record(folder.path(), {}); }, reason));
  std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_all);
}

std::string group_name(std::int64_t step) {
  char name[32];
  std::snprintf(name, sizeof(name), "step_%012lld", static_cast<long long>(step));
  return name;
}

int occurrences(const std::string& text, const std::string& word) {
  int count = 0;
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

// A run that is killed while it writes snapshots, again and again, and resumed each time from the last: whoever reads
// the files then finds all of them whole, and no snapshot that was named is ever lost.
TEST(KilledRun, LeavesReadableSnapshots) {
  const test::TemporaryFolder folder;
  noise_writer(folder.path()).write(0, 0);
  std::mt19937 random(1);
  std::int64_t last = 0;
  for (int kill = 0; kill < 50; ++kill) {
    const pid_t child = fork();
    if (child == 0) {
      auto writer = noise_writer(folder.path(), last);
      for (std::int64_t step = last + 1;; ++step) writer.write(static_cast<double>(step), step);
    }
    // wait for the first new snapshot, however busy the machine; then a moment of chance
    for (int wait = 0; wait < 20000 && occurrences(test::contents(folder / "fields.xdmf"), "<Time") < last + 2; ++wait)
      usleep(1000);
    usleep(random() % 40000);
    ::kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    const auto xdmf = test::contents(folder / "fields.xdmf");
    const auto index = detail::Hdf5File::open(folder / "fields.h5");
    const int named = occurrences(xdmf, "<Time");
    EXPECT_GE(named, last + 1) << "a snapshot is lost";
    for (std::int64_t step = 0; step < named; ++step) {
      ASSERT_NE(xdmf.find("fields/" + group_name(step) + ".h5:/noise"), std::string::npos) << step;
      ASSERT_EQ(index.datasets(group_name(step)).size(), 1u) << step;
    }
    last = named - 1;
  }
  EXPECT_GE(last, 50) << "too few for the kills to have met anything";
  noise_writer(folder.path(), last);
  EXPECT_EQ(read_groups(folder / "fields.h5"), std::min<std::int64_t>(last + 1, 100));
  EXPECT_EQ(files_in(folder / "fields"), last + 1) << "what was not complete is gone";
}

}  // namespace
}  // namespace vug
