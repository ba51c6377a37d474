#include "io/detail/quantity.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>
#include <system_error>
#include <utility>

namespace vug {
namespace {

struct Suffix {
  std::string_view si, written;
  double factor;
  double offset = 0;  ///< added after scaling, except to a difference
};

constexpr std::array suffixes{
    Suffix{"Pa", "kPa", 1e3},
    Suffix{"Pa", "MPa", 1e6},
    Suffix{"Pa", "GPa", 1e9},
    Suffix{"Pa", "bar", 1e5},
    Suffix{"Pa", "psi", 4.4482216152605 / (0.0254 * 0.0254)},
    Suffix{"m", "cm", 1e-2},
    Suffix{"m", "mm", 1e-3},
    Suffix{"m", "um", 1e-6},
    Suffix{"m", "nm", 1e-9},
    Suffix{"s", "ms", 1e-3},
    Suffix{"s", "us", 1e-6},
    Suffix{"s", "ns", 1e-9},
    Suffix{"s", "min", 60},
    Suffix{"s", "h", 3600},
    Suffix{"s", "d", 86400},
    Suffix{"K", "degC", 1, 273.15},
    Suffix{"mol/m3", "mol/L", 1e3},
    Suffix{"mol/m3", "mmol/L", 1},
    Suffix{"mol/m3", "mol/cm3", 1e6},
    Suffix{"m/s", "cm/s", 1e-2},
    Suffix{"m/s", "mm/s", 1e-3},
    Suffix{"m2/s", "mm2/s", 1e-6},
    Suffix{"m2/s", "cm2/s", 1e-4},
    Suffix{"m2/s", "St", 1e-4},
    Suffix{"m2/s", "cSt", 1e-6},
    Suffix{"Pa s", "mPa s", 1e-3},
    Suffix{"Pa s", "P", 1e-1},
    Suffix{"Pa s", "cP", 1e-3},
    Suffix{"mol/(m2 s)", "mol/(cm2 s)", 1e4},
    Suffix{"kg/m3", "g/cm3", 1e3},
    Suffix{"J/mol", "kJ/mol", 1e3},
    Suffix{"m3/mol", "cm3/mol", 1e-6},
    Suffix{"J/(kg K)", "kJ/(kg K)", 1e3},
    Suffix{"W/m2", "kW/m2", 1e3},
    Suffix{"W/m2", "MW/m2", 1e6},
};

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// A unit in the letters of the table: µm is um (both signs of Unicode for it), °C is degC, m² and m^2 are m2.
std::string in_plain_letters(std::string_view written) {
  constexpr std::pair<std::string_view, std::string_view> signs[] = {
      {"\u00b5", "u"}, {"\u03bc", "u"}, {"\u00b0", "deg"}, {"\u00b2", "2"}, {"\u00b3", "3"}, {"^", ""}};
  std::string plain;
  while (!written.empty()) {
    const auto* sign = std::find_if(std::begin(signs), std::end(signs),
                                    [&](const auto& known) { return written.starts_with(known.first); });
    const bool found = sign != std::end(signs);
    plain.append(found ? sign->second : written.substr(0, 1));
    written.remove_prefix(found ? sign->first.size() : 1);
  }
  return plain;
}

}  // namespace

std::optional<double> parse_quantity(std::string_view text, Unit unit) {
  text = trimmed(text);
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{}) return std::nullopt;
  const std::string written = in_plain_letters(trimmed(text.substr(static_cast<std::size_t>(end - text.data()))));
  if (written == unit.symbol && unit.symbol != unit::none.symbol) return value;
  for (const Suffix& suffix : suffixes) {
    if (suffix.si == unit.symbol && suffix.written == written)
      return value * suffix.factor + (unit.difference ? 0 : suffix.offset);
  }
  return std::nullopt;
}

std::string accepted_units(Unit unit) {
  if (unit.symbol == unit::none.symbol) return "";
  std::string list(unit.symbol);
  for (const Suffix& suffix : suffixes) {
    if (suffix.si == unit.symbol) list.append(", ").append(suffix.written);
  }
  return list;
}

}  // namespace vug
