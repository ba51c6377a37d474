#include "coupling/rock_gauges.hpp"

#include "base/require.hpp"
#include "coupling/rock_loads.hpp"
#include "dem/mean_stress.hpp"
#include "io/form.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vug {

namespace {

using Point = std::array<double, 2>;

Vec2 vec(const Point& p) {
  return {p[0], p[1]};
}

/// Distance of a point from a triangle over the triangle's size; negative inside.
double outside(const Triangle& triangle, Vec2 point) {
  double worst = -std::numeric_limits<double>::infinity();
  for (int c = 0; c < 3; ++c) {
    const Vec2 a = triangle.corner[c], b = triangle.corner[(c + 1) % 3];
    worst = std::max(worst, -cross(b - a, point - a) / triangle.area());
  }
  return worst;
}

/// The triangle that holds a point, to a millionth of its size.
int triangle_at(const Assembly& assembly, const Point& point, const std::string& what) {
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int t = 0; t < static_cast<int>(assembly.triangles.size()); ++t) {
    const double off = outside(triangle_of(assembly, t), vec(point));
    if (off < least) least = off, best = t;
  }
  if (least > 1e-6)
    throw InputError(
        fmt::format("{}: the point ({:g}, {:g}) m lies in no triangle of the rock", what, point[0], point[1]));
  return best;
}

RockPoint rock_point(const Assembly& assembly, const Point& point, const std::string& what) {
  const int t = triangle_at(assembly, point, what);
  return {t, vec(point) - triangle_of(assembly, t).centroid()};
}

IndexList triangles_of(const Gauge& gauge, const Assembly& assembly, const std::string& what) {
  if (!gauge.region) return to_device<IndexList>("vug::rock_gauges::members", {triangle_at(assembly, gauge.at, what)});
  std::vector<int> members;
  for (int t = 0; t < static_cast<int>(assembly.triangles.size()); ++t) {
    const Vec2 centroid = triangle_of(assembly, t).centroid();
    if (holds(*gauge.region, {centroid.x, centroid.y}, 0)) members.push_back(t);
  }
  if (members.empty()) throw InputError(what + ": the shape holds the centroid of no triangle");
  return to_device<IndexList>("vug::rock_gauges::members", members);
}

/// Particles with an edge on the side whose middle is between `first` and `last`: those that the side holds along x and
/// those along y. Two halves of a side add up to the whole, and the sides to the force that holds the rock.
std::array<IndexList, 2> held_particles(const Gauge& gauge, const Assembly& assembly, const Mechanics& rock,
                                        const Loads& loads, const std::string& what) {
  constexpr double far = std::numeric_limits<double>::infinity();
  const RockSide side = rock_side(gauge.side);
  std::vector<int> held;
  for (const BoundaryEdge& edge : rock.boundary()) {
    if (edge.side != static_cast<int>(side)) continue;
    const int along = edge.side % 2 == 0 ? 1 : 0;
    const double middle = 0.5 * (assembly.vertices[edge.vertex[0]][along] + assembly.vertices[edge.vertex[1]][along]);
    if (middle < gauge.first.value_or(-far) || middle >= gauge.last.value_or(far)) continue;
    held.push_back(edge.particle);
  }
  std::sort(held.begin(), held.end());  // a triangle in a corner may have two edges on one side
  held.erase(std::unique(held.begin(), held.end()), held.end());
  if (held.empty())
    throw InputError(fmt::format("{}: the rock has no edge with its middle on this stretch of the {} side", what,
                                 name_of(gauge.side)));
  const std::vector<LoadedPiece> pieces = pieces_of_boundary(assembly, rock.boundary(), loads, rock.particles());
  const std::vector<AxesOfSides> axes = axes_held(pieces, loads, rock.particles().count);
  std::array<IndexList, 2> lists;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    std::vector<int> members;
    for (const int i : held)
      if ((axes[static_cast<std::size_t>(i)][static_cast<std::size_t>(side)] & 1 << axis) != 0) members.push_back(i);
    lists[axis] = to_device<IndexList>("vug::rock_gauges::held", members);
  }
  return lists;
}

}  // namespace

RockGauges::RockGauges(const Scene& scene, const Assembly& assembly, const Mechanics& rock) {
  for (std::size_t g = 0; g < scene.output.gauges.size(); ++g) {
    const Gauge& gauge = scene.output.gauges[g];
    const std::string what = fmt::format("{}: output.gauges.{}", scene.path, g), name = gauge.name;
    const Particles particles = rock.particles();
    const Bonds bonds = rock.bonds();
    const Mechanics* const whole = &rock;  // which the module that has these gauges owns
    const double expansion = rock.parameters().thermal_expansion;
    const auto two = [name](const char* first, const char* second, const char* unit, auto&& measure) -> Read {
      return [=](const Exec& exec, std::vector<HistoryValue>& row) {
        const Vec2 value = measure(exec);
        row.push_back({name + first + unit, value.x});
        row.push_back({name + second + unit, value.y});
      };
    };
    switch (gauge.kind) {
      case GaugeKind::displacement: {
        const RockPoint point = rock_point(assembly, gauge.at, what);
        gauges_.push_back(two("_x", "_y", "_m",
                              [=](const Exec& exec) { return displacement_of(exec, particles, expansion, point); }));
        break;
      }
      case GaugeKind::opening: {
        const RockPoint a = rock_point(assembly, gauge.from, what), b = rock_point(assembly, gauge.to, what);
        const Vec2 apart = vec(gauge.to) - vec(gauge.from), n = (1 / norm(apart)) * apart, t{-n.y, n.x};
        gauges_.push_back(two("_opening", "_sliding", "_m", [=](const Exec& exec) {
          const Vec2 moved =
              displacement_of(exec, particles, expansion, b) - displacement_of(exec, particles, expansion, a);
          return Vec2{dot(moved, n), dot(moved, t)};
        }));
        break;
      }
      case GaugeKind::reaction: {
        const std::array<IndexList, 2> held = held_particles(gauge, assembly, rock, boundary_loads(scene), what);
        gauges_.push_back(
            two("_x", "_y", "_N_per_m", [=](const Exec& exec) { return reaction_of(exec, particles, held); }));
        break;
      }
      case GaugeKind::crack_tip: {
        const Vec2 direction = vec(gauge.direction), unit = (1 / norm(direction)) * direction, from = vec(gauge.from);
        gauges_.push_back(two("_x", "_y", "_m", [=](const Exec& exec) {
          return furthest_crack_tip(exec, particles, bonds, from, unit);
        }));
        break;
      }
      case GaugeKind::stress: {
        const IndexList members = triangles_of(gauge, assembly, what);
        gauges_.push_back([=](const Exec& exec, std::vector<HistoryValue>& row) {
          const Stress stress = mean_stress(exec, particles, bonds, members, whole->outer_moments());
          row.push_back({name + "_xx_Pa", stress.xx});
          row.push_back({name + "_yy_Pa", stress.yy});
          row.push_back({name + "_xy_Pa", stress.xy});
        });
        break;
      }
    }
  }
}

void RockGauges::history(std::vector<HistoryValue>& row) const {
  const Exec exec;
  for (const Read& gauge : gauges_) gauge(exec, row);
}

}  // namespace vug
