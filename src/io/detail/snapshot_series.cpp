#include "io/detail/snapshot_series.hpp"

#include "io/detail/xdmf.hpp"
#include "kernels/require.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace vug::detail {

namespace {

std::string snapshot_name(std::int64_t step) {
  return fmt::format("step_{:012d}", step);
}

bool is_snapshot(const std::string& part) {
  return part.starts_with("step_");
}

}  // namespace

SnapshotSeries::SnapshotSeries(std::string directory, std::string stem, Grid grid)
    : directory_(std::move(directory)), stem_(std::move(stem)), grid_(std::move(grid)) {}

void SnapshotSeries::create() {
  const auto folder = directory_ + "/" + stem_;
  std::error_code error;
  std::filesystem::remove_all(folder, error);
  if (!error) std::filesystem::create_directory(folder, error);
  if (error) throw FileError(folder + ": cannot create: " + error.message());
  parts_.clear();
  write_index();
}

void SnapshotSeries::resume(std::int64_t step) {
  const auto folder = directory_ + "/" + stem_;
  try {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      const auto part = entry.path().stem().string(), extension = entry.path().extension().string();
      const bool later = is_snapshot(part) && part > snapshot_name(step), unfinished = extension == ".tmp";
      if (unfinished || (extension == ".h5" && later))
        std::filesystem::remove(entry.path());
      else if (extension == ".h5" && is_snapshot(part))
        name_grid(part);
      else if (extension == ".h5")
        parts_[part];
    }
  } catch (const std::filesystem::filesystem_error& e) {
    throw FileError(folder + ": cannot continue: " + e.code().message());
  }
  write_index();
}

void SnapshotSeries::add_part(const std::string& name, const Fill& fill) {
  write_file(name, fill);
  parts_[name];
  write_index();
}

void SnapshotSeries::append(double time, std::int64_t step, const Fill& fill) {
  const auto name = snapshot_name(step);
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
