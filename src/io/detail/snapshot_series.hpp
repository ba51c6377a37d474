#pragma once
// A series of snapshots, one HDF5 file each, with an HDF5 file that links to all of them and an XDMF file that
// describes their data.
#include "io/detail/hdf5_file.hpp"

#include <functional>
#include <map>

namespace vug::detail {

/// The files `<stem>.h5`, `<stem>.xdmf` and `<stem>/*.h5` of a folder. Each is written under a temporary name and
/// renamed, a snapshot before the two files that refer to it, so that all of them are complete at any time.
class SnapshotSeries {
 public:
  /// Turns a snapshot into a <Grid> of the XDMF file; `name` is its file, relative to that.
  using Grid = std::function<std::string(const Hdf5File&, const std::string& name, double time)>;
  using Fill = std::function<void(Hdf5File&)>;

  SnapshotSeries(std::string directory, std::string stem, Grid grid);
  /// Begins anew and removes the snapshots that are there; files with other names stay.
  void create();
  /// Continues the series. Removes the snapshots after `step`. The new index leaves out missing snapshots and damaged
  /// ones; the latter are returned, a line each with what is wrong.
  std::vector<std::string> resume(std::int64_t step);
  /// Adds a part without a time.
  void add_part(const std::string& name, const Fill& fill);
  /// Adds a snapshot.
  void append(double time, std::int64_t step, const Fill& fill);
  /// The file of a part, relative to the folder.
  std::string file_name(const std::string& part) const { return stem_ + "/" + part + ".h5"; }

 private:
  std::string path_of(const std::string& part) const { return directory_ + "/" + file_name(part); }
  void make_folder() const;
  void remove_after(std::int64_t step) const;
  void write_file(const std::string& part, const Fill& fill) const;
  void name_grid(const std::string& snapshot);
  void write_index() const;

  std::string directory_, stem_;
  Grid grid_;
  std::map<std::string, std::string> parts_;  // name of each file: its <Grid>, empty without a time
};

}  // namespace vug::detail
