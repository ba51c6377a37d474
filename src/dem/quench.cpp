#include "dem/quench.hpp"

#include "dem/extent.hpp"
#include "dem/soundness.hpp"
#include "dem/test_steps.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace vug {

namespace {

/// Edge of an equilateral triangle of the mean area, m.
double element_of(const Assembly& slab) {
  const Extent extent = extent_of(slab);
  // 4 A / sqrt(3) = l^2
  return std::sqrt(4 / std::sqrt(3.0) * extent.width() * extent.height() / static_cast<double>(slab.triangles.size()));
}

Loads roller_at_the_mid_plane() {
  Loads loads;
  loads.support[static_cast<std::size_t>(RockSide::bottom)] = Support::roller;
  return loads;
}

/// Sets the temperature change of each triangle: mean over its corners (weight 1/12 each) and its centroid (3/4), which
/// is exact for a quadratic field.
void cool(const Assembly& slab, double top, const SlabCooling& cooling, double length, const Particles& p) {
  const HostWriter change(p.temperature_change);
  for (int i = 0; i < p.count; ++i) {
    double centroid = 0, sum = 0;
    for (const int v : slab.triangles[i]) {
      const double depth = top - slab.vertices[v][1];
      centroid += depth / 3;
      sum += cooling.change(depth, length) / 12;
    }
    change(i) = sum + 0.75 * cooling.change(centroid, length);
  }
}

/// Edges of broken bonds, without notches, as (x, depth) pairs of their ends.
std::vector<std::array<std::array<double, 2>, 2>> broken_edges(const Assembly& slab, double top, const Bonds& bonds) {
  const auto state = on_host(bonds.state);
  const auto vertex = on_host(bonds.vertex);
  std::vector<std::array<std::array<double, 2>, 2>> edges;
  for (int k = 0; k < bonds.count; ++k) {
    if (!has_broken(state(k))) continue;
    const auto &p = slab.vertices[vertex(k, 0)], &q = slab.vertices[vertex(k, 1)];
    edges.push_back({{{p[0], top - p[1]}, {q[0], top - q[1]}}});
  }
  return edges;
}

/// Number of cracks at a level: broken edges that cross it, where neighbours no farther apart than `apart` count as
/// one.
int cracks_at(double level, double apart, const std::vector<std::array<std::array<double, 2>, 2>>& edges) {
  std::vector<double> crossings;
  for (const auto& [p, q] : edges) {
    if ((p[1] - level) * (q[1] - level) > 0 || p[1] == q[1]) continue;
    crossings.push_back(p[0] + (q[0] - p[0]) * (level - p[1]) / (q[1] - p[1]));
  }
  std::sort(crossings.begin(), crossings.end());
  int count = 0;
  double last = -2 * apart;
  for (const double x : crossings) {
    if (x - last > apart) ++count;
    last = x;
  }
  return count;
}

}  // namespace

void require_depth_for_cracks(const Assembly& slab, const std::string& where) {
  const double edges = extent_of(slab).height() / element_of(slab);
  if (edges > 2) return;
  throw InputError(
      where + ": the slab is " + std::to_string(edges) +
      " edges of its triangles high; a quench counts cracks from two edges below the face on: mesh it finer");
}

long steps_of_quench(const QuenchTest& test, double time_step, const std::string& where) {
  const long steps = whole_steps(test.duration / time_step, where + ".duration");
  if (steps < test.samples)
    throw InputError(where + ".samples = " + std::to_string(test.samples) + " is more than the steps of the quench, " +
                     std::to_string(steps) + "; lower it, or raise the duration");
  return steps;
}

QuenchResult quench(const Exec& exec, const Assembly& slab, MechanicsParameters parameters, const QuenchTest& test,
                    const QuenchWatch& watch) {
  require_depth_for_cracks(slab, "laboratory");
  parameters.local_damping = test.local_damping;
  Mechanics rock(slab, without_rest(parameters), roller_at_the_mid_plane());
  Kokkos::deep_copy(rock.bonds().d_c, test.chemical_damage);
  const auto [left, bottom, right, top] = extent_of(slab);
  const SlabCooling cooling(test.drop, top - bottom, test.biot);
  QuenchResult result;
  result.time_step = test.step_fraction * rock.critical_step();
  const long all = steps_of_quench(test, result.time_step, "laboratory");
  const auto steps_until = [&](int sample) {
    return static_cast<long>(static_cast<double>(all) * sample / test.samples);
  };
  for (int sample = 1; sample <= test.samples; ++sample) {
    const double length = test.final_length * std::sqrt((sample - 0.5) / test.samples);
    cool(slab, top, cooling, length, rock.particles());
    advance_long(exec, rock, result.time_step, steps_until(sample) - result.steps);
    require_sound(exec, rock);
    result.steps = steps_until(sample);
    if (watch) watch(rock, length, sample == test.samples);
  }
  const auto edges = broken_edges(slab, top, rock.bonds());
  const double element = element_of(slab), surface = 2 * element;
  for (double level = surface; level < top - bottom; level += 0.25 * element) {
    result.depth.push_back(level);
    result.cracks.push_back(cracks_at(level, element, edges));
    if (result.cracks.back() > 0) result.deepest = level;
  }
  const double first = result.cracks.front();
  double area = 0;
  for (std::size_t i = 1; i < result.cracks.size(); ++i) area += std::min(result.cracks[i], first) * 0.25 * element;
  result.spacing = first > 0 ? (right - left) / first : 0;
  result.mean_depth = first > 0 ? surface + area / first : 0;
  result.bonds_at_end = rock.bond_counts();
  return result;
}

}  // namespace vug
