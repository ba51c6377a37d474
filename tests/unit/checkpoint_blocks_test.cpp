// Blocks of bytes in a checkpoint: in pieces, and with kills at any moment.
#include "io/checkpoint.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <random>
#include <span>
#include <sys/wait.h>
#include <unistd.h>

namespace vug {
namespace {

namespace fs = std::filesystem;

/// However the bytes come in pieces, the file is the same, and any part of it can be asked for.
TEST(Checkpoint, HoldsBlocksThatComeAndGoInPieces) {
  const test::TemporaryFolder folder;
  std::vector<std::byte> bytes(1013);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::byte>(7 * i + i / 256);
  std::string whole;
  for (const std::size_t piece : {std::size_t{2000}, std::size_t{1}, std::size_t{3}, std::size_t{8}, std::size_t{37}}) {
    StateList written, read;
    written.add({"block",
                 bytes.size(),
                 [&](const TakeBytes& take) {
                   for (std::size_t at = 0; at < bytes.size(); at += piece)
                     take(std::span(bytes).subspan(at, std::min(piece, bytes.size() - at)));
                 },
                 {}});
    write_checkpoint(folder.path(), written, 1, 0, {"abc", "r1"});
    const std::string contents = test::contents(folder / "step_000000000001.checkpoint");
    if (whole.empty()) whole = contents;
    EXPECT_TRUE(contents == whole) << piece;
    std::vector<std::byte> found(100);
    read.add({"block", bytes.size(), {}, [&](const GiveBytes& give) { give(511, found); }});
    Checkpoint::latest(folder.path(), {"abc", "r1"})->load(read);
    EXPECT_TRUE(std::equal(found.begin(), found.end(), bytes.begin() + 511)) << piece;
  }
}

// A child writes checkpoint after checkpoint until it is killed, at a moment of chance. Whatever it was doing, the
// newest file is sound: its contents are those of its step.
TEST(Checkpoint, SurvivesKillsAtAnyMoment) {
  const test::TemporaryFolder folder;
  constexpr std::size_t size = 300000;
  const auto block_of = [](std::int64_t step) { return std::vector<std::byte>(size, static_cast<std::byte>(step)); };
  std::mt19937 random(1);
  std::int64_t newest = 0;
  const auto newest_name = [&folder] {
    std::string name;
    for (const auto& entry : fs::directory_iterator(folder.path()))
      if (entry.path().extension() == ".checkpoint") name = std::max(name, entry.path().filename().string());
    return name;
  };
  for (int kill = 0; kill < 30; ++kill) {
    const auto before = newest_name();
    const pid_t child = fork();
    if (child == 0) {
      for (std::int64_t step = newest + 1;; ++step) {
        StateList state;
        state.add({"block", size, [&](const TakeBytes& take) { take(block_of(step)); }, {}});
        write_checkpoint(folder.path(), state, step, 0, {"abc", "r1"});
      }
    }
    // the newest name changes when the child is under way, however busy the machine; then a moment of chance
    for (int wait = 0; wait < 20000 && newest_name() == before; ++wait) usleep(1000);
    usleep(random() % 9000);
    ::kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    bool same = false;
    const auto checkpoint = Checkpoint::latest(folder.path(), {"abc", "r1"}).value();
    StateList state;
    state.add({"block", size, {}, [&](const GiveBytes& give) {
                 std::vector<std::byte> found(size);
                 give(0, found);
                 same = found == block_of(checkpoint.step());
               }});
    checkpoint.load(state);
    EXPECT_TRUE(same);
    EXPECT_TRUE(checkpoint.refused().empty());
    EXPECT_GE(checkpoint.step(), newest);
    newest = checkpoint.step();
  }
  EXPECT_GT(newest, 0);
}

}  // namespace
}  // namespace vug
