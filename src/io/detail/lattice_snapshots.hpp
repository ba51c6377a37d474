#pragma once
// fields.h5 with fields.xdmf and the folder fields: the cells of the lattice.
#include "base/lattice.hpp"
#include "io/detail/field_layout.hpp"
#include "io/detail/snapshot_series.hpp"

namespace vug::detail {

class LatticeSnapshots {
 public:
  LatticeSnapshots(const std::string& directory, const Lattice& lattice, double spacing, std::vector<Field> fields,
                   FieldLayout layout);
  LatticeSnapshots(const LatticeSnapshots&) = delete;  // the series keeps a pointer to this
  LatticeSnapshots& operator=(const LatticeSnapshots&) = delete;

  void create() { series_.create(); }
  std::vector<std::string> resume(std::int64_t step) { return series_.resume(step); }
  void write(double time, std::int64_t step);

 private:
  std::string grid(const Hdf5File& file, const std::string& name, double time) const;

  double spacing_;
  std::vector<Field> fields_;
  FieldLayout layout_;
  SnapshotSeries series_;
};

}  // namespace vug::detail
