#pragma once
// How a field of a FieldList becomes a data set.
#include "io/detail/hdf5_file.hpp"
#include "io/detail/xdmf.hpp"
#include "io/field_list.hpp"

#include <string>
#include <vector>

namespace vug::detail {

/// Reads the values of all items.
std::vector<double> values_of(const Field& field, std::size_t items);

/// Reads a field of items (row, column) in the same pieces as FieldLayout writes it, for a rank that writes nothing.
void read_along(const Field& field, const std::vector<std::size_t>& items);

/// Shape of the items and type of the numbers. Vectors in the plane get a third component, zero, which viewers need.
struct FieldLayout {
  std::vector<std::size_t> items;
  bool compress = true;
  static constexpr StoredAs type = StoredAs::float32;

  void write(Hdf5File& file, const std::string& name, const Field& field, std::vector<Attribute> attributes) const;
};

/// Those of `fields` whose names are in `names`; all when it is empty.
std::vector<Field> selected(const std::vector<Field>& fields, const std::vector<std::string>& names);

/// XDMF attributes for all fields of a group ("" is the root) of the file that XDMF calls `file_name`.
std::string xdmf_attributes(const Hdf5File& file, const std::string& file_name, const std::string& group,
                            XdmfCentre centre);

}  // namespace vug::detail
