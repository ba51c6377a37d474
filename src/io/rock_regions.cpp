#include "io/rock_regions.hpp"

#include "base/require.hpp"
#include "io/form.hpp"
#include "io/message.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace vug {

namespace {

std::vector<int> triangles_of_form(const Form& form, const Assembly& assembly) {
  std::vector<int> found;
  for (std::size_t t = 0; t < assembly.triangles.size(); ++t) {
    std::array<double, 2> centroid{0, 0};
    for (const int v : assembly.triangles[t])
      for (int axis = 0; axis < 2; ++axis) centroid[axis] += assembly.vertices[v][axis] / 3;
    if (holds(form, centroid, 0)) found.push_back(static_cast<int>(t));
  }
  return found;
}

std::vector<int> triangles_of_group(const std::string& group, const std::string& where, const Assembly& assembly) {
  const auto found = assembly.groups.find(group);
  if (found != assembly.groups.end()) return found->second;
  std::vector<std::string> known;
  for (const auto& [name, triangles] : assembly.groups) known.push_back(name);
  throw InputError(fmt::format("{}.group = \"{}\" is no named surface of rock.mesh; it has {}", where, excerpt(group),
                               known.empty() ? "none" : excerpt(fmt::format("{}", fmt::join(known, ", ")), 200)));
}

/// Triangles whose centroid lies in the mineral and in no later one.
std::vector<int> triangles_of_mineral(const std::string& name, const std::vector<MineralSection>& minerals,
                                      const std::string& what, const Assembly& assembly) {
  std::vector<bool> inside(assembly.triangles.size(), false);
  for (const MineralSection& mineral : minerals)
    for (const RockRegion& region : mineral.regions)
      for (const int t :
           region.form ? triangles_of_form(*region.form, assembly) : triangles_of_group(region.group, what, assembly))
        inside[static_cast<std::size_t>(t)] = mineral.name == name;
  std::vector<int> found;
  for (std::size_t t = 0; t < inside.size(); ++t)
    if (inside[t]) found.push_back(static_cast<int>(t));
  return found;
}

}  // namespace

std::vector<int> triangles_of_region(const RockRegion& region, const std::vector<MineralSection>& minerals,
                                     const std::string& what, const Assembly& assembly) {
  const std::vector<int> triangles = region.form ? triangles_of_form(*region.form, assembly)
                                     : region.mineral.empty()
                                         ? triangles_of_group(region.group, what, assembly)
                                         : triangles_of_mineral(region.mineral, minerals, what, assembly);
  if (triangles.empty()) throw InputError(what + " holds the centroid of no triangle");
  return triangles;
}

void assign_regions(const std::vector<RockRegion>& regions, const std::vector<MineralSection>& minerals,
                    const std::string& path, Assembly& assembly) {
  if (regions.empty()) return;
  assembly.region.assign(assembly.triangles.size(), 0);
  for (std::size_t r = 0; r < regions.size(); ++r) {
    const std::string what = fmt::format("{}: mechanics.material.{}", path, r);
    for (const int t : triangles_of_region(regions[r], minerals, what, assembly))
      assembly.region[static_cast<std::size_t>(t)] = static_cast<int>(r) + 1;
  }
}

}  // namespace vug
