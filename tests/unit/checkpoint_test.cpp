// A checkpoint gives back the same bytes or is refused; nothing in between.
#include "io/checkpoint.hpp"

#include "base/require.hpp"
#include "support/host_copy.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace vug {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

/// A state with every kind of block: a view, an odd number of bytes, nothing at all, a number.
struct State {
  Kokkos::View<double* [2], Kokkos::LayoutLeft> view { "vug::test::view", 37 };
  Kokkos::View<std::uint8_t*> bytes{"vug::test::bytes", 13};
  Kokkos::View<float*> empty{"vug::test::empty", 0};
  double value = 0;

  void fill(int seed) {
    const auto view_host = Kokkos::create_mirror_view(view);
    const auto bytes_host = Kokkos::create_mirror_view(bytes);
    for (int i = 0; i < 37; ++i)
      for (int k = 0; k < 2; ++k) view_host(i, k) = std::sin(seed + 2 * i + k);
    for (int i = 0; i < 13; ++i) bytes_host(i) = static_cast<std::uint8_t>(seed * i);
    Kokkos::deep_copy(view, view_host);
    Kokkos::deep_copy(bytes, bytes_host);
    value = seed / 3.0;
  }
  StateList list() {
    StateList state;
    state.add("test/view", view);
    state.add("test/bytes", bytes);
    state.add("test/empty", empty);
    state.add_value("test/value", value);
    return state;
  }
  std::vector<std::byte> all_bytes() {
    std::vector<std::byte> all;
    for (const auto& block : list().blocks) {
      const auto part = block.saved();
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  }
};

std::string only_file(const std::string& folder) {
  return fs::directory_iterator(folder)->path().string();
}

TEST(Checkpoint, GivesBackTheSameBytes) {
  const test::TemporaryFolder folder;
  State written, read;
  written.fill(3);
  write_checkpoint(folder / "checkpoint", written.list(), 120, 0.1 + 0.2, {"abc", "r1"});
  const auto checkpoint = Checkpoint::latest(folder / "checkpoint", {"abc", "r1"}).value();
  checkpoint.load(read.list());
  EXPECT_EQ(checkpoint.step(), 120);
  EXPECT_EQ(checkpoint.time(), 0.1 + 0.2);
  EXPECT_TRUE(checkpoint.refused().empty());
  EXPECT_EQ(read.all_bytes(), written.all_bytes());
  EXPECT_TRUE(checkpoint.holds(written.list().blocks.front().name));
  EXPECT_FALSE(checkpoint.holds("of another program"));
}

TEST(Checkpoint, KeepsTheNewestTwo) {
  const test::TemporaryFolder folder;
  State state;
  for (const int step : {5, 10, 1000, 20}) write_checkpoint(folder.path(), state.list(), step, 0, {"abc", "r1"});
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder.path())) names.push_back(entry.path().filename());
  EXPECT_THAT(names, ::testing::UnorderedElementsAre("step_000000000010.checkpoint", "step_000000000020.checkpoint"))
      << "a state of a future that was left is none of them";
}

TEST(Checkpoint, RemovesWhatAKilledProcessDidNotFinish) {
  const test::TemporaryFolder folder;
  State state;
  for (const char* name : {"step_000000000007.checkpoint.tmp", "mine.tmp"}) std::ofstream(folder.path() + "/" + name);
  write_checkpoint(folder.path(), state.list(), 5, 0, {"abc", "r1"});
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder.path())) names.push_back(entry.path().filename());
  EXPECT_THAT(names, ::testing::UnorderedElementsAre("step_000000000005.checkpoint", "mine.tmp"));
}

