// Of a list in groups every item of those that run is visited, once, whatever runs and whoever else shares the launch.
#include "dem/launch_in_turn.hpp"

#include "support/host_copy.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace vug {

/// Notes a visit; the second of two bodies doubles what the first has left.
struct Visit {
  Kokkos::View<int*> visits;
  KOKKOS_FUNCTION void operator()(int i) const { visits(i) += 1; }
};
struct Double {
  Kokkos::View<int*> visits;
  KOKKOS_FUNCTION void operator()(int i) const { visits(i) *= 2; }
};

namespace {

/// A list of `count` items in groups of eight, of which those run that `runs(group)` names.
template <class Runs>
Groups groups_of(int count, const Runs& runs) {
  Groups groups{count, 8, Kokkos::View<std::uint8_t*>("runs", (count + 7) / 8), {}};
  const auto host = Kokkos::create_mirror_view(groups.runs);
  for (std::size_t g = 0; g < host.extent(0); ++g) host(g) = runs(static_cast<int>(g)) ? 1 : 0;
  Kokkos::deep_copy(groups.runs, host);
  return groups;
}

/// Groups that run: none, all, one end, one in seven, a stretch.
std::vector<Groups> some_groups(int count) {
  const int last = (count + 7) / 8 - 1;
  return {groups_of(count, [](int) { return false; }),
          groups_of(count, [](int) { return true; }),
          groups_of(count, [](int g) { return g == 0; }),
          groups_of(count, [last](int g) { return g == last; }),
          groups_of(count, [](int g) { return g % 7 == 3; }),
          groups_of(count, [last](int g) { return g > last / 3 && g < last / 2; })};
}

/// By one thread and by several, each of which takes a share.
std::vector<Exec> some_execs() {
#if defined(KOKKOS_ENABLE_OPENMP)
  return {Exec(1), Exec(2), Exec(3), Exec(4)};
#else
  return {Exec()};  // elsewhere there is no number of threads to choose
#endif
}

void expect_each(const Groups& groups, const Kokkos::View<int*>& visits, int times) {
  const auto runs = test::host_copy(groups.runs);
  const auto seen = test::host_copy(visits);
  for (int i = 0; i < groups.count; ++i)
    EXPECT_EQ(seen(i), runs(i / 8) != 0 ? times : 0) << "item " << i << " of " << groups.count;
}

TEST(GroupsInTurn, VisitEveryItemOfWhatRunsOnce) {
  for (const Exec& exec : some_execs())
    for (const int count : {1, 8, 13, 700, 2000, 17001})
      for (const Groups& groups : some_groups(count)) {
        const Kokkos::View<int*> visits("visits", count);
        launch(Queue(exec), "in turn", in_turn(exec, groups, Visit{visits}, Double{visits}));
        expect_each(groups, visits, 2);
      }
}

TEST(GroupsInTurn, VisitEveryItemBesideAnotherList) {
  for (const Exec& exec : some_execs())
    for (const int others : {0, 1, 40, 5000})
      for (const Groups& groups : some_groups(3001)) {
        const Kokkos::View<int*> visits("visits", groups.count), other("other", others);
        launch(Queue(exec), "beside", side_by_side(each(exec, groups, Visit{visits}), each(others, Visit{other})));
        expect_each(groups, visits, 1);
        expect_each(groups_of(others, [](int) { return true; }), other, 1);
      }
}

/// Shares of so many blocks that their number times that of the share is beyond an int, as of 30 million bonds.
TEST(Shares, OfLongListsAreEachPartOnce) {
  for (const auto& [count, shares] : {std::pair{60000, 60000}, {50000, 60000}, {2000000000, 16}, {7, 3}}) {
    EXPECT_EQ(begin_of_share(count, 0, shares), 0);
    EXPECT_EQ(begin_of_share(count, shares, shares), count);
    for (int share = 0; share < shares; ++share) {
      const int parts = begin_of_share(count, share + 1, shares) - begin_of_share(count, share, shares);
      ASSERT_GE(parts, count / shares) << share;
      ASSERT_LE(parts, count / shares + 1) << share;
    }
  }
}

TEST(GroupsInTurn, LeaveToOthersWhatIsNotOurs) {
  Groups groups = groups_of(5000, [](int g) { return g % 3 != 0; });
  groups.ours = groups_of(5000, [](int g) { return g % 2 == 0; }).runs;
  for (const Exec& exec : some_execs()) {
    const Kokkos::View<int*> visits("visits", groups.count);
    launch(Queue(exec), "ours", each(exec, groups, Visit{visits}));
    expect_each(groups_of(5000, [](int g) { return g % 3 != 0 && g % 2 == 0; }), visits, 1);
  }
}

}  // namespace
}  // namespace vug
