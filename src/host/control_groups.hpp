#pragma once
// The control groups of a process: what a container or a batch system lets it have of a machine.
#include <string>
#include <string_view>
#include <vector>

namespace vug {

/// Where the system says which groups a process is in, and where their files are.
struct ControlGroupFiles {
  std::string list = "/proc/self/cgroup";
  std::string tree = "/sys/fs/cgroup";
};

struct ControlGroup {
  std::string folder;
  bool unified = false;  ///< version 2, in which all controllers have one tree
};

/// Groups of a controller ("memory", "cpu") in which this process is, in either version, from its own up to the root.
/// The folders of some may not be visible to it.
std::vector<ControlGroup> control_groups(std::string_view controller, const ControlGroupFiles& files = {});

/// Number of processors whose time these groups grant together: the least of quota / period over all groups of the
/// process, rounded up; 0 where nothing limits it. Threads beyond it are stopped for a part of every period (100 ms).
int granted_processors(const ControlGroupFiles& files = {});

}  // namespace vug
