#pragma once
// Snapshots: fields.h5 with fields.xdmf on the lattice, particles.h5 with particles.xdmf on the triangles and bonds.
#include "base/lattice.hpp"
#include "dem/assembly.hpp"
#include "io/field_list.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vug {

namespace detail {
class LatticeSnapshots;
class RockSnapshots;
}  // namespace detail

/// A bond as it is drawn: the two triangles it joins and the two vertices of their common edge.
struct BondEdge {
  std::array<int, 2> particles;
  std::array<int, 2> vertices;
};

/// What particles.h5 needs to draw triangles and bonds. Where the particles offer the fields "displacement" (m, two
/// components) and "rotation" (rad), the vertices move with them.
struct RockShape {
  Assembly assembly;
  std::vector<BondEdge> bonds;
};

struct SnapshotOptions {
  std::vector<std::string> fields;  ///< names to write; empty: all
  bool compress = true;
  /// Continues the files of a run: snapshots after this step are dropped, the next ones appended.
  std::optional<std::int64_t> resume_step;
};

/// Writes snapshots in SI units into `directory`, which must exist. In the HDF5 files every snapshot is a group
/// `step_<number>` with one data set per field, shape (ny, nx) or (ny, nx, 3), row 0 at the bottom, with attributes
/// units, time, step, dx, origin. A group appears in the file only when it is complete, and the XDMF file, which is
/// replaced as a whole, names only complete groups: the files of a killed run are readable. Throws FileError.
class SnapshotWriter {
 public:
  /// `rock` is absent in a scene without particles. Throws InputError for a name in `options.fields` that is in no
  /// list.
  SnapshotWriter(const std::string& directory, const Lattice& lattice, double spacing, FieldList fields,
                 const SnapshotOptions& options, std::optional<RockShape> rock = std::nullopt);
  /// For rock alone: particles.h5 and its XDMF file.
  SnapshotWriter(const std::string& directory, FieldList fields, const SnapshotOptions& options, RockShape rock);
  ~SnapshotWriter();
  SnapshotWriter(SnapshotWriter&&) noexcept;
  SnapshotWriter& operator=(SnapshotWriter&&) noexcept;

  void write(double time, std::int64_t step);
  /// Damaged snapshots of a run that is continued, a line each. They stay in their folder, but no index names them.
  const std::vector<std::string>& passed_over() const { return passed_over_; }

 private:
  std::unique_ptr<detail::LatticeSnapshots> lattice_;
  std::unique_ptr<detail::RockSnapshots> rock_;
  std::vector<std::string> passed_over_;
};

/// For ranks that write no files: reads the same fields of the lattice while rank 0 writes a snapshot.
void read_snapshot(const Lattice& lattice, const FieldList& fields, const std::vector<std::string>& names);

}  // namespace vug
