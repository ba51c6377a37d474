// What control groups grant, of trees of files like those of either version.
#include "host/control_groups.hpp"

#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace vug {
namespace {

/// A tree of control groups, and the list of those of a process.
struct Groups {
  explicit Groups(const std::string& list) { put("list", list); }
  void put(const std::string& path, const std::string& text) const {
    const std::filesystem::path file = folder / path;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << text;
  }
  int granted() const { return granted_processors({folder / "list", folder / "tree"}); }
  test::TemporaryFolder folder;
};

TEST(ControlGroups, OfVersionTwoGrantTheLeastQuotaOfAll) {
  const Groups groups("0::/slice/job/step\n");
  EXPECT_EQ(groups.granted(), 0) << "no group is visible";
  groups.put("tree/slice/job/step/cpu.max", "max 100000\n");
  EXPECT_EQ(groups.granted(), 0);
  groups.put("tree/slice/job/cpu.max", "250000 100000\n");
  EXPECT_EQ(groups.granted(), 3) << "two and a half, rounded up";
  groups.put("tree/slice/cpu.max", "100000 50000\n");
  EXPECT_EQ(groups.granted(), 2);
  groups.put("tree/slice/job/step/cpu.max", "20000 100000\n");
  EXPECT_EQ(groups.granted(), 1) << "a fifth";
  groups.put("tree/slice/other/cpu.max", "1000 100000\n");
  EXPECT_EQ(groups.granted(), 1);
  groups.put("tree/slice/job/step/cpu.max", "nonsense\n");
  EXPECT_EQ(groups.granted(), 2);
}

TEST(ControlGroups, OfAContainerLieAtTheRoot) {
  const Groups groups("0::/\n");
  groups.put("tree/cpu.max", "400000 100000\n");
  EXPECT_EQ(groups.granted(), 4);
}

TEST(ControlGroups, OfVersionOneGrantTheQuotaOfTheirController) {
  // docker without a name space of groups: the path is that of the machine, the files are those of the container
  const Groups groups("5:memory:/docker/1\n3:cpuset:/docker/1\n2:cpu,cpuacct:/docker/1\n0::/docker/1\n");
  groups.put("tree/cpu/cpu.cfs_period_us", "100000\n");
  groups.put("tree/cpu/cpu.cfs_quota_us", "-1\n");
  EXPECT_EQ(groups.granted(), 0);
  groups.put("tree/cpu/docker/1/cpu.cfs_period_us", "100000\n");
  groups.put("tree/cpu/docker/1/cpu.cfs_quota_us", "-1\n");  // none of its own
  groups.put("tree/cpu/cpu.cfs_quota_us", "150000\n");
  EXPECT_EQ(groups.granted(), 2);
  groups.put("tree/cpuset/cpu.cfs_quota_us", "50000\n");
  groups.put("tree/cpuset/cpu.cfs_period_us", "100000\n");
  EXPECT_EQ(groups.granted(), 2) << "of another controller";
  groups.put("tree/cpu,cpuacct/docker/1/cpu.cfs_quota_us", "50000\n");
  groups.put("tree/cpu,cpuacct/docker/1/cpu.cfs_period_us", "100000\n");
  EXPECT_EQ(groups.granted(), 1) << "mounted by the names of both";
}

/// A name that is too long for a folder, as one that may not be looked at, is no folder; it does not end the program.
TEST(ControlGroups, ThatCannotBeLookedAtGrantNothing) {
  const Groups groups("2:cpu," + std::string(300, 'x') + ":/a\n");
  EXPECT_EQ(groups.granted(), 0);
  groups.put("tree/cpu/a/cpu.cfs_period_us", "100000\n");
  groups.put("tree/cpu/a/cpu.cfs_quota_us", "200000\n");
  EXPECT_EQ(groups.granted(), 2);
}

TEST(ControlGroups, AreListedFromOwnToRoot) {
  const Groups groups("4:hugetlb,memory:/a/b\n7:cpu:/c\n0::/d\n");
  std::vector<std::string> folders;
  const std::string tree = groups.folder / "tree";
  for (const ControlGroup& group : control_groups("memory", {groups.folder / "list", tree})) {
    EXPECT_EQ(group.unified, group.folder.find("memory") == std::string::npos);
    folders.push_back(group.folder.substr(tree.size()));
  }
  EXPECT_EQ(folders, (std::vector<std::string>{"/memory/a/b", "/memory/a", "/memory", "/d", ""}));
}

}  // namespace
}  // namespace vug
