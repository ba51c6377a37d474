// Checkpoints that somebody has changed and whose digest was made to fit again: refused, or run until a guard stops
// them; never a crash.
#include "base/require.hpp"
#include "coupling/simulation.hpp"
#include "io/checkpoint.hpp"
#include "io/detail/digest.hpp"
#include "support/run_vug.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <random>

namespace vug {
namespace {

const CheckpointOwner owner{"case", "run"};

/// With a digest that fits.
std::string repaired(std::string file) {
  detail::DataDigest digest;
  digest.add(std::string_view(file).substr(0, file.size() - 8));
  const std::uint64_t value = digest.value();
  std::memcpy(file.data() + file.size() - 8, &value, sizeof value);
  return file;
}

/// A few words somewhere become what an attacker would try.
std::string attacked(std::string file, std::mt19937& random) {
  const std::size_t words = file.size() / 8 - 1;
  // small blocks, switches and sizes are at the front and between large fields: half of the attacks begin at a header
  std::vector<std::size_t> headers;
  for (const char* name : {"clock/step", "geometry/", "/turned", "mechanics/", "growth/", "reaction/", "steady"})
    for (auto at = file.find(name); at != std::string::npos; at = file.find(name, at + 1)) headers.push_back(at / 8);
  const int changes = 1 + static_cast<int>(random() % 4);
  for (int c = 0; c < changes; ++c) {
    const bool near = random() % 2 == 0;
    const std::size_t word =
        std::min(words - 1, near ? headers[random() % headers.size()] + random() % 12 : random() % words);
    char* place = file.data() + 8 * word;
    const auto put = [&](auto value) {
      std::memcpy(place + (sizeof value == 4 ? 4 * (random() % 2) : 0), &value, sizeof value);
    };
    switch (random() % 9) {
      case 0:
        put(std::uint64_t{random()} << 32 | random());
        break;
      case 1:
        put(std::numeric_limits<std::int64_t>::max());
        break;
      case 2:
        put(std::int64_t{-1});
        break;
      case 3:
        put(std::numeric_limits<double>::quiet_NaN());
        break;
      case 4:
        put(1e308);
        break;
      case 5:
        put(-1e300);
        break;
      case 6:
        put(std::numeric_limits<std::int32_t>::max());
        break;
      case 7:
        put(static_cast<std::int32_t>(random() % 100000));
        break;
      default:
        place[random() % 8] ^= static_cast<char>(1 << random() % 8);
    }
  }
  return repaired(file);
}

/// Attacks the checkpoint of a coupled run so many times; what is accepted goes on for some steps.
void attack(int times, const std::vector<std::string>& choice) {
  const Scene scene = read_scene(test::small_rock, choice);
  const test::TemporaryFolder folder;
  Simulation simulation(scene);
  simulation.begin();
  while (simulation.clock().step < 64) simulation.step();
  write_checkpoint(folder.path(), simulation.state(), simulation.clock().step, 0, owner);
  const std::string path = folder / "step_000000000064.checkpoint", sound = test::contents(path);
  ASSERT_EQ(repaired(sound), sound);
  std::mt19937 random(1);
  int refused = 0, stopped = 0, accepted = 0;
  for (int i = 0; i < times; ++i) {
    test::write_text(path, attacked(sound, random));
    try {
      Simulation resumed(scene);
      const auto checkpoint = Checkpoint::latest(folder.path(), owner);
      resumed.restore([&](StateList& state) { checkpoint->load(state); });
      for (int step = 0; step < 12; ++step) {
        resumed.step();
        resumed.guard();
      }
      resumed.history();
      ++accepted;
    } catch (const FileError&) {
      ++refused;
    } catch (const StabilityError&) {
      ++stopped;
    }
  }
  EXPECT_EQ(refused + stopped + accepted, times);
  EXPECT_GT(refused, times / 10);
  EXPECT_GT(accepted, 0) << "an attack that changes a number a little is no crash";
}

const std::vector<std::string> resting{"mechanics.rest_tolerance=1", "rock.element_size=2e-3",
                                       "accuracy.flow_tolerance=0.5", "reaction.wall=paper"};

TEST(HostileCheckpoint, IsRefusedOrStopped) {
  attack(60, {});
  attack(30, resting);
}

TEST(HostileCheckpointLong, IsRefusedOrStopped) {
  attack(5000, {});
  attack(2000, resting);
}

}  // namespace
}  // namespace vug
