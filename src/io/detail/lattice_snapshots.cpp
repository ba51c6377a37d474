#include "io/detail/lattice_snapshots.hpp"

#include <fmt/format.h>

namespace vug::detail {

LatticeSnapshots::LatticeSnapshots(const std::string& directory, const Lattice& lattice, double spacing,
                                   std::vector<Field> fields, FieldLayout layout)
    : spacing_(spacing),
      fields_(std::move(fields)),
      layout_(std::move(layout)),
      series_(directory, "fields",
              [this](const Hdf5File& file, const std::string& name, double time) { return grid(file, name, time); }) {
  layout_.items = {static_cast<std::size_t>(lattice.ny), static_cast<std::size_t>(lattice.nx)};
}

void LatticeSnapshots::write(double time, std::int64_t step) {
  series_.append(time, step, [&](Hdf5File& file) {
    for (const auto& field : fields_)
      layout_.write(file, field.name, field,
                    {{"time", time}, {"step", step}, {"dx", spacing_}, {"origin", std::vector<double>{0, 0}}});
  });
}

// Writes the lattice nodes as points of a flat three-dimensional image. ParaView's reader would put a two-dimensional
// one into the plane of y and z, in which neither the vectors nor the particles lie.
std::string LatticeSnapshots::grid(const Hdf5File& file, const std::string& name, double time) const {
  return fmt::format(
      "<Grid Name=\"lattice\" GridType=\"Uniform\">\n<Time Value=\"{}\"/>\n"
      "<Topology TopologyType=\"3DCoRectMesh\" Dimensions=\"1 {} {}\"/>\n<Geometry GeometryType=\"ORIGIN_DXDYDZ\">\n"
      "<DataItem Dimensions=\"3\" NumberType=\"Float\" Precision=\"8\" Format=\"XML\">0 {} {}</DataItem>\n"
      "<DataItem Dimensions=\"3\" NumberType=\"Float\" Precision=\"8\" Format=\"XML\">{} {} "
      "{}</DataItem>\n</Geometry>\n"
      "{}</Grid>\n",
      time, layout_.items[0], layout_.items[1], spacing_ / 2, spacing_ / 2, spacing_, spacing_, spacing_,
      xdmf_attributes(file, name, "", XdmfCentre::node));
}

}  // namespace vug::detail
