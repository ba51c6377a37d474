#include "io/detail/mesh_sections.hpp"

#include "io/message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace vug::detail {

namespace {

constexpr int line_element = 1, triangle_element = 2, point_element = 15;

void read_physical_names(MeshText& text, RawMesh& mesh) {
  const auto count = text.count();
  for (std::int64_t i = 0; i < count; ++i) {
    const auto dimension = text.integer();
    const auto tag = text.integer();
    const auto name = text.quoted();
    if (dimension == 1 && (name == "crack" || name == "notch")) mesh.crack_groups[tag] = name;
    if (dimension == 2) mesh.surface_groups[tag] = name;
  }
}

void add_node(MeshText& text, RawMesh& mesh, std::int64_t tag, const std::array<double, 3>& position) {
  if (!mesh.number.emplace(tag, static_cast<int>(mesh.nodes.size())).second)
    text.fail(fmt::format("node {} is defined twice", tag));
  mesh.nodes.push_back(position);
}

std::array<double, 3> read_position(MeshText& text) {
  const double x = text.number(), y = text.number();
  return {x, y, text.number()};
}

int read_node_number(MeshText& text, const RawMesh& mesh) {
  const auto tag = text.integer();
  const auto found = mesh.number.find(tag);
  if (found == mesh.number.end()) text.fail(fmt::format("node {} is not defined", tag));
  return found->second;
}

/// Physical group of a tag; the tag is negative where the group contains the curve or surface in reversed direction.
std::int64_t group_of(std::int64_t tag) {
  return tag < 0 && tag > std::numeric_limits<std::int64_t>::min() ? -tag : tag;
}

// Reads the nodes of one element whose type and tags have been read. `crack_groups` are those of a line, `surfaces` the
// names of the surfaces of a triangle.
void read_element(MeshText& text, RawMesh& mesh, std::int64_t type, const std::set<std::int64_t>& crack_groups,
                  const std::set<std::string>& surfaces) {
  if (type == point_element) {
    text.skip(1);
  } else if (type == line_element) {
    const int a = read_node_number(text, mesh), b = read_node_number(text, mesh);
    if (crack_groups.empty()) return;
    mesh.cracks.push_back({a, b});
    mesh.found_groups.insert(crack_groups.begin(), crack_groups.end());
  } else if (type == triangle_element) {
    const int a = read_node_number(text, mesh), b = read_node_number(text, mesh);
    const std::array<int, 3> corners{a, b, read_node_number(text, mesh)};
    std::array<int, 3> sorted = corners;
    std::sort(sorted.begin(), sorted.end());
    // format 2.2 repeats an element for every physical group that it belongs to
    const auto [known, is_new] = mesh.triangle_of.emplace(sorted, static_cast<int>(mesh.triangles.size()));
    for (const std::string& name : surfaces) mesh.groups[name].push_back(known->second);
    if (is_new) mesh.triangles.push_back(corners);
  } else {
    text.fail(fmt::format("element type {} is not supported; mesh with triangles of first order", type));
  }
}

void read_nodes_2(MeshText& text, RawMesh& mesh) {
  const auto count = text.count();
  for (std::int64_t i = 0; i < count; ++i) {
    const auto tag = text.integer();
    add_node(text, mesh, tag, read_position(text));
  }
}

void read_elements_2(MeshText& text, RawMesh& mesh) {
  const auto count = text.count();
  for (std::int64_t i = 0; i < count; ++i) {
    text.skip(1);
    const auto type = text.integer();
    const auto tags = text.count();
    const auto physical = tags > 0 ? group_of(text.integer()) : 0;
    text.skip(tags - 1);
    std::set<std::int64_t> cracks;
    if (mesh.crack_groups.contains(physical)) cracks.insert(physical);
    std::set<std::string> surfaces;
    if (mesh.surface_groups.contains(physical)) surfaces.insert(mesh.surface_groups[physical]);
    read_element(text, mesh, type, cracks, surfaces);
  }
}

void read_entities_4(MeshText& text, RawMesh& mesh) {
  const std::array<std::int64_t, 4> counts{text.count(), text.count(), text.count(), text.count()};
  for (int dimension = 0; dimension < 4; ++dimension) {
    for (std::int64_t i = 0; i < counts[dimension]; ++i) {
      const auto tag = text.integer();
      text.skip(dimension == 0 ? 3 : 6);  // a point or a bounding box
      const auto groups = text.count();
      for (std::int64_t k = 0; k < groups; ++k) {
        const auto group = group_of(text.integer());
        if (mesh.crack_groups.contains(group) && dimension == 1) mesh.crack_groups_of_curve[tag].insert(group);
        if (mesh.surface_groups.contains(group) && dimension == 2)
          mesh.groups_of_surface[tag].insert(mesh.surface_groups[group]);
      }
      if (dimension > 0) text.skip(text.count());  // its boundary
    }
  }
}

void read_nodes_4(MeshText& text, RawMesh& mesh) {
  const auto blocks = text.count();
  text.skip(3);
  for (std::int64_t block = 0; block < blocks; ++block) {
    text.skip(2);
    if (text.integer() != 0) text.fail("parametric nodes are not supported; mesh without Mesh.SaveParametric");
    std::vector<std::int64_t> tags(static_cast<std::size_t>(text.count()));
    for (auto& tag : tags) tag = text.integer();
    for (const auto tag : tags) add_node(text, mesh, tag, read_position(text));
  }
}

void read_elements_4(MeshText& text, RawMesh& mesh) {
  const auto blocks = text.count();
  text.skip(3);
  for (std::int64_t block = 0; block < blocks; ++block) {
    const auto dimension = text.integer();
    const auto entity = text.integer();
    const auto type = text.integer();
    const auto count = text.count();
    const auto groups = mesh.crack_groups_of_curve.find(entity);
    const bool crack = dimension == 1 && groups != mesh.crack_groups_of_curve.end();
    const std::set<std::int64_t> cracks = crack ? groups->second : std::set<std::int64_t>{};
    const auto named = mesh.groups_of_surface.find(entity);
    const bool surface = dimension == 2 && named != mesh.groups_of_surface.end();
    const std::set<std::string> surfaces = surface ? named->second : std::set<std::string>{};
    for (std::int64_t i = 0; i < count; ++i) {
      text.skip(1);
      read_element(text, mesh, type, cracks, surfaces);
    }
  }
}

void read_format(MeshText& text, int& format) {
  text.expect("$MeshFormat");
  const auto version = std::string(text.word());
  if (version != "2.2" && version != "4.1")
    text.fail(fmt::format("mesh format {} is not supported; save as version 2.2 or 4.1 (gmsh -format msh41)",
                          excerpt(version)));
  format = version == "2.2" ? 2 : 4;
  if (text.integer() != 0) text.fail("a binary mesh is not supported; save as ASCII (gmsh without -bin)");
  text.skip(1);
  text.expect("$EndMeshFormat");
}

}  // namespace

RawMesh read_sections(MeshText& text) {
  int format = 0;
  RawMesh mesh;
  read_format(text, format);
  while (!text.at_end()) {
    const std::string section(text.word());
    if (section.size() < 2 || section[0] != '$')
      text.fail(fmt::format("found '{}', expected a section ($Nodes, ...)", excerpt(section)));
    const std::string end = "$End" + section.substr(1);
    if (section == "$PhysicalNames")
      read_physical_names(text, mesh);
    else if (section == "$Entities" && format == 4)
      read_entities_4(text, mesh);
    else if (section == "$Nodes")
      format == 2 ? read_nodes_2(text, mesh) : read_nodes_4(text, mesh);
    else if (section == "$Elements")
      format == 2 ? read_elements_2(text, mesh) : read_elements_4(text, mesh);
    else {
      text.skip_past(end);
      continue;
    }
    text.expect(end);
  }
  return mesh;
}

}  // namespace vug::detail
