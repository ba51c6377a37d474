#pragma once
// A series of snapshots in one HDF5 file, with the XDMF file that names them.
#include "io/detail/hdf5_file.hpp"

#include <functional>
#include <optional>

namespace vug::detail {

/// The files `<stem>.h5` and `<stem>.xdmf` of a folder.
class SnapshotSeries {
 public:
  /// Turns a published snapshot into a <Grid> of the XDMF file.
  using Grid = std::function<std::string(const Hdf5File&, const std::string& group, double time)>;

  SnapshotSeries(const std::string& directory, const std::string& stem, Grid grid);
  /// Begins anew.
  void create();
  /// Continues the files, without the snapshots after `step`.
  void resume(std::int64_t step);
  /// Adds a snapshot that `fill` writes into its group.
  void append(double time, std::int64_t step, const std::function<void(Hdf5File::Group&)>& fill);
  Hdf5File open() const { return Hdf5File::open(directory_ + "/" + h5_name_); }
  const std::string& h5_name() const { return h5_name_; }

 private:
  void add_group(double time, std::int64_t step, const std::function<void(Hdf5File::Group&)>& fill);
  void write_xdmf() const;

  std::string directory_, h5_name_, xdmf_path_;
  Grid grid_;
  std::vector<std::string> grids_;
};

}  // namespace vug::detail
