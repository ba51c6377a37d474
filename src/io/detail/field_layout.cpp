#include "io/detail/field_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <span>

namespace vug::detail {

std::vector<double> values_of(const Field& field, std::size_t items) {
  std::vector<double> values(items * static_cast<std::size_t>(field.components));
  field.read(values);
  return values;
}

void read_along(const Field& field, const std::vector<std::size_t>& items) {
  const ReadItems read = field.open();
  std::vector<double> values;
  visit_pieces(items, [&](std::size_t first, std::size_t rows) {
    values.resize(rows * row_size(items) * field.components);
    read(first * row_size(items), values);
  });
}

void FieldLayout::write(Hdf5File& file, const std::string& name, const Field& field,
                        std::vector<Attribute> attributes) const {
  const ReadItems read = field.open();
  const auto components = static_cast<std::size_t>(field.components), stored = components == 2 ? 3 : components;
  std::vector<std::size_t> shape = items;
  if (stored > 1) shape.push_back(stored);
  attributes.push_back({"units", field.unit});
  std::vector<double> plane;
  const auto rows = [&](std::size_t first, std::span<double> values) {
    first *= row_size(items);
    if (stored == components) return read(first, values);
    const std::size_t count = values.size() / stored;
    plane.resize(count * components);
    read(first, plane);
    std::fill(values.begin(), values.end(), 0.0);
    for (std::size_t i = 0; i < count; ++i) std::copy_n(&plane[components * i], components, &values[stored * i]);
  };
  file.write(name, shape, rows, type, compress, attributes);
}

std::vector<Field> selected(const std::vector<Field>& fields, const std::vector<std::string>& names) {
  if (names.empty()) return fields;
  std::vector<Field> out;
  std::copy_if(fields.begin(), fields.end(), std::back_inserter(out),
               [&names](const Field& f) { return std::find(names.begin(), names.end(), f.name) != names.end(); });
  return out;
}

std::string xdmf_attributes(const Hdf5File& file, const std::string& file_name, const std::string& group,
                            XdmfCentre centre) {
  std::string text;
  const auto prefix = file_name + ":/" + (group.empty() ? "" : group + "/");
  for (const auto& [name, shape] : file.datasets(group))
    if (name != "vertices") text += xdmf_attribute(name, {prefix + name, shape}, centre);
  return text;
}

}  // namespace vug::detail
