#pragma once
// Units and ranges of the numbers in a case file.
#include <limits>
#include <string>
#include <string_view>

namespace vug {

/// An SI unit and the largest magnitude that is accepted; a number beyond it is taken for a typing error.
struct Unit {
  std::string_view symbol;
  double largest;
  bool difference = false;  ///< of two temperatures: the zero of their scale does not matter
};

namespace unit {
constexpr Unit none{"1", 1e18};
constexpr Unit cells{"cells", 1e4};
constexpr Unit metre{"m", 1e5};
constexpr Unit second{"s", 1e9};
constexpr Unit kelvin{"K", 1e4};
constexpr Unit kelvin_difference{"K", 1e4, true};
constexpr Unit pascal{"Pa", 1e13};
constexpr Unit pascal_per_metre{"Pa/m", 1e18};
constexpr Unit metre_per_second{"m/s", 1e6};
constexpr Unit metre_per_square_second{"m/s2", 1e12};
constexpr Unit square_metre_per_second{"m2/s", 1e4};
constexpr Unit kilogram_per_cubic_metre{"kg/m3", 1e6};
constexpr Unit joule_per_kilogram_kelvin{"J/(kg K)", 1e7};
constexpr Unit joule_per_mole{"J/mol", 1e7};
constexpr Unit mole_per_cubic_metre{"mol/m3", 1e6};
constexpr Unit cubic_metre_per_mole{"m3/mol", 1};
constexpr Unit per_kelvin{"1/K", 1};
constexpr Unit newton_per_metre{"N/m", 1e15};
constexpr Unit newton_second_per_metre{"N s/m", 1e12};
constexpr Unit watt_per_square_metre{"W/m2", 1e15};
constexpr Unit watt_per_square_metre_kelvin{"W/(m2 K)", 1e12};
constexpr Unit watt_per_metre_kelvin{"W/(m K)", 1e6};
constexpr Unit pascal_second{"Pa s", 1e9};
constexpr Unit mole_per_square_metre_second{"mol/(m2 s)", 1e9};
constexpr Unit kilogram_per_metre_second{"kg/(m s)", 1e9};
constexpr Unit second_per_metre{"s/m", 1};
}  // namespace unit

/// An interval of numbers; an open end excludes its bound.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false;
  bool high_open = false;
  bool infinity_allowed = false;  ///< +inf is allowed, as for the equilibrium constant of an irreversible reaction

  bool contains(double value) const;
  std::string text() const;  ///< "> 0", "0 ... 1", "any"
};

namespace range {
constexpr Range any{};
constexpr Range positive{.low = 0, .low_open = true};
constexpr Range not_negative{.low = 0};
constexpr Range between(double low, double high) {
  return {.low = low, .high = high};
}
/// (0, high]
constexpr Range positive_to(double high) {
  return {.low = 0, .high = high, .low_open = true};
}
}  // namespace range

}  // namespace vug
