// What ranks trade, on as many as mpirun starts.
#include "kernels/launch/launch.hpp"
#include "ranks/halo.hpp"
#include "ranks/mpi.hpp"
#include "ranks/partition.hpp"
#include "ranks/traffic.hpp"
#include "support/overheard.hpp"
#include "world.hpp"

#include <Kokkos_Core.hpp>

#include <gtest/gtest.h>
#define OMPI_SKIP_MPICXX
#define MPICH_SKIP_MPICXX
#include <algorithm>
#include <chrono>
#include <mpi.h>
#include <numeric>
#include <sched.h>
#include <set>
#include <string>
#include <thread>

namespace vug {
namespace {

/// Whether a kernel that fills a message has ended and nobody has waited for it yet; and whether that was ever so when
/// messages started.
bool packed_unfenced = false, started_unfenced = false;
int packing_kernels = 0, starts = 0;

/// Kokkos itself fences for its tools.
bool is_wait(const char* label) {
  return std::string(label).find("Profile Tool Fence") == std::string::npos;
}

void watch_kernels(const test::Overheard& overheard) {
  static const test::Overheard* others;
  others = &overheard;
  using namespace Kokkos::Tools::Experimental;
  set_begin_parallel_for_callback([](const char* name, std::uint32_t device, std::uint64_t* id) {
    others->launched(name, device, id);
    if (std::string(name) != "vug::halo::pack") return;
    ++packing_kernels;
    packed_unfenced = true;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));  // a slow one
  });
  set_begin_fence_callback(
      [](const char* label, std::uint32_t, std::uint64_t*) { packed_unfenced = packed_unfenced && !is_wait(label); });
}

struct NumberSlots {
  ScalarField<double> values;
  double first;
  KOKKOS_FUNCTION void operator()(int i) const { values(i) = first + i; }
};

/// Ranks that a launcher has bound to different processors need not divide them.
TEST(Mpi, CountsTheRanksThatShareTheirProcessors) {
  cpu_set_t all, one;
  ASSERT_EQ(sched_getaffinity(0, sizeof all, &all), 0);
  std::vector<int> processors;
  for (int i = 0; i < CPU_SETSIZE; ++i)
    if (CPU_ISSET(i, &all)) processors.push_back(i);
  EXPECT_EQ(ranks_on_these_processors(world), world.size());
  if (world.least(static_cast<int>(processors.size())) < 2) GTEST_SKIP() << "there is one processor";
  const int group = world.rank() % 2;
  CPU_ZERO(&one);
  CPU_SET(processors[static_cast<std::size_t>(group)], &one);
  ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
  EXPECT_EQ(ranks_on_these_processors(world), (world.size() + 1 - group) / 2);
  ASSERT_EQ(sched_setaffinity(0, sizeof all, &all), 0);
}

/// Slots 0 ... count - 1, dealt out to the ranks in turn, three at a time.
int owner_of(int slot) {
  return slot / 3 % world.size();
}

constexpr int count = 100;

/// Every rank needs the slots whose number is a multiple of its own + 2.
std::vector<int> needed_by(int rank) {
  std::vector<int> slots;
  for (int s = 0; s < count; ++s)
    if (owner_of(s) != rank && s % (rank + 2) == 0) slots.push_back(s);
  return slots;
}

Halo make_halo() {
  std::vector<int> slots = needed_by(world.rank()), owners;
  for (const int s : slots) owners.push_back(owner_of(s));
  return Halo(world, slots, owners);
}

/// Slot s of rank r holds 1000 r + s.
ScalarField<double> numbered(double more = 0) {
  ScalarField<double> values("values", count);
  for_each_node(Exec{}, "number", count, NumberSlots{values, 1000.0 * world.rank() + more});
  return values;
}

TEST(Halo, BringsTheOwnersValuesAndTouchesNoOthers) {
  const Halo halo = make_halo();
  for (int again = 0; again < 3; ++again) {
    const ScalarField<double> a = numbered(again), b = numbered(0.5 + again);
    halo.exchange<double, 2>(Exec{}, {a, b});
    const std::vector<int> mine = needed_by(world.rank());
    const auto a_now = on_host(a), b_now = on_host(b);
    for (int s = 0; s < count; ++s) {
      const bool needed = std::find(mine.begin(), mine.end(), s) != mine.end();
      const double whose = needed ? owner_of(s) : world.rank();
      EXPECT_EQ(a_now(s), 1000.0 * whose + s + again);
      EXPECT_EQ(b_now(s), 1000.0 * whose + s + again + 0.5);
    }
  }
}

