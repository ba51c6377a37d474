#include "host/control_groups.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <system_error>

namespace vug {
namespace {

bool is_in(const std::string& list, std::string_view name) {
  return ("," + list + ",").find("," + std::string(name) + ",") != std::string::npos;
}

/// quota / period of a group, infinite without a quota.
double share_of(const ControlGroup& group) {
  double quota = 0, period = 0;
  if (group.unified) {
    std::ifstream(group.folder + "/cpu.max") >> quota >> period;  // or "max 100000", which is no number
  } else {
    std::ifstream(group.folder + "/cpu.cfs_quota_us") >> quota;  // -1 without one
    std::ifstream(group.folder + "/cpu.cfs_period_us") >> period;
  }
  return quota > 0 && period > 0 ? quota / period : std::numeric_limits<double>::infinity();
}

}  // namespace

std::vector<ControlGroup> control_groups(std::string_view controller, const ControlGroupFiles& files) {
  std::vector<ControlGroup> groups;
  std::ifstream list(files.list);
  std::string line;  // "4:memory:/path", "2:cpu,cpuacct:/path", or in version 2 "0::/path"
  while (std::getline(list, line)) {
    const auto first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    const bool unified = controllers.empty();
    if (!unified && !is_in(controllers, controller)) continue;
    std::string root = files.tree;
    if (!unified) {
      const std::string together = files.tree + "/" + controllers;
      std::error_code unknown;  // a folder that this process may not see counts as none
      const bool there = std::filesystem::exists(together, unknown);
      root = there ? together : files.tree + "/" + std::string(controller);
    }
    for (std::string path = line.substr(second + 1);; path.erase(path.rfind('/'))) {
      groups.push_back({root + path, unified});
      if (path.rfind('/') == std::string::npos) break;
    }
  }
  return groups;
}

int granted_processors(const ControlGroupFiles& files) {
  double least = std::numeric_limits<double>::infinity();
  for (const ControlGroup& group : control_groups("cpu", files)) least = std::min(least, share_of(group));
  constexpr double nobody_has_more = 1 << 20;
  return least < nobody_has_more ? static_cast<int>(std::ceil(least)) : 0;
}

}  // namespace vug
