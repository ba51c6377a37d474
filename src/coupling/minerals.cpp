#include "coupling/minerals.hpp"

#include "base/require.hpp"
#include "coupling/geometry.hpp"
#include "io/rock_regions.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace vug {

namespace {

/// Gives the nodes of a region the number of its mineral.
void paint(const RockRegion& region, const std::string& what, const Scene& scene, const TriangleOfNodes* triangles,
           std::uint8_t number, std::vector<std::uint8_t>& mineral) {
  if (region.form) return for_each_node_in(*region.form, scene.lattice, [&](std::size_t n) { mineral[n] = number; });
  std::vector<bool> inside(triangles->assembly.triangles.size(), false);
  for (const int t : triangles_of_region(region, scene.minerals, what, triangles->assembly))
    inside[static_cast<std::size_t>(t)] = true;
  for (std::size_t n = 0; n < mineral.size(); ++n)
    if (const int t = triangles->owner[n]; t >= 0 && inside[static_cast<std::size_t>(t)]) mineral[n] = number;
}

/// Whether labels of a picture have the mineral, so that other pictures of a stack may hold it.
bool has_labels(const Scene& scene, std::size_t mineral) {
  const auto& labels = scene.geometry.image.minerals;
  return std::any_of(labels.begin(), labels.end(), [&](const auto& entry) { return entry.second == mineral + 1; });
}

}  // namespace

std::vector<std::string> remarks_on_absent_minerals(const Scene& scene, const Kokkos::View<std::uint8_t*>& field) {
  std::vector<std::string> remarks;
  if (scene.minerals.empty()) return remarks;
  const auto mineral = on_host(field);
  std::vector<bool> present(scene.minerals.size() + 1);
  for (std::size_t n = 0; n < mineral.extent(0); ++n) present[mineral(n)] = true;
  for (std::size_t m = 0; m < scene.minerals.size(); ++m)
    if (!present[m + 1])
      remarks.push_back(
          fmt::format("mineral.{}: no node of rock is \"{}\": the picture has none of its labels, or cells of "
                      "several pixels have more of others",
                      m, scene.minerals[m].name));
  return remarks;
}

std::vector<std::uint8_t> mineral_of_nodes(const Scene& scene, const std::vector<bool>& solid,
                                           std::vector<std::uint8_t> of_label, const TriangleOfNodes* triangles) {
  if (scene.minerals.empty()) return {};
  std::vector<std::uint8_t> mineral = std::move(of_label);
  mineral.resize(solid.size(), 0);
  for (std::size_t m = 0; m < scene.minerals.size(); ++m)
    for (std::size_t r = 0; r < scene.minerals[m].regions.size(); ++r)
      paint(scene.minerals[m].regions[r], fmt::format("{}: mineral.{}.shapes.{}", scene.path, m, r), scene, triangles,
            static_cast<std::uint8_t>(m + 1), mineral);
  for (std::size_t n = 0; n < mineral.size(); ++n)
    if (!solid[n]) mineral[n] = 0;
  for (std::size_t m = 0; m < scene.minerals.size(); ++m)
    if (std::find(mineral.begin(), mineral.end(), m + 1) == mineral.end() && !has_labels(scene, m))
      throw InputError(
          fmt::format("{}: mineral.{}: no node of rock is left to \"{}\": its shapes and labels hold none, or later "
                      "minerals paint over it",
                      scene.path, m, scene.minerals[m].name));
  return mineral;
}

Kokkos::View<std::uint8_t*> mineral_field(const Lattice& lattice, const std::vector<std::uint8_t>& mineral) {
  if (mineral.empty()) return {};
  const Kokkos::View<std::uint8_t*> field("vug::minerals::of_node", lattice.size());
  const HostWriter host(field);
  for (std::size_t n = 0; n < mineral.size(); ++n)
    host(lattice.node(static_cast<int>(n) % lattice.nx, static_cast<int>(n) / lattice.nx)) = mineral[n];
  return field;
}

std::vector<std::string> mineral_names(const Scene& scene) {
  std::vector<std::string> names{"rock"};
  for (const MineralSection& mineral : scene.minerals) names.push_back(mineral.name);
  return names;
}

}  // namespace vug