TEST(Halo, BringsBackWhatTheNeedyHold) {
  // every rank needs one slot of the next
  const int next = (world.rank() + 1) % world.size(), before = (world.rank() + world.size() - 1) % world.size();
  if (world.alone()) GTEST_SKIP() << "one rank";
  const Halo halo(world, {10 + next}, {next});
  const ScalarField<double> values = numbered();
  halo.exchange_back<double, 1>(Exec{}, {values});
  const auto now = on_host(values);
  EXPECT_EQ(now(10 + world.rank()), 1000.0 * before + 10 + world.rank());
  EXPECT_EQ(now(10 + next), 1000.0 * world.rank() + 10 + next);
}

TEST(Halo, IsEmptyWhereNothingIsNeeded) {
  const Halo none(world, {}, {}), absent;
  const ScalarField<double> values = numbered();
  none.exchange<double, 1>(Exec{}, {values});
  absent.exchange<double, 1>(Exec{}, {values});
  EXPECT_EQ(on_host(values)(7), 1000.0 * world.rank() + 7);
  EXPECT_EQ(none.taken(), 0);
}

TEST(Halo, WaitsForASlowPackingKernelBeforeItSends) {
  const test::Overheard overheard;
  watch_kernels(overheard);
  packing_kernels = starts = 0;
  started_unfenced = false;
  const Halo halo = make_halo();
  halo.exchange<double, 1>(Exec{}, {numbered()});
  if (world.size() > 2) {
    EXPECT_GT(packing_kernels, 0);
    EXPECT_GT(starts, 0);
  }
  EXPECT_FALSE(started_unfenced);
}

int waits = 0;

TEST(Halo, WaitsOnceInAnExchangeAndNeverWithoutNeighbours) {
  const Halo halo = make_halo(), none(world, {}, {});
  const ScalarField<double> values = numbered();
  for (const Halo* each : {&halo, &none}) each->exchange<double, 1>(Exec{}, {values});  // makes its buffers
  const test::Overheard overheard;
  Kokkos::Tools::Experimental::set_begin_fence_callback(
      [](const char* label, std::uint32_t, std::uint64_t*) { waits += is_wait(label); });
  for (const Halo* each : {&halo, &none}) {
    waits = 0;
    each->exchange<double, 1>(Exec{}, {values});
    EXPECT_EQ(waits, each == &halo && world.size() > 1 ? 1 : 0);
  }
}

/// That of the phase; none where nothing was counted in it.
Traffic traffic_of(const std::string& phase) {
  for (const Traffic& found : traffic())
    if (found.phase == phase) return found;
  return {};
}

TEST(Traffic, IsWhatComesFromOthersInAPhase) {
  const Halo halo = make_halo();
  std::vector<int> owner(count);
  const IndexList values("values", count);
  std::set<int> neighbours;
  for (int s = 0; s < count; ++s) owner[s] = owner_of(s);
  for (const int s : needed_by(world.rank())) neighbours.insert(owner_of(s));
  {
    const Phase phase(world, "of the test");
    halo.exchange<double, 3>(Exec{}, {numbered(), numbered(1), numbered(2)});
    const Phase within(world, "within it");
    world.make_whole(owners_of(owner, world.size()), values.data());
  }
  halo.exchange<double, 1>(Exec{}, {numbered()});  // belongs to no phase
  const Traffic found = traffic_of("of the test"), within = traffic_of("within it");
  EXPECT_EQ(found.messages, static_cast<int>(neighbours.size()));
  EXPECT_EQ(found.bytes, halo.taken() * 24);
  EXPECT_EQ(found.collectives, 0);
  EXPECT_EQ(within.messages, 0);
  EXPECT_EQ(within.collectives, world.alone() ? 0 : 1);
  const auto ours = std::count(owner.begin(), owner.end(), world.rank());
  EXPECT_EQ(within.collected, world.alone() ? 0 : (count - ours) * 4);
  EXPECT_LE(found.waited, found.passed);
  EXPECT_EQ(found.passed > 0, !world.alone());
  const std::vector<std::string> table = traffic_table(world, 1);
  EXPECT_EQ(table.empty(), !world.first());
  const auto told = [&](const std::string& line) { return line.starts_with("of the test"); };
  EXPECT_EQ(std::any_of(table.begin(), table.end(), told), world.first() && !world.alone());
}

