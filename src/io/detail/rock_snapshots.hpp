#pragma once
// particles.h5 with particles.xdmf and the folder particles: triangles, each with its own vertices, and bonds as lines.
#include "io/detail/field_layout.hpp"
#include "io/detail/snapshot_series.hpp"
#include "io/snapshot_writer.hpp"

#include <optional>

namespace vug::detail {

class RockSnapshots {
 public:
  RockSnapshots(const std::string& directory, const FieldList& fields, const std::vector<std::string>& names,
                FieldLayout layout, RockShape shape);
  RockSnapshots(const RockSnapshots&) = delete;  // the series keeps a pointer to this
  RockSnapshots& operator=(const RockSnapshots&) = delete;

  /// Begins anew and writes `rock`, the part that never changes: which vertices make a triangle or a bond.
  void create();
  std::vector<std::string> resume(std::int64_t step);
  void write(double time, std::int64_t step);

 private:
  using Points = std::vector<std::array<double, 2>>;
  void add_connectivity();
  void write_connectivity(Hdf5File& file) const;
  Points moved_vertices() const;
  Points bond_ends(const Points& moved) const;
  void write_vertices(Hdf5File& file, const std::string& name, const Points& points,
                      std::vector<Attribute> attributes) const;
  std::string part(const Hdf5File& file, const std::string& name, const std::string& items, const std::string& topology,
                   std::size_t count, std::size_t corners) const;
  std::string grid(const Hdf5File& file, const std::string& name, double time) const;

  RockShape shape_;
  std::vector<Field> triangle_fields_, bond_fields_;
  std::optional<Field> displacement_, rotation_;
  FieldLayout layout_;
  SnapshotSeries series_;
};

}  // namespace vug::detail
