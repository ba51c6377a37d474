#pragma once
// A field of output whose numbers a test makes up.
#include "io/field_list.hpp"

#include <functional>
#include <span>
#include <string>

namespace vug::test {

/// value(number in the array), components fastest.
inline Field made_field(const std::string& name, const std::string& unit, int components,
                        const std::function<double(std::size_t)>& value) {
  const auto read = [value, components](std::size_t first, std::span<double> out) {
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = value(first * components + i);
  };
  return {name, unit, components, [read] { return read; }};
}

}  // namespace vug::test
