#include "coupling/run_files.hpp"

#include "base/require.hpp"
#include "coupling/cells.hpp"
#include "coupling/rock_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace vug {

namespace {

std::optional<RockShape> rock_shape(const Parts& parts) {
  if (!parts.mechanics) return std::nullopt;
  return shape_of_rock(parts.rock->assembly, parts.mechanics->bonds());
}

std::vector<HistoryValue> history_row(const Scene& scene, const Simulation& simulation, const Probes& probes) {
  std::vector<HistoryValue> row = simulation.history();
  if (!scene.output.probes.empty()) simulation.gather();
  probes.add(row);
  return row;
}

}  // namespace

void Probes::add(std::vector<HistoryValue>& row) const {
  if (scene_.output.probes.empty()) return;
  const int nx = scene_.lattice.nx, ny = scene_.lattice.ny;
  for (const Field& field : fields_.lattice) {
    const ReadItems read = field.open();
    for (const Probe& probe : scene_.output.probes) {
      const int x = std::clamp(cell_of(probe.at[0] / scene_.lattice.spacing), 0, nx - 1);
      const int y = std::clamp(cell_of(probe.at[1] / scene_.lattice.spacing), 0, ny - 1);
      std::vector<double> values(field.components);
      read(static_cast<std::size_t>(y) * nx + x, values);
      for (int c = 0; c < field.components; ++c) {
        const std::string axis = field.components == 1 ? "" : c == 0 ? "_x" : "_y";
        row.push_back({probe.name + "_" + field.name + axis + "_" + field.unit, values[c]});
      }
    }
  }
}

std::vector<std::string> history_columns(const Scene& scene, const Simulation& simulation) {
  const FieldList fields = simulation.fields();
  std::vector<std::string> columns;
  for (const HistoryValue& value : history_row(scene, simulation, Probes(scene, fields))) columns.push_back(value.name);
  std::vector<std::string> sorted = columns;
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end())
    throw InputError(
        fmt::format("{}: two columns of the history would be called \"{}\"; give species, minerals, shapes, "
                    "probes and gauges names of which none begins as another does",
                    scene.path, *twice));
  return columns;
}

RunFiles::RunFiles(const Scene& scene, const Simulation& simulation, const std::string& directory,
                   const std::vector<std::string>& columns, std::optional<std::int64_t> resume_step)
    : scene_(scene), simulation_(simulation), columns_(columns), fields_(simulation.fields()), probes_(scene, fields_) {
  const Parts& parts = simulation.parts();
  if (!parts.geometry.split.ranks().first()) return;
  const SnapshotOptions options{scene.output.fields, scene.output.compress, resume_step};
  snapshots_.emplace(directory, parts.geometry.lattice, scene.lattice.spacing, fields_, options, rock_shape(parts));
  history_.emplace(directory + "/history.csv", columns,
                   resume_step ? std::optional(simulation.clock().time()) : std::nullopt);
}

void RunFiles::write_snapshot() {
  simulation_.gather();
  if (snapshots_)
    snapshots_->write(simulation_.clock().time(), simulation_.clock().step);
  else
    read_snapshot(simulation_.parts().geometry.lattice, fields_, scene_.output.fields);
}

std::vector<HistoryValue> RunFiles::write_row() {
  const std::vector<HistoryValue> written = history_row(scene_, simulation_, probes_);
  std::vector<double> values;
  for (const HistoryValue& value : written) {
    if (values.size() >= columns_.size() || columns_[values.size()] != value.name)
      throw std::logic_error(fmt::format("history.csv has no column {} at place {}", value.name, values.size()));
    values.push_back(value.value);
  }
  if (history_) history_->write(values);
  return written;
}

}  // namespace vug
