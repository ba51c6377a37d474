#include "io/require_fields.hpp"

#include "base/require.hpp"
#include "io/message.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

namespace vug {

void require_fields(const FieldList& fields, const std::vector<std::string>& names) {
  std::set<std::string> known;
  for (const auto* list : {&fields.lattice, &fields.particles, &fields.bonds})
    for (const auto& field : *list) known.insert(field.name);
  for (const auto& name : names)
    if (!known.contains(name))
      throw InputError(fmt::format("output.fields: '{}' is not computed in this case; there are: {}", excerpt(name),
                                   fmt::join(known, ", ")));
}

}  // namespace vug
