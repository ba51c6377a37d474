#include "io/detail/field_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <numeric>

namespace vug::detail {

std::vector<double> values_of(const Field& field, std::size_t items) {
  std::vector<double> values(items * static_cast<std::size_t>(field.components));
  field.read(values);
  return values;
}

void FieldLayout::write(Hdf5File& file, const std::string& name, const Field& field,
                        std::vector<Attribute> attributes) const {
  const auto count = std::accumulate(items.begin(), items.end(), std::size_t{1}, std::multiplies<>());
  auto values = values_of(field, count);
  auto shape = items;
  if (field.components == 2) {
    std::vector<double> padded(3 * count, 0.0);
    for (std::size_t i = 0; i < count; ++i) std::copy_n(&values[2 * i], 2, &padded[3 * i]);
    values = std::move(padded);
    shape.push_back(3);
  } else if (field.components != 1) {
    shape.push_back(static_cast<std::size_t>(field.components));
  }
  attributes.push_back({"units", field.unit});
  file.write(name, shape, values, type, compress, attributes);
}

std::vector<Field> selected(const std::vector<Field>& fields, const std::vector<std::string>& names) {
  if (names.empty()) return fields;
  std::vector<Field> out;
  std::copy_if(fields.begin(), fields.end(), std::back_inserter(out),
               [&names](const Field& f) { return std::find(names.begin(), names.end(), f.name) != names.end(); });
  return out;
}

std::string xdmf_attributes(const Hdf5File& file, const std::string& file_name, const std::string& group,
                            XdmfCentre centre, int bytes) {
  std::string text;
  const auto prefix = file_name + ":/" + (group.empty() ? "" : group + "/");
  for (const auto& [name, shape] : file.datasets(group))
    if (name != "vertices") text += xdmf_attribute(name, {prefix + name, shape, false, bytes}, centre);
  return text;
}

}  // namespace vug::detail