TEST(Ranks, MakeAnArrayWholeFromItsOwners) {
  std::vector<int> owner(count), own(count, -1);
  for (int s = 0; s < count; ++s) {
    owner[s] = owner_of(s);
    if (owner[s] == world.rank()) own[s] = 7 * s;
  }
  const auto values = to_device<IndexList>("values", own);
  world.make_whole(owners_of(owner, world.size()), values.data());
  const auto whole = on_host(values);
  for (int s = 0; s < count; ++s) EXPECT_EQ(whole(s), 7 * s);
}

TEST(Ranks, BringAnArrayToTheFirstFromItsOwners) {
  std::vector<int> owner(count);
  for (int i = 0; i < count; ++i) owner[i] = owner_of(i);
  std::vector<double> values(count, -1);
  for (int i = 0; i < count; ++i)
    if (owner[i] == world.rank()) values[i] = 7 * i;
  const Owners owners = owners_of(owner, world.size());
  std::vector<double> whole(count, -2);
  constexpr int first = 10, last = count - 4;  // a part of it, which cuts what owners have
  world.bring(owners, first, last, sizeof(double), &values[first], &whole[first]);
  for (int i = 0; i < count; ++i) {
    const bool brought = world.first() && owner[i] > 0 && i >= first && i < last;
    EXPECT_EQ(whole[i], brought ? 7 * i : -2) << i;
  }
}

TEST(Ranks, AgreeAndTell) {
  EXPECT_EQ(world.most(world.rank() + 3), world.size() + 2);
  EXPECT_EQ(world.least(world.rank() + 3), 3);
  EXPECT_EQ(world.most(0.5 * world.rank()), 0.5 * (world.size() - 1));
  EXPECT_EQ(world.least(0.5 - world.rank()), 1.5 - world.size());
  EXPECT_EQ(world.told(world.first() ? "the first one's words" : "x"), "the first one's words");
  const std::vector<std::string> all = world.told_by_all("I am " + std::to_string(world.rank()));
  ASSERT_EQ(all.size(), world.first() ? world.size() : 0);
  for (std::size_t r = 0; r < all.size(); ++r) EXPECT_EQ(all[r], "I am " + std::to_string(r));
}

TEST(Partition, CutsRowsWhereTheirWeightsAreHalved) {
  const Partition even(std::vector<double>(12, 1.0), 3);
  EXPECT_EQ(even.first(1), 4);
  EXPECT_EQ(even.first(2), 8);
  EXPECT_DOUBLE_EQ(even.imbalance(), 1);
  const Partition heavy({8, 1, 1, 1, 1, 1, 1, 2}, 2);
  EXPECT_EQ(heavy.last(0), 1);
  EXPECT_EQ(heavy.part_of(0), 0);
  EXPECT_EQ(heavy.part_of(1), 1);
}

TEST(Partition, GivesEveryRowToOnePartAlsoWhereThereAreMoreParts) {
  for (const int parts : {1, 2, 3, 4, 7, 16}) {
    for (const std::vector<double>& weights :
         {std::vector<double>{1, 2, 3}, std::vector<double>(5, 0.0), std::vector<double>{0, 0, 9, 0, 0, 0, 1}}) {
      const Partition p(weights, parts);
      const int rows = static_cast<int>(weights.size());
      ASSERT_EQ(p.parts(), parts);
      EXPECT_EQ(p.first(0), 0);
      EXPECT_EQ(p.last(parts - 1), rows);
      for (int k = 0; k < parts; ++k) EXPECT_LE(p.first(k), p.last(k));
      for (int y = 0; y < rows; ++y) {
        EXPECT_LE(p.first(p.part_of(y)), y);
        EXPECT_GT(p.last(p.part_of(y)), y);
      }
    }
  }
}

}  // namespace
}  // namespace vug

/// Stands before the library's: looks whether what is sent has been waited for.
extern "C" int MPI_Startall(int count, MPI_Request requests[]) {
  vug::starts += count > 0;
  vug::started_unfenced = vug::started_unfenced || vug::packed_unfenced;
  return PMPI_Startall(count, requests);
}

int main(int argc, char** argv) {
  const vug::Mpi mpi;
  vug::world = mpi.world();
  Kokkos::ScopeGuard kokkos(argc, argv);
  ::testing::InitGoogleTest(&argc, argv);
  const int failed = RUN_ALL_TESTS();
  return vug::world.most(failed);
}
