#include "io/snapshot_writer.hpp"

#include "io/detail/snapshot_series.hpp"
#include "io/detail/xdmf.hpp"
#include "kernels/require.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace vug {

namespace {

using detail::Attribute;
using detail::Hdf5File;
using detail::StoredAs;
using detail::XdmfArray;

std::vector<double> values_of(const Field& field, std::size_t items) {
  std::vector<double> values(items * static_cast<std::size_t>(field.components));
  field.read(values);
  return values;
}

/// How a field lies in the file: vectors of the plane get a third component, which viewers need, of nothing.
struct Layout {
  std::vector<std::size_t> items;
  StoredAs type;
  bool compress;

  void write(Hdf5File::Group& group, const std::string& name, const Field& field,
             std::vector<Attribute> attributes) const {
    std::size_t count = 1;
    for (const auto side : items) count *= side;
    auto values = values_of(field, count);
    auto shape = items;
    if (field.components == 2) {
      std::vector<double> padded(3 * count, 0.0);
      for (std::size_t i = 0; i < count; ++i) std::copy_n(&values[2 * i], 2, &padded[3 * i]);
      values = std::move(padded);
      shape.push_back(3);
    } else if (field.components != 1) {
      shape.push_back(static_cast<std::size_t>(field.components));
    }
    attributes.push_back({"units", field.unit});
    group.write(name, shape, values, type, compress, attributes);
  }
};

std::vector<Field> selected(const std::vector<Field>& fields, const std::vector<std::string>& names) {
  if (names.empty()) return fields;
  std::vector<Field> out;
  std::copy_if(fields.begin(), fields.end(), std::back_inserter(out),
               [&names](const Field& f) { return std::find(names.begin(), names.end(), f.name) != names.end(); });
  return out;
}

void require_known(const FieldList& fields, const std::vector<std::string>& names) {
  std::set<std::string> known;
  for (const auto* list : {&fields.lattice, &fields.particles, &fields.bonds})
    for (const auto& field : *list) known.insert(field.name);
  for (const auto& name : names)
    if (!known.contains(name))
      throw InputError(
          fmt::format("output.fields: '{}' is not computed in this case; there are: {}", name, fmt::join(known, ", ")));
}

std::string attributes_of(Hdf5File& file, const std::string& h5_name, const std::string& group, int bytes) {
  std::string text;
  for (const auto& [name, shape] : file.datasets(group))
    if (name != "vertices")
      text += detail::xdmf_attribute(name, {fmt::format("{}:/{}/{}", h5_name, group, name), shape, false, bytes});
  return text;
}

int bytes_of(StoredAs type) {
  return type == StoredAs::float64 ? 8 : 4;
}

}  // namespace

/// fields.h5: cells of the lattice.
class SnapshotWriter::LatticeFile {
 public:
  LatticeFile(const std::string& directory, const Lattice& lattice, double spacing, std::vector<Field> fields,
              const Layout& layout)
      : spacing_(spacing),
        fields_(std::move(fields)),
        layout_(layout),
        series_(directory, "fields",
                [this](Hdf5File& f, const std::string& group, double t) { return grid(f, group, t); }) {
    layout_.items = {static_cast<std::size_t>(lattice.ny), static_cast<std::size_t>(lattice.nx)};
  }
  LatticeFile(const LatticeFile&) = delete;
  LatticeFile& operator=(const LatticeFile&) = delete;

  detail::SnapshotSeries& series() { return series_; }

  void write(double time, std::int64_t step) {
    series_.append(time, step, [&](Hdf5File::Group& group) {
      for (const auto& field : fields_)
        layout_.write(group, field.name, field,
                      {{"time", time}, {"step", step}, {"dx", spacing_}, {"origin", std::vector<double>{0, 0}}});
    });
  }

