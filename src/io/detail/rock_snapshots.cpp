#include "io/detail/rock_snapshots.hpp"

#include "io/detail/xdmf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::detail {

RockSnapshots::RockSnapshots(const std::string& directory, const FieldList& fields,
                             const std::vector<std::string>& names, FieldLayout layout, RockShape shape)
    : shape_(std::move(shape)),
      triangle_fields_(selected(fields.particles, names)),
      bond_fields_(selected(fields.bonds, names)),
      layout_(std::move(layout)),
      series_(directory, "particles",
              [this](const Hdf5File& file, const std::string& name, double time) { return grid(file, name, time); }) {
  for (const auto& field : fields.particles) {
    if (field.name == "displacement" && field.components == 2) displacement_ = field;
    if (field.name == "rotation" && field.components == 1) rotation_ = field;
  }
}

void RockSnapshots::create() {
  series_.create();
  add_connectivity();
}

std::vector<std::string> RockSnapshots::resume(std::int64_t step) {
  std::vector<std::string> damaged = series_.resume(step);
  add_connectivity();
  return damaged;
}

void RockSnapshots::add_connectivity() {
  series_.add_part("rock", [this](Hdf5File& file) { write_connectivity(file); });
}

void RockSnapshots::write_connectivity(Hdf5File& file) const {
  const auto put = [&](const std::string& name, std::size_t rows, std::size_t columns, auto value) {
    const auto read = [&](std::size_t first, std::span<double> values) {
      for (std::size_t i = 0; i < values.size(); ++i) values[i] = value(first + i / columns, i % columns);
    };
    file.write(name, {rows, columns}, read, StoredAs::int32, layout_.compress, {});
  };
  const auto& triangles = shape_.assembly.triangles;
  const auto& bonds = shape_.bonds;
  put("triangles", triangles.size(), 3, [](std::size_t i, std::size_t k) { return 3 * i + k; });
  put("bonds", bonds.size(), 2, [](std::size_t i, std::size_t k) { return 2 * i + k; });
  put("triangle_vertex_numbers", triangles.size(), 3, [&](std::size_t i, std::size_t k) { return triangles[i][k]; });
  put("bond_vertex_numbers", bonds.size(), 2, [&](std::size_t i, std::size_t k) { return bonds[i].vertices[k]; });
  put("bond_triangles", bonds.size(), 2, [&](std::size_t i, std::size_t k) { return bonds[i].particles[k]; });
}

void RockSnapshots::write(double time, std::int64_t step) {
  const std::vector<Attribute> common{{"time", time}, {"step", step}};
  series_.append(time, step, [&](Hdf5File& file) {
    const auto triangles = moved_vertices();
    const auto bonds = bond_ends(triangles);
    write_vertices(file, "triangles/vertices", triangles, common);
    write_vertices(file, "bonds/vertices", bonds, common);
    auto layout = layout_;
    layout.items = {shape_.assembly.triangles.size()};
    for (const auto& field : triangle_fields_) layout.write(file, "triangles/" + field.name, field, common);
    layout.items = {shape_.bonds.size()};
    for (const auto& field : bond_fields_) layout.write(file, "bonds/" + field.name, field, common);
  });
}

// x_k = X_c + u + Q (X_k - X_c) for the three vertices of every triangle.
RockSnapshots::Points RockSnapshots::moved_vertices() const {
  const auto& assembly = shape_.assembly;
  const auto count = assembly.triangles.size();
  const auto u = displacement_ ? values_of(*displacement_, count) : std::vector<double>(2 * count, 0.0);
  const auto angle = rotation_ ? values_of(*rotation_, count) : std::vector<double>(count, 0.0);
  Points out;
  out.reserve(3 * count);
  for (std::size_t t = 0; t < count; ++t) {
    std::array<double, 2> centre{0, 0};
    for (const int v : assembly.triangles[t])
      for (int axis = 0; axis < 2; ++axis) centre[axis] += assembly.vertices[v][axis] / 3;
    const double c = std::cos(angle[t]), s = std::sin(angle[t]);
    for (const int v : assembly.triangles[t]) {
      const double x = assembly.vertices[v][0] - centre[0], y = assembly.vertices[v][1] - centre[1];
      out.push_back({centre[0] + u[2 * t] + c * x - s * y, centre[1] + u[2 * t + 1] + s * x + c * y});
    }
  }
  return out;
}

// Ends of the bonds. A bond is drawn half way between the two positions to which its triangles have moved each end.
RockSnapshots::Points RockSnapshots::bond_ends(const Points& moved) const {
  Points out;
  out.reserve(2 * shape_.bonds.size());
  for (const auto& bond : shape_.bonds) {
    for (const int vertex : bond.vertices) {
      std::array<double, 2> middle{0, 0};
      for (const int particle : bond.particles) {
        const auto& corners = shape_.assembly.triangles[particle];
        const auto k = std::find(corners.begin(), corners.end(), vertex) - corners.begin();
        for (int axis = 0; axis < 2; ++axis) middle[axis] += moved[3 * particle + k][axis] / 2;
      }
      out.push_back(middle);
    }
  }
  return out;
}

void RockSnapshots::write_vertices(Hdf5File& file, const std::string& name, const Points& points,
                                   std::vector<Attribute> attributes) const {
  const auto read = [&](std::size_t first, std::span<double> values) {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = i % 3 < 2 ? points[first + i / 3][i % 3] : 0.0;
  };
  attributes.push_back({"units", std::string("m")});
  file.write(name, {points.size(), 3}, read, layout_.type, layout_.compress, attributes);
}

std::string RockSnapshots::part(const Hdf5File& file, const std::string& name, const std::string& items,
                                const std::string& topology, std::size_t count, std::size_t corners) const {
  const XdmfArray connectivity{series_.file_name("rock") + ":/" + items, {count, corners}, true};
  const XdmfArray vertices{fmt::format("{}:/{}/vertices", name, items), {corners * count, 3}};
  return fmt::format(
      "<Grid Name=\"{}\" GridType=\"Uniform\">\n<Topology {} NumberOfElements=\"{}\">\n{}</Topology>\n"
      "<Geometry GeometryType=\"XYZ\">\n{}</Geometry>\n{}</Grid>\n",
      items, topology, count, xdmf_item(connectivity), xdmf_item(vertices),
      xdmf_attributes(file, name, items, XdmfCentre::cell));
}

std::string RockSnapshots::grid(const Hdf5File& file, const std::string& name, double time) const {
  auto parts = part(file, name, "triangles", "TopologyType=\"Triangle\"", shape_.assembly.triangles.size(), 3);
  if (!shape_.bonds.empty())
    parts += part(file, name, "bonds", "TopologyType=\"Polyline\" NodesPerElement=\"2\"", shape_.bonds.size(), 2);
  return fmt::format(
      "<Grid Name=\"rock\" GridType=\"Collection\" CollectionType=\"Spatial\">\n<Time Value=\"{}\"/>\n{}</Grid>\n",
      time, parts);
}

}  // namespace vug::detail
