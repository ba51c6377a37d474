#include "coupling/mouths.hpp"

#include "coupling/velocity_profile.hpp"

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
    const std::size_t n = picture.beside(stretch.side, i);
    if (!picture.is_fluid(n)) continue;
    mouth.nodes.push_back(n);
    mouth.length.push_back(1);
  }
}

/// Adds the fluid nodes beside an opening; the length of each is the sum of the areas of its links. Where its surface
/// moves, also what that pushes into them.
void look_beside_opening(const Opening& opening, const Geometry& geometry, const FluidPicture& picture, Mouth& mouth) {
  const Exec exec;
  const BoundaryLinks links = find_opening_links(exec, geometry.fluid, opening, D2Q9::Q);
  const auto area = on_host(link_areas(exec, geometry.fluid, opening, D2Q9::Q));
  const auto fluid = on_host(links.fluid), node = on_host(geometry.fluid.node);
  const auto direction = on_host(links.direction);
  struct Beside {
    double length = 0;
    std::array<double, 2> push{0, 0};
  };
  std::map<std::size_t, Beside> beside;
  for (int l = 0; l < links.count; ++l) {
    const int n = node(fluid(l)), q = direction(l);
    Beside& here = beside[picture.number(geometry.lattice.x(n), geometry.lattice.y(n))];
    here.length += area(l);
    for (int axis = 0; axis < 2; ++axis) here.push[axis] -= 6 * D2Q9::w(q) * D2Q9::c(q, axis);
  }
  const FlowBoundary& flow = mouth.conditions->flow;
  for (const auto& [n, here] : beside) {
    mouth.nodes.push_back(n);
    mouth.length.push_back(here.length);
    if (flow.kind == FlowBoundaryKind::wall && flow.peak_speed() > 0) mouth.push.push_back(here.push);
  }
}

/// Component of a velocity that points into the lattice; `of` takes a value from a table.
template <class Of>
double inward(Side side, const std::array<TimeTable, 2>& velocity, const Of& of) {
  const double value = of(velocity[is_upright(side) ? 0 : 1]);
  return side == Side::left || side == Side::bottom ? value : -value;
}

/// Volume, cells, that enters through the fluid nodes of a mouth per step and unit of speed.
double volume_per_speed(const Stretch& stretch, const Mouth& mouth, const FluidPicture& picture, double spacing) {
  if (stretch.opening) return mouth.total_length();
  double sum = 0;
  for (const std::size_t n : mouth.nodes) {
    const auto at = static_cast<int>(is_upright(stretch.side) ? n / picture.nx : n % picture.nx);
    sum += share_of_cell(mouth.conditions->flow, at - stretch.whole_first, stretch.whole_length(), spacing);
  }
  return sum;
}

/// What a flow rate is spread over: all parts of a side that injections divide, or the surface of an opening.
struct Spread {
  double cells = 0;   ///< of fluid
  double volume = 0;  ///< volume_per_speed
};

/// (key of the case) For all boundaries with a flow rate.
std::map<std::string, Spread> spreads_of_rates(const std::vector<Stretch>& stretches, const std::vector<Mouth>& mouths,
                                               const FluidPicture& picture, double spacing) {
  std::map<std::string, Spread> spreads;
  for (std::size_t m = 0; m < mouths.size(); ++m) {
    if (!mouths[m].conditions->flow.has_rate()) continue;
    Spread& all = spreads[mouths[m].key];
    all.cells += mouths[m].total_length();
    all.volume += volume_per_speed(stretches[m], mouths[m], picture, spacing);
  }
  return spreads;
}

double peak_speed_of(const FlowBoundary& flow, const Spread& spread, double density, const LatticeUnits& units) {
  if (!flow.has_rate()) return largest_share(flow) * flow.peak_speed() / units.velocity();
  if (spread.cells <= 0) return 0;
  const double volume = spread.volume;
  if (volume <= 0) return std::numeric_limits<double>::infinity();
  return largest_share(flow) * std::abs(flow.peak_rate(density)) / units.diffusivity() / volume;
}

/// Volume that enters per step through each of the `cells` of a boundary, cells; `of` takes a value from a table. A
/// rate is spread over all cells of its side.
template <class Of>
double inflow_of(const FlowBoundary& flow, const Stretch& stretch, double cells, double density,
                 const LatticeUnits& units, const Of& of) {
  if (flow.kind != FlowBoundaryKind::velocity || cells <= 0) return 0;
  if (flow.flow_rate) return of(*flow.flow_rate) / units.diffusivity() / cells;
  if (flow.mass_flow_rate) return of(*flow.mass_flow_rate) / density / units.diffusivity() / cells;
  const double speed = stretch.opening ? of(flow.speed) : inward(stretch.side, flow.velocity, of);
  return speed / units.velocity() * (stretch.opening ? 1 : mean_share(flow, stretch, units.spacing));
}

}  // namespace

std::vector<Mouth> mouths_of(const Scene& scene, const Geometry& geometry, const LatticeUnits& units,
                             const FluidPicture& picture) {
  std::vector<Mouth> mouths;
  const std::vector<Stretch> stretches = boundary_stretches(scene, geometry);
  int opening = 0;
  for (const Stretch& stretch : stretches) {
    const auto injection = std::find_if(scene.injections.begin(), scene.injections.end(),
                                        [&](const InjectionSection& own) { return own.name == stretch.name; });
    const bool injects = injection != scene.injections.end();
    Mouth mouth{stretch.key, stretch.opening ? &geometry.openings[opening++].conditions
                             : injects       ? &injection->conditions
                                             : &scene.side(stretch.side)};
    if (stretch.opening)
      look_beside_opening(*stretch.opening, geometry, picture, mouth);
    else
      look_beside_side(stretch, picture, mouth);
    if (!stretch.opening) mouth.side = stretch.side;
    mouth.centre = stretch.centre;
    mouths.push_back(std::move(mouth));
  }
  if (!scene.flow) return mouths;
  const std::map<std::string, Spread> spreads = spreads_of_rates(stretches, mouths, picture, units.spacing);
  for (std::size_t m = 0; m < mouths.size(); ++m) {
    Mouth& mouth = mouths[m];
    const FlowBoundary& flow = mouth.conditions->flow;
    const auto found = spreads.find(mouth.key);
    const Spread spread = found == spreads.end() ? Spread{mouth.total_length()} : found->second;
    const auto inflow = [&flow, stretch = stretches[m], cells = spread.cells, density = scene.flow->density,
                         units](const auto& of) { return inflow_of(flow, stretch, cells, density, units, of); };
    mouth.inflow = inflow([](const TimeTable& table) { return table.peak(); });
    mouth.inflow_at = [&flow, inflow](double time) {
      return flow.risen(time) * inflow([time](const TimeTable& table) { return table.at(time); });
    };
    mouth.peak_speed = peak_speed_of(flow, spread, scene.flow->density, units);
  }
  return mouths;
}

}  // namespace vug
