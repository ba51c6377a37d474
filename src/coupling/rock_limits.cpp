#include "coupling/rock_limits.hpp"

#include "dem/toughness.hpp"
#include "kernels/base/host_and_device.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace vug {

namespace {

/// Up to this share of the bonds' E G_I / sigma_n^2, half of the rock's, the size of the triangles adds less than 5 %
/// to the load of a cracked plate (docs/validation.md, toughness).
constexpr double largest_edge = 0.6;

double mean_edge(const Bonds& bonds) {
  double sum = 0;
  const auto length = on_host(bonds.length);
  for (int k = 0; k < bonds.count; ++k) sum += length(k);
  return sum / std::max(1, bonds.count);
}

}  // namespace

Limit limit_of_edges(const Mechanics& rock) {
  double softening = softening_length(rock.parameters().bond);
  for (const RockMaterial& material : rock.parameters().materials)
    softening = std::min(softening, softening_length(material.bond));
  const double longest = largest_edge * softening;
  return {"mechanics",
          "mean edge of the bonds",
          mean_edge(rock.bonds()),
          "m",
          0,
          longest,
          fmt::format("cracks take more than their fracture energy; lower rock.element_size to {:.2g} m", longest)};
}

}  // namespace vug