 private:
  std::string grid(Hdf5File& file, const std::string& group, double time) const {
    return fmt::format(
        "<Grid Name=\"lattice\" GridType=\"Uniform\">\n<Time Value=\"{}\"/>\n"
        "<Topology TopologyType=\"2DCoRectMesh\" Dimensions=\"{} {}\"/>\n<Geometry GeometryType=\"ORIGIN_DXDY\">\n"
        "<DataItem Dimensions=\"2\" NumberType=\"Float\" Precision=\"8\" Format=\"XML\">0 0</DataItem>\n"
        "<DataItem Dimensions=\"2\" NumberType=\"Float\" Precision=\"8\" Format=\"XML\">{} {}</DataItem>\n</Geometry>\n"
        "{}</Grid>\n",
        time, layout_.items[0] + 1, layout_.items[1] + 1, spacing_, spacing_,
        attributes_of(file, series_.h5_name(), group, bytes_of(layout_.type)));
  }

  double spacing_;
  std::vector<Field> fields_;
  Layout layout_;
  detail::SnapshotSeries series_;
};

/// particles.h5: triangles, each with vertices of its own, and bonds as lines.
class SnapshotWriter::RockFile {
 public:
  RockFile(const std::string& directory, const FieldList& fields, const std::vector<std::string>& names,
           const Layout& layout, RockShape shape)
      : shape_(std::move(shape)),
        triangle_fields_(selected(fields.particles, names)),
        bond_fields_(selected(fields.bonds, names)),
        layout_(layout),
        series_(directory, "particles",
                [this](Hdf5File& f, const std::string& group, double t) { return grid(f, group, t); }) {
    for (const auto& field : fields.particles) {
      if (field.name == "displacement" && field.components == 2) displacement_ = field;
      if (field.name == "rotation" && field.components == 1) rotation_ = field;
    }
  }
  RockFile(const RockFile&) = delete;
  RockFile& operator=(const RockFile&) = delete;

  detail::SnapshotSeries& series() { return series_; }

  // The part that never changes: which vertices make a triangle or a bond, and who they were in the assembly.
  void write_connectivity() {
    auto file = series_.open();
    Hdf5File::Group group(file, "rock", {});
    const auto put = [&](const std::string& name, std::size_t rows, std::size_t columns, auto value) {
      std::vector<double> values;
      for (std::size_t i = 0; i < rows; ++i)
        for (std::size_t k = 0; k < columns; ++k) values.push_back(value(i, k));
      group.write(name, {rows, columns}, values, StoredAs::int32, layout_.compress, {});
    };
    const auto& triangles = shape_.assembly.triangles;
    const auto& bonds = shape_.bonds;
    put("triangles", triangles.size(), 3, [](std::size_t i, std::size_t k) { return 3 * i + k; });
    put("bonds", bonds.size(), 2, [](std::size_t i, std::size_t k) { return 2 * i + k; });
    put("triangle_vertex_numbers", triangles.size(), 3, [&](std::size_t i, std::size_t k) { return triangles[i][k]; });
    put("bond_vertex_numbers", bonds.size(), 2, [&](std::size_t i, std::size_t k) { return bonds[i].vertices[k]; });
    put("bond_triangles", bonds.size(), 2, [&](std::size_t i, std::size_t k) { return bonds[i].particles[k]; });
    group.publish();
    file.close();
  }

  void write(double time, std::int64_t step) {
    const std::vector<Attribute> common{{"time", time}, {"step", step}};
    series_.append(time, step, [&](Hdf5File::Group& group) {
      const auto triangles = moved_vertices();
      const auto bonds = bond_ends(triangles);
      write_vertices(group, "triangles/vertices", triangles, common);
      write_vertices(group, "bonds/vertices", bonds, common);
      auto layout = layout_;
      layout.items = {shape_.assembly.triangles.size()};
      for (const auto& field : triangle_fields_) layout.write(group, "triangles/" + field.name, field, common);
      layout.items = {shape_.bonds.size()};
      for (const auto& field : bond_fields_) layout.write(group, "bonds/" + field.name, field, common);
    });
  }

