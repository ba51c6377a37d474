// What a lattice step of the paper's rock may launch, copy and wait for, by Kokkos' own count: on a GPU a launch takes
// as long as the work of a small kernel, and a wait as long as many launches. docs/step.md has the table.
#include "coupling/simulation.hpp"
#include "support/overheard.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <string_view>

namespace vug {
namespace {

/// What Kokkos has done while one exists, by labels. A recording is one launch whatever it holds, as a GPU's graph is:
/// a region of vug; a host, which replays nothing, counts every kernel.
class Tally {
 public:
  using Counts = std::map<std::string, int>;
  Counts launches, waits, copies, allocations;

  Tally() {
    counting_ = this;
    using namespace Kokkos::Tools::Experimental;
    set_begin_parallel_for_callback(launched);
    set_begin_parallel_reduce_callback(launched);
    set_begin_parallel_scan_callback(launched);
    set_push_region_callback([](const char* label) {
      if (std::string_view(label).starts_with("vug::")) ++counting_->launches[label];
      counting_->overheard_.region_began(label);
    });
    set_begin_fence_callback([](const char* label, std::uint32_t, std::uint64_t*) {
      // Kokkos itself fences for its tools, and where a host stands in for a GPU before a graph
      const std::string_view wait = label;
      for (const char* not_ours : {"Profile Tool Fence", "Kokkos::DefaultGraph::submit"})
        if (wait.find(not_ours) != wait.npos) return;
      // CUDA waits for the result of a reduction, and Kokkos at once a second time: one wait
      const bool again = wait.starts_with("Kokkos::parallel_reduce");
      if (!again) counting_->count_result();
      counting_->awaited_result_ = wait.find("Result Not Device Accessible") != wait.npos;
      if (counting_->awaited_result_) return;
      ++counting_->waits[label];
    });
    set_allocate_data_callback([](Kokkos::Profiling::SpaceHandle, const char* label, const void*, std::uint64_t size) {
      if (size > 0) ++counting_->allocations[label];
    });
    set_begin_deep_copy_callback([](Kokkos::Profiling::SpaceHandle there, const char* to, const void* target,
                                    Kokkos::Profiling::SpaceHandle here, const char* from, const void* source,
                                    std::uint64_t size) {
      ++counting_->copies[std::string(from) + " -> " + to];
      counting_->overheard_.copied(there, to, target, here, from, source, size);
    });
  }

  static double sum(const Counts& counts) {
    double all = 0;
    for (const auto& [label, times] : counts) all += times;
    return all;
  }
  static std::string list(const Counts& counts) {
    std::string text;
    for (const auto& [label, times] : counts) text += "\n  " + std::to_string(times) + "  " + label;
    return text;
  }

 private:
  /// A wait for a result that no second one followed.
  void count_result() {
    if (awaited_result_) ++waits["result of a reduction"];
    awaited_result_ = false;
  }
  static void launched(const char* label, std::uint32_t device, std::uint64_t* id) {
    counting_->count_result();
    ++counting_->launches[label];
    counting_->overheard_.launched(label, device, id);
  }
  bool awaited_result_ = false;
  test::Overheard overheard_;
  inline static Tally* counting_ = nullptr;
};

constexpr int cycle = 80;    // steps: four updates of the pores, 25 looks at resting rock
constexpr int before = 400;  // after which the walls are renewed once in 50 steps

class BudgetOfAStep : public testing::Test {
 protected:
  BudgetOfAStep()
      : simulation_(read_scene(VUG_SOURCE_DIR "/cases/acid_fracturing/p20_da1.5e-3.toml",
                               {"accuracy.preset=balanced", "lattice.spacing=2.5e-4"})) {
    simulation_.begin();
    for (int step = 0; step < before; ++step) simulation_.step();
  }
  Simulation simulation_;
};

/// 5 sub-steps of 2 launches, on a GPU a recording of those between looks and searches; flow 2; heat 2 (defect, sides,
/// two sweeps in two steps), solutes 1, on a GPU 2, force 1/4, twice where it is handed on; looks at resting rock
/// 5/16 of 2; the rest at updates. A host counts besides who is awake.
constexpr double launches_per_step = runs_on_host ? 17.25 : 9.37;

/// A host, which waits for nothing, looks whether all sleeps.
int looks_of_host(const Tally& tally) {
  const auto looks = tally.launches.find("vug::dem::count_awake");
  return runs_on_host && looks != tally.launches.end() ? looks->second : 0;
}

TEST_F(BudgetOfAStep, OfLaunchesIsKept) {
  const Tally tally;
  for (int step = 0; step < cycle; ++step) simulation_.step();
  const double per_step = Tally::sum(tally.launches) / cycle;
  RecordProperty("launches_per_step", std::to_string(per_step));
  EXPECT_LE(per_step, launches_per_step) << Tally::list(tally.launches);
  EXPECT_GT(per_step, 0.97 * launches_per_step) << "the budget can be lowered" << Tally::list(tally.launches);
}

TEST_F(BudgetOfAStep, HasNoWaitNoCopyAndNoAllocationBetweenUpdatesOfThePores) {
  const int interval = 20;
  for (int update = 0; update < cycle / interval; ++update) {
    const Tally tally;
    for (int step = 1; step < interval; ++step) simulation_.step();
    EXPECT_GT(Tally::sum(tally.launches), 0);
    EXPECT_EQ(Tally::sum(tally.copies), 0) << Tally::list(tally.copies);
    EXPECT_EQ(Tally::sum(tally.allocations), 0) << Tally::list(tally.allocations);
    EXPECT_EQ(Tally::sum(tally.waits), looks_of_host(tally)) << Tally::list(tally.waits);
    simulation_.step();
  }
}

TEST_F(BudgetOfAStep, OfAnUpdateOfThePoresIsThreeNumbers) {
  for (int step = 1; step < 20; ++step) simulation_.step();
  const Tally tally;
  simulation_.step();
  ASSERT_EQ(simulation_.clock().step % 20, 0);
  EXPECT_EQ(tally.launches.count("vug::dissolution::mark"), 1u);
  EXPECT_EQ(tally.launches.count("vug::pathways::look"), 1u);
  EXPECT_EQ(Tally::sum(tally.copies), 0) << Tally::list(tally.copies);
  EXPECT_EQ(Tally::sum(tally.allocations), 0) << Tally::list(tally.allocations);
  // beside what turns fluid, whether rock is out of its place; the sub-steps that are due come with it, and with them
  // as many looks
  EXPECT_LE(Tally::sum(tally.waits), 3 + looks_of_host(tally)) << Tally::list(tally.waits);
}

TEST_F(BudgetOfAStep, OfTheGuardsIsKept) {
  const Tally tally;
  simulation_.guard();
  EXPECT_LE(Tally::sum(tally.launches), 6) << Tally::list(tally.launches);
  EXPECT_LE(Tally::sum(tally.copies), 1) << Tally::list(tally.copies);
  EXPECT_LE(Tally::sum(tally.waits), 14) << Tally::list(tally.waits);
}

}  // namespace
}  // namespace vug
