#include "io/detail/snapshot_series.hpp"

#include "base/require.hpp"
#include "io/detail/files.hpp"
#include "io/detail/step_names.hpp"
#include "io/detail/xdmf.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace vug::detail {

SnapshotSeries::SnapshotSeries(std::string directory, std::string stem, Grid grid)
    : directory_(std::move(directory)), stem_(std::move(stem)), grid_(std::move(grid)) {}

void SnapshotSeries::make_folder() const {
  const auto folder = directory_ + "/" + stem_;
  std::error_code error;
  std::filesystem::create_directory(folder, error);
  if (error) throw_file_error(folder, "create", error);
}

void SnapshotSeries::create() {
  make_folder();
  remove_after(-1);
  parts_.clear();
  write_index();
}

std::vector<std::string> SnapshotSeries::resume(std::int64_t step) {
  make_folder();
  remove_after(step);
  std::vector<std::string> damaged;
  for (const auto& entry : std::filesystem::directory_iterator(directory_ + "/" + stem_)) {
    const std::string part = entry.path().stem().string();
    if (entry.path().extension() != ".h5" || !is_step_name(part)) continue;
    try {
      name_grid(part);
    } catch (const FileError& error) {
      damaged.emplace_back(error.what());
    }
  }
  write_index();
  return damaged;
}

/// Removes the snapshots after `step` and unfinished files.
void SnapshotSeries::remove_after(std::int64_t step) const {
  const auto folder = directory_ + "/" + stem_;
  try {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
    for (const auto& file : files) {
      const bool unfinished = file.extension() == ".tmp";
      const auto snapshot = unfinished ? file.stem() : file.filename();
      if (snapshot.extension() != ".h5" || !is_step_name(snapshot.stem().string())) continue;
      if (unfinished || step < 0 || snapshot.stem().string() > step_name(step)) std::filesystem::remove(file);
    }
  } catch (const std::filesystem::filesystem_error& e) {
    throw_file_error(folder, "continue", e.code());
  }
}

void SnapshotSeries::add_part(const std::string& name, const Fill& fill) {
  write_file(name, fill);
  parts_[name];
  write_index();
}

void SnapshotSeries::append(double time, std::int64_t step, const Fill& fill) {
  const auto name = step_name(step);
  write_file(name, [&](Hdf5File& file) {
    file.write(Attribute{"time", time});
    file.write(Attribute{"step", step});
    fill(file);
  });
  name_grid(name);
  write_index();
}

void SnapshotSeries::write_file(const std::string& part, const Fill& fill) const {
  auto file = Hdf5File::create(path_of(part));
  fill(file);
  file.commit(true);
}

void SnapshotSeries::name_grid(const std::string& snapshot) {
  const auto file = Hdf5File::open(path_of(snapshot));
  parts_[snapshot] = grid_(file, file_name(snapshot), file.attribute("time"));
}

void SnapshotSeries::write_index() const {
  std::vector<std::string> grids;
  auto index = Hdf5File::create(directory_ + "/" + stem_ + ".h5");
  for (const auto& [part, grid] : parts_) {
    index.link(part, file_name(part));
    if (!grid.empty()) grids.push_back(grid);
  }
  index.commit(false);
  replace_file(directory_ + "/" + stem_ + ".xdmf", xdmf_document(grids), false);
}

}  // namespace vug::detail
