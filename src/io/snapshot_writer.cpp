#include "io/snapshot_writer.hpp"

#include "io/detail/lattice_snapshots.hpp"
#include "io/detail/rock_snapshots.hpp"
#include "io/require_fields.hpp"

namespace vug {

SnapshotWriter::SnapshotWriter(const std::string& directory, const Lattice& lattice, double spacing, FieldList fields,
                               const SnapshotOptions& options, std::optional<RockShape> rock) {
  require_fields(fields, options.fields);
  const detail::FieldLayout layout{{}, options.compress};
  lattice_ = std::make_unique<detail::LatticeSnapshots>(directory, lattice, spacing,
                                                        detail::selected(fields.lattice, options.fields), layout);
  if (rock)
    rock_ = std::make_unique<detail::RockSnapshots>(directory, fields, options.fields, layout, std::move(*rock));
  if (options.resume_step) {
    passed_over_ = lattice_->resume(*options.resume_step);
    if (rock_)
      for (std::string& damaged : rock_->resume(*options.resume_step)) passed_over_.push_back(std::move(damaged));
  } else {
    lattice_->create();
    if (rock_) rock_->create();
  }
}

SnapshotWriter::SnapshotWriter(const std::string& directory, FieldList fields, const SnapshotOptions& options,
                               RockShape rock) {
  require_fields(fields, options.fields);
  const detail::FieldLayout layout{{}, options.compress};
  rock_ = std::make_unique<detail::RockSnapshots>(directory, fields, options.fields, layout, std::move(rock));
  rock_->create();
}

SnapshotWriter::~SnapshotWriter() = default;
SnapshotWriter::SnapshotWriter(SnapshotWriter&&) noexcept = default;
SnapshotWriter& SnapshotWriter::operator=(SnapshotWriter&&) noexcept = default;

void SnapshotWriter::write(double time, std::int64_t step) {
  if (lattice_) lattice_->write(time, step);
  if (rock_) rock_->write(time, step);
}

void read_snapshot(const Lattice& lattice, const FieldList& fields, const std::vector<std::string>& names) {
  for (const Field& field : detail::selected(fields.lattice, names))
    detail::read_along(field, {static_cast<std::size_t>(lattice.ny), static_cast<std::size_t>(lattice.nx)});
}

}  // namespace vug
