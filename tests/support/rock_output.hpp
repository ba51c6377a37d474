#pragma once
// What is written of triangles and bonds, as a user finds it in particles.h5.
#include "coupling/rock_fields.hpp"

#include <stdexcept>
#include <string>
#include <vector>

namespace vug::test {

inline std::vector<double> read_field(const std::vector<Field>& fields, const std::string& name, int items) {
  for (const Field& field : fields) {
    if (field.name != name) continue;
    std::vector<double> values(static_cast<std::size_t>(items) * static_cast<std::size_t>(field.components));
    field.read(values);
    return values;
  }
  throw std::invalid_argument("no field " + name);
}

/// A field over the triangles.
inline std::vector<double> of_triangles(const Mechanics& rock, const std::string& name) {
  FieldList list;
  add_rock_fields(rock, list);
  return read_field(list.particles, name, rock.particles().count);
}

/// A field over the bonds.
inline std::vector<double> of_bonds(const Mechanics& rock, const std::string& name) {
  FieldList list;
  add_rock_fields(rock, list);
  return read_field(list.bonds, name, rock.bonds().count);
}

}  // namespace vug::test