TEST(Checkpoint, LeavesThoseOfAnotherRunAlone) {
  const test::TemporaryFolder folder;
  State state;
  for (const int step : {1000, 2000}) write_checkpoint(folder.path(), state.list(), step, 0, {"abc", "old"});
  for (const int step : {1, 2, 3}) write_checkpoint(folder.path(), state.list(), step, 0, {"abc", "new"});
  const auto checkpoint = Checkpoint::latest(folder.path(), {"abc", "new"}).value();
  EXPECT_EQ(checkpoint.step(), 3);
  ASSERT_EQ(checkpoint.refused().size(), 2u);
  EXPECT_THAT(checkpoint.refused()[0],
              HasSubstr("step_000000002000.checkpoint: the checkpoint belongs to another run"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 4);
  EXPECT_EQ(Checkpoint::latest(folder.path(), {"abc", ""}).value().run(), "old") << "whichever";
}

TEST(Checkpoint, RefusesNumbersThatCannotBe) {
  const test::TemporaryFolder folder;
  Kokkos::View<int*> index("vug::test::index", 3);
  Kokkos::View<float*> number("vug::test::number", 2);
  std::uint8_t flag = 0;
  const auto written = [&] {
    StateList state;
    state.add("index", index);
    state.add("number", number);
    state.add_value("flag", flag);
    return state;
  };
  bool held = false;
  StateList wanted;
  wanted.add("index", index, {0, 9});
  wanted.add("number", number);
  wanted.add_value("flag", held);
  const auto load = [&] {
    write_checkpoint(folder.path(), written(), 1, 0, {"abc", "r1"});
    Checkpoint::latest(folder.path(), {"abc", "r1"}).value().load(wanted);
  };
  EXPECT_NO_THROW(load());
  const auto refused = [&](const std::string& name, auto value) {
    try {
      load();
      ADD_FAILURE() << name << " = " << +value << " was accepted";
    } catch (const FileError& e) {
      EXPECT_THAT(e.what(), HasSubstr("step_000000000001.checkpoint: checkpoint block '" + name + "'"));
    }
  };
  const auto refused_in = [&](const auto& view, int i, auto value, const std::string& name) {
    const auto before = test::host_copy(view);
    test::set_entry(view, i, value);
    refused(name, value);
    Kokkos::deep_copy(view, before);
  };
  refused_in(index, 2, 10, "index");
  refused_in(index, 0, -1, "index");
  refused_in(number, 1, std::numeric_limits<float>::quiet_NaN(), "number");
  refused_in(number, 0, std::numeric_limits<float>::infinity(), "number");
  refused("flag", flag = 2);
}

TEST(Checkpoint, PassesOverADamagedOneToTheOneBefore) {
  const test::TemporaryFolder folder;
  State first, second, read;
  first.fill(1);
  second.fill(2);
  write_checkpoint(folder.path(), first.list(), 10, 1, {"abc", "r1"});
  write_checkpoint(folder.path(), second.list(), 20, 2, {"abc", "r1"});
  fs::resize_file(folder / "step_000000000020.checkpoint", 100);
  const auto checkpoint = Checkpoint::latest(folder.path(), {"abc", "r1"}).value();
  checkpoint.load(read.list());
  EXPECT_EQ(checkpoint.step(), 10);
  EXPECT_EQ(read.all_bytes(), first.all_bytes());
  ASSERT_EQ(checkpoint.refused().size(), 1u);
  EXPECT_THAT(checkpoint.refused()[0], HasSubstr("step_000000000020.checkpoint"));
}

TEST(Checkpoint, RefusesATruncatedFileOfAnyLength) {
  const test::TemporaryFolder folder;
  State state;
  state.fill(1);
  write_checkpoint(folder.path(), state.list(), 10, 1, {"abc", "r1"});
  const auto path = only_file(folder.path());
  const auto whole = test::contents(path);
  for (std::size_t length = 0; length < whole.size(); ++length) {
    test::write_text(path, whole.substr(0, length));
    EXPECT_THROW(Checkpoint::open(path, {"abc", "r1"}), FileError) << length;
    EXPECT_THROW(Checkpoint::latest(folder.path(), {"abc", "r1"}), FileError) << length;
  }
  test::write_text(path, whole + std::string(8, '\0'));
  EXPECT_THROW(Checkpoint::open(path, {"abc", "r1"}), FileError) << "longer";
}

TEST(Checkpoint, RefusesAFileWithAnyBitFlipped) {
  const test::TemporaryFolder folder;
  State state;
  state.fill(1);
  write_checkpoint(folder.path(), state.list(), 10, 1, {"abc", "r1"});
  const auto path = only_file(folder.path());
  const auto whole = test::contents(path);
  for (std::size_t bit = 0; bit < 8 * whole.size(); bit += 7) {
    auto flipped = whole;
    flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << bit % 8));
    test::write_text(path, flipped);
    EXPECT_THROW(Checkpoint::open(path, {"abc", "r1"}), FileError) << bit;
  }
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {  // and several bits at once
    auto flipped = whole;
    for (int k = 0; k < 2 + i % 9; ++k) flipped[random() % whole.size()] ^= static_cast<char>(1 << random() % 8);
    if (flipped == whole) continue;
    test::write_text(path, flipped);
    EXPECT_THROW(Checkpoint::open(path, {"abc", "r1"}), FileError);
  }
}

TEST(Checkpoint, RefusesWhatIsForeign) {
  const test::TemporaryFolder folder;
  State state;
  write_checkpoint(folder.path(), state.list(), 10, 1, {"abc", "r1"});
  try {
    Checkpoint::latest(folder.path(), {"abd", "r1"});
    FAIL() << "accepted";
  } catch (const FileError& e) {
    EXPECT_THAT(e.what(), HasSubstr("another case"));
  }
  const auto path = only_file(folder.path());
  test::write_text(path, std::string(4096, 'x'));
  try {
    Checkpoint::latest(folder.path(), {"abc", "r1"});
    FAIL() << "accepted";
  } catch (const FileError& e) {
    EXPECT_THAT(e.what(), HasSubstr("no checkpoint"));
  }
  EXPECT_FALSE(Checkpoint::latest(folder / "missing", {"abc", "r1"}));
}

TEST(Checkpoint, RefusesBlocksThatDoNotFit) {
  const test::TemporaryFolder folder;
  State state;
  write_checkpoint(folder.path(), state.list(), 10, 1, {"abc", "r1"});
  const auto checkpoint = Checkpoint::latest(folder.path(), {"abc", "r1"}).value();
  Kokkos::View<double*> longer("vug::test::longer", 75);
  StateList wrong_size, missing;
  wrong_size.add("test/view", longer);
  missing.add("test/other", longer);
  EXPECT_THROW(checkpoint.load(wrong_size), FileError);
  EXPECT_THROW(checkpoint.load(missing), FileError);
}

TEST(Checkpoint, NamesPathAndReasonWhenItCannotWrite) {
  State state;
  try {
    write_checkpoint("/proc/no/checkpoint", state.list(), 10, 1, {"abc", "r1"});
    FAIL() << "accepted";
  } catch (const FileError& e) {
    EXPECT_THAT(e.what(), HasSubstr("/proc/no/checkpoint"));
    EXPECT_THAT(e.what(), HasSubstr("No such file or directory"));
  }
}

}  // namespace
}  // namespace vug
