#include "io/mesh_reader.hpp"

#include "base/require.hpp"
#include "io/assembly_quality.hpp"
#include "io/detail/input_file.hpp"
#include "io/detail/mesh_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace vug {

namespace {

// Makes the assembly: triangles counter-clockwise, and the nodes that they use, in the order of the file.
Assembly assemble(const detail::RawMesh& mesh, const std::string& path) {
  std::vector<int> number(mesh.nodes.size(), -1);
  for (const auto& t : mesh.triangles)
    for (const int node : t) number[node] = 0;
  Assembly assembly;
  assembly.groups = mesh.groups;
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] < 0) continue;
    number[i] = static_cast<int>(assembly.vertices.size());
    assembly.vertices.push_back({mesh.nodes[i][0], mesh.nodes[i][1]});
    if (mesh.nodes[i][2] != mesh.nodes[mesh.triangles[0][0]][2])
      throw InputError(path + ": the mesh does not lie in a plane of constant z");
  }
  for (const auto& t : mesh.triangles) {
    std::array<int, 3> corner{number[t[0]], number[t[1]], number[t[2]]};
    const auto &a = assembly.vertices[corner[0]], &b = assembly.vertices[corner[1]], &c = assembly.vertices[corner[2]];
    if ((b[0] - a[0]) * (c[1] - a[1]) < (b[1] - a[1]) * (c[0] - a[0])) std::swap(corner[1], corner[2]);
    assembly.triangles.push_back(corner);
  }
  std::map<std::array<int, 2>, int> uses;
  for (const auto& t : assembly.triangles)
    for (int k = 0; k < 3; ++k) ++uses[{std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])}];
  for (const auto& crack : mesh.cracks) {
    const std::array<int, 2> edge{std::min(number[crack[0]], number[crack[1]]),
                                  std::max(number[crack[0]], number[crack[1]])};
    const auto found = uses.find(edge);
    if (found == uses.end() || found->second != 2)
      throw InputError(path +
                       ": a line of group \"crack\" or \"notch\" is not an edge between two triangles; embed it in "
                       "the surface (Line{...} In Surface{...})");
    assembly.initial_cracks.push_back(edge);
  }
  return assembly;
}

}  // namespace

Assembly parse_mesh(const std::string& content, const std::string& path) {
  detail::MeshText text(content, path);
  const auto mesh = detail::read_sections(text);
  if (mesh.triangles.empty()) throw InputError(path + ": the mesh has no triangles");
  for (const auto& [tag, name] : mesh.crack_groups)
    if (!mesh.found_groups.contains(tag))
      throw InputError(
          fmt::format("{}: the physical group \"{}\" (tag {}) has no line of the mesh; make it of the curves "
                      "that are to be cracks, or leave it out",
                      path, name, tag));
  auto assembly = assemble(mesh, path);
  require_usable(assembly, {10, 1e-3, 1}, path);
  return assembly;
}

Assembly read_mesh(const std::string& path) {
  return parse_mesh(detail::read_input_file(path), path);
}

}  // namespace vug