 private:
  using Points = std::vector<std::array<double, 2>>;

  // x_k = X_c + u + Q (X_k - X_c) for the three vertices of every triangle.
  Points moved_vertices() const {
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

  // A bond is drawn midway between the two places where its triangles have carried each end.
  Points bond_ends(const Points& moved) const {
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

  void write_vertices(Hdf5File::Group& group, const std::string& name, const Points& points,
                      std::vector<Attribute> attributes) const {
    std::vector<double> values;
    values.reserve(3 * points.size());
    for (const auto& p : points) values.insert(values.end(), {p[0], p[1], 0.0});
    attributes.push_back({"units", std::string("m")});
    group.write(name, {points.size(), 3}, values, layout_.type, layout_.compress, attributes);
  }

  std::string part(Hdf5File& file, const std::string& group, const std::string& items, const std::string& topology,
                   std::size_t count, std::size_t corners) const {
    const auto& h5 = series_.h5_name();
    const int bytes = bytes_of(layout_.type);
    const XdmfArray connectivity{h5 + ":/rock/" + items, {count, corners}, true, 4};
    const XdmfArray vertices{fmt::format("{}:/{}/{}/vertices", h5, group, items), {corners * count, 3}, false, bytes};
    return fmt::format(
        "<Grid Name=\"{}\" GridType=\"Uniform\">\n<Topology {} NumberOfElements=\"{}\">\n{}</Topology>\n"
        "<Geometry GeometryType=\"XYZ\">\n{}</Geometry>\n{}</Grid>\n",
        items, topology, count, xdmf_item(connectivity), xdmf_item(vertices),
        attributes_of(file, h5, group + "/" + items, bytes));
  }

  std::string grid(Hdf5File& file, const std::string& group, double time) const {
    auto parts = part(file, group, "triangles", "TopologyType=\"Triangle\"", shape_.assembly.triangles.size(), 3);
    if (!shape_.bonds.empty())
      parts += part(file, group, "bonds", "TopologyType=\"Polyline\" NodesPerElement=\"2\"", shape_.bonds.size(), 2);
    return fmt::format(
        "<Grid Name=\"rock\" GridType=\"Collection\" CollectionType=\"Spatial\">\n<Time Value=\"{}\"/>\n{}</Grid>\n",
        time, parts);
  }

  RockShape shape_;
  std::vector<Field> triangle_fields_, bond_fields_;
  std::optional<Field> displacement_, rotation_;
  Layout layout_;
  detail::SnapshotSeries series_;
};

SnapshotWriter::SnapshotWriter(const std::string& directory, const Lattice& lattice, double spacing, FieldList fields,
                               const SnapshotOptions& options, std::optional<RockShape> rock) {
  require_known(fields, options.fields);
  const Layout layout{{}, options.double_precision ? StoredAs::float64 : StoredAs::float32, options.compress};
  lattice_ =
      std::make_unique<LatticeFile>(directory, lattice, spacing, selected(fields.lattice, options.fields), layout);
  if (rock) rock_ = std::make_unique<RockFile>(directory, fields, options.fields, layout, std::move(*rock));
  if (options.resume_step) {
    lattice_->series().resume(*options.resume_step);
    if (rock_) rock_->series().resume(*options.resume_step);
  } else {
    lattice_->series().create();
    if (rock_) {
      rock_->series().create();
      rock_->write_connectivity();
    }
  }
}

SnapshotWriter::~SnapshotWriter() = default;
SnapshotWriter::SnapshotWriter(SnapshotWriter&&) noexcept = default;
SnapshotWriter& SnapshotWriter::operator=(SnapshotWriter&&) noexcept = default;

void SnapshotWriter::write(double time, std::int64_t step) {
  lattice_->write(time, step);
  if (rock_) rock_->write(time, step);
}

}  // namespace vug
