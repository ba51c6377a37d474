#include "coupling/mouths.hpp"

#include "coupling/velocity_profile.hpp"
#include "kernels/base/host_and_device.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace vug {

namespace {

/// Adds the fluid nodes beside a part of a side.
void look_beside_side(const Stretch& stretch, const FluidPicture& picture, Mouth& mouth) {
  for (int i = stretch.first; i <= stretch.last; ++i) {
    const std::size_t n = stretch.side == Side::left     ? picture.number(0, i)
                          : stretch.side == Side::right  ? picture.number(picture.nx - 1, i)
                          : stretch.side == Side::bottom ? picture.number(i, 0)
                                                         : picture.number(i, picture.ny - 1);
    if (!picture.is_fluid(n)) continue;
    mouth.nodes.push_back(n);
    mouth.length.push_back(1);
  }
}

/// Adds the fluid nodes beside an opening; the length of each is the sum of the areas of its links.
void look_beside_opening(const Opening& opening, const Geometry& geometry, const FluidPicture& picture, Mouth& mouth) {
  const Exec exec;
  const BoundaryLinks links = find_opening_links(exec, geometry.fluid, opening, D2Q9::Q);
  const auto area = on_host(link_areas(exec, geometry.fluid, opening, D2Q9::Q));
  const auto fluid = on_host(links.fluid), node = on_host(geometry.fluid.node);
  std::map<std::size_t, double> beside;
  for (int l = 0; l < links.count; ++l) {
    const int n = node(fluid(l));
    beside[picture.number(geometry.lattice.x(n), geometry.lattice.y(n))] += area(l);
  }
  for (const auto& [n, length] : beside) {
    mouth.nodes.push_back(n);
    mouth.length.push_back(length);
  }
}

/// Component of a velocity that points into the lattice.
double inward(Side side, const std::array<TimeTable, 2>& velocity) {
  switch (side) {
    case Side::left:
      return velocity[0].peak();
    case Side::right:
      return -velocity[0].peak();
    case Side::bottom:
      return velocity[1].peak();
    default:
      return -velocity[1].peak();
  }
}

/// Volume, cells, that enters through the fluid nodes of a mouth per step and unit of speed.
double volume_per_speed(const Stretch& stretch, const Mouth& mouth, const FluidPicture& picture, double spacing) {
  if (stretch.opening) return mouth.total_length();
  double sum = 0;
  for (const std::size_t n : mouth.nodes) {
    const auto at = static_cast<int>(is_upright(stretch.side) ? n / picture.nx : n % picture.nx);
    sum += share_of_cell(mouth.conditions->flow, at - stretch.first, stretch.last + 1 - stretch.first, spacing);
  }
  return sum;
}

double peak_speed_of(const FlowBoundary& flow, const Stretch& stretch, const Mouth& mouth, const FluidPicture& picture,
                     double density, const LatticeUnits& units) {
  if (!flow.has_rate()) return largest_share(flow) * flow.peak_speed() / units.velocity();
  if (mouth.nodes.empty()) return 0;
  const double volume = volume_per_speed(stretch, mouth, picture, units.spacing);
  if (volume <= 0) return std::numeric_limits<double>::infinity();
  return largest_share(flow) * std::abs(flow.peak_rate(density)) / units.diffusivity() / volume;
}

/// Largest volume that enters per step through each of the `cells` of a boundary, cells.
double inflow_of(const FlowBoundary& flow, const Stretch& stretch, double cells, double density,
                 const LatticeUnits& units) {
  if (flow.kind != FlowBoundaryKind::velocity || cells <= 0) return 0;
  if (flow.has_rate()) return flow.peak_rate(density) / units.diffusivity() / cells;
  const double speed = stretch.opening ? flow.speed.peak() : inward(stretch.side, flow.velocity);
  const double length = (stretch.last + 1 - stretch.first) * units.spacing;
  return speed / units.velocity() * mean_share(flow, length);
}

}  // namespace

std::vector<Mouth> mouths_of(const Scene& scene, const Geometry& geometry, const LatticeUnits& units,
                             const FluidPicture& picture) {
  std::vector<Mouth> mouths;
  int opening = 0;
  for (const Stretch& stretch : boundary_stretches(scene, geometry)) {
    const auto injection = std::find_if(scene.injections.begin(), scene.injections.end(),
                                        [&](const InjectionSection& own) { return own.name == stretch.name; });
    const bool injects = injection != scene.injections.end();
    Mouth mouth{stretch.opening ? "boundary.shape." + stretch.name.substr(6)
                : injects       ? injection->key
                                : "boundary." + stretch.name,
                stretch.opening                ? &geometry.openings[opening++].conditions
                : injects                      ? &injection->conditions
                : stretch.side == Side::left   ? &scene.left
                : stretch.side == Side::right  ? &scene.right
                : stretch.side == Side::bottom ? &scene.bottom
                                               : &scene.top};
    if (stretch.opening)
      look_beside_opening(*stretch.opening, geometry, picture, mouth);
    else
      look_beside_side(stretch, picture, mouth);
    if (scene.flow) {
      const FlowBoundary& flow = mouth.conditions->flow;
      mouth.inflow = inflow_of(flow, stretch, mouth.total_length(), scene.flow->density, units);
      mouth.peak_speed = peak_speed_of(flow, stretch, mouth, picture, scene.flow->density, units);
    }
    mouths.push_back(std::move(mouth));
  }
  return mouths;
}

}  // namespace vug
