#include "coupling/rock_limits.hpp"

#include "dem/particles.hpp"
#include "dem/toughness.hpp"
#include "io/assembly_quality.hpp"
#include "io/notch_remarks.hpp"
#include "io/rock_inertia.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vug {

namespace {

/// Largest mean edge over E G_I / sigma_n^2 of the bonds (half of that of the rock). Up to here the size of the
/// triangles adds less than 5 % to the load of a cracked plate (docs/validation.md, toughness).
constexpr double largest_edge = 0.6;

/// Share of the mean edge below which no triangles of the length over which cracks soften can be made: bonds then break
/// at once.
constexpr double out_of_reach = 1e-3;

constexpr double cells_of_an_edge = 4;  // smallest allowed

/// Edge of an equilateral triangle with the area of the smallest triangle of generated rock, over the mean edge of the
/// rock. From 0.69 to 0.8 were found.
constexpr double smallest_over_mean = 0.65;

/// The number rounded down to two digits, so that it is enough to follow the advice.
double rounded_down(double number) {
  if (number == 0 || std::isinf(number))
    return number;  // 0 for bonds without fracture energy, infinite for bonds without strength
  const double last = std::pow(10, std::floor(std::log10(number)) - 1);
  return std::floor(number / last * (1 + 1e-9)) * last;
}

double mean_edge(const Bonds& bonds) {
  double sum = 0;
  const auto length = on_host(bonds.length);
  for (int k = 0; k < bonds.count; ++k) sum += length(k);
  return sum / std::max(1, bonds.count);
}

}  // namespace

Limit limit_of_edges(const Mechanics& rock, double spacing) {
  double softening = softening_length(rock.parameters().bond);
  for (const RockMaterial& material : rock.parameters().materials)
    softening = std::min(softening, softening_length(material.bond));
  const double longest = largest_edge * softening, mean = mean_edge(rock.bonds());
  const double finest = longest * smallest_over_mean / cells_of_an_edge;
  const std::string advice =
      longest < out_of_reach * mean
          ? "bonds snap at once and dissipate what they hold, whatever their fracture energy"
          : fmt::format(
                "cracks dissipate more than their fracture energy; to avoid this lower rock.element_size (of a "
                "mesh, its edges) to {:.2g} m{}",
                rounded_down(longest),
                spacing > finest ? fmt::format(", and lattice.spacing to {:.2g} m", rounded_down(finest)) : "");
  return {"mechanics", "mean edge of the bonds", mean, "m", 0, longest, advice};
}

Limit limit_of_thermal_strain(double expansion, double change) {
  return {"mechanics",
          "thermal strain of the named temperatures",
          expansion * change,
          "1",
          0,
          largest_small_strain,
          "the mechanics are those of small strains; check mechanics.thermal_expansion and the temperatures"};
}

Limit limit_of_initial_velocities(const MechanicsSection& rock) {
  double fastest = 0;
  for (const InitialVelocity& start : rock.initial_velocities)
    fastest = std::max(fastest, std::hypot(start.velocity[0], start.velocity[1]));
  return {"mechanics",
          "initial velocity times sqrt(mass_scaling)",
          fastest * std::sqrt(rock.parameters.mass_scaling),
          "m/s",
          0,
          fastest_press,
          "inertia adds to the strength, soon more than 5 %; lower the velocity or mechanics.mass_scaling unless an "
          "impact is meant"};
}

std::vector<std::string> remarks_on_notches_of_mesh(const Scene& scene, const Assembly& rock) {
  if (!scene.damage || !scene.rock->mesh || scene.rock->notches.empty()) return {};
  return remarks_on_notches(scene, assembly_quality(rock).mean_edge);
}

std::optional<std::string> remark_on_triangles(const Assembly& rock, double spacing) {
  double smallest = std::numeric_limits<double>::infinity();  // m2
  for (std::size_t t = 0; t < rock.triangles.size(); ++t)
    smallest = std::min(smallest, triangle_of(rock, static_cast<int>(t)).area());
  const double edge = std::sqrt(4 / std::sqrt(3.0) * smallest);
  if (edge >= cells_of_an_edge * spacing) return {};
  return fmt::format(
      "the smallest triangle of the rock, as large as one with edges of {:.3g} m, is below four cells: too "
      "small for the lattice",
      edge);
}

}  // namespace vug
