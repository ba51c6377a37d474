// How much memory a case takes is said before it is taken.
#include "coupling/memory_need.hpp"

#include "base/require.hpp"
#include "coupling/simulation.hpp"
#include "host/device_memory.hpp"
#include "host/memory.hpp"
#include "support/obstacle.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace vug {
namespace {

using testing::HasSubstr;

/// What is predicted is at least needed, and most of what is taken.
TEST(MemoryNeed, IsMostOfWhatIsTaken) {
  watch_allocations();
  const std::vector<Scene> scenes{
      parse_scene(test::obstacle, "a.toml"), parse_scene(test::obstacle, "a.toml", {"accuracy.precision=single"}),
      parse_scene(test::obstacle, "a.toml", {"solute.velocity_set=d2q9", "heat.velocity_set=d2q9"}),
      parse_scene(test::heated_disc, "a.toml")};
  for (const Scene& scene : scenes) {
    const double before = allocated_bytes();
    const Simulation simulation(scene);
    const double taken = allocated_bytes() - before;
    const double predicted = bytes_of_lattice(scene) + bytes_of_fluid(scene, simulation.parts().geometry.fluid.count);
    EXPECT_LE(predicted, taken);
    EXPECT_GE(predicted, 0.6 * taken);
  }
}

TEST(MemoryNeed, ThatCannotBeMetIsRefusedBeforeItIsTaken) {
  EXPECT_NO_THROW(require_memory(1e6, "a case"));
  try {
    require_memory(1e18, "a case");
    ADD_FAILURE() << "accepted";
  } catch (const MemoryError& error) {
    EXPECT_THAT(error.what(), testing::StartsWith("a case needs 888 PiB of memory at least, and "));
    EXPECT_THAT(error.what(), HasSubstr(" leaves "));
  }
}

/// A GPU's memory, here the host's, is asked by taking it. What stands for it with VUG_SEPARATE_MEMORY has no end, and
/// the sanitizer ends who asks for too much.
TEST(MemoryNeed, OfADeviceIsAskedByTakingIt) {
  EXPECT_NO_THROW(require_room<Kokkos::HostSpace>(0, "a case"));
  EXPECT_NO_THROW(require_room<Kokkos::HostSpace>(1e6, "a case"));
#if !defined(VUG_SEPARATE_MEMORY) && !defined(__SANITIZE_ADDRESS__)
  try {
    require_room<Kokkos::HostSpace>(1e18, "a case");
    ADD_FAILURE() << "accepted";
  } catch (const MemoryError& error) {
    EXPECT_THAT(error.what(), testing::StartsWith("a case needs 888 PiB of memory at least, and the memory of "));
  }
#endif
}

}  // namespace
}  // namespace vug
