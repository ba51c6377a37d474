#include "io/detail/snapshot_series.hpp"

#include "io/detail/files.hpp"
#include "io/detail/xdmf.hpp"

#include <fmt/format.h>

namespace vug::detail {

namespace {
std::string group_name(std::int64_t step) {
  return fmt::format("step_{:012d}", step);
}
}  // namespace

SnapshotSeries::SnapshotSeries(const std::string& directory, const std::string& stem, Grid grid)
    : directory_(directory),
      h5_name_(stem + ".h5"),
      xdmf_path_(directory + "/" + stem + ".xdmf"),
      grid_(std::move(grid)) {}

void SnapshotSeries::create() {
  Hdf5File::create(directory_ + "/" + h5_name_).close();
  write_xdmf();
}

void SnapshotSeries::resume(std::int64_t step) {
  auto file = open();
  grids_.clear();
  for (const auto& group : file.groups()) {
    if (!group.starts_with("step_")) continue;
    if (group > group_name(step))
      file.remove(group);
    else
      grids_.push_back(grid_(file, group, file.attribute(group, "time")));
  }
  file.close();
  write_xdmf();
}

void SnapshotSeries::append(double time, std::int64_t step, const std::function<void(Hdf5File::Group&)>& fill) {
  const Hdf5Rollback rollback(directory_ + "/" + h5_name_);
  bool all_written = false;
  try {
    add_group(time, step, [&](Hdf5File::Group& group) {
      fill(group);
      group.flush();
      all_written = true;
    });
  } catch (...) {
    if (!all_written) rollback.restore();
    throw;
  }
  write_xdmf();
}

void SnapshotSeries::add_group(double time, std::int64_t step, const std::function<void(Hdf5File::Group&)>& fill) {
  const auto name = group_name(step);
  auto file = open();
  {
    Hdf5File::Group group(file, name, {{"time", time}, {"step", step}});
    fill(group);
    group.publish();
  }
  grids_.push_back(grid_(file, name, time));
  file.close();
}

void SnapshotSeries::write_xdmf() const {
  replace_file(xdmf_path_, xdmf_document(grids_), false);
}

}  // namespace vug::detail
