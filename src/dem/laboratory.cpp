#include "dem/laboratory.hpp"

#include "base/require.hpp"
#include "dem/extent.hpp"
#include "dem/materials.hpp"
#include "dem/soundness.hpp"
#include "dem/splitting.hpp"
#include "dem/test_steps.hpp"
#include "host/interruption.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace vug {

namespace {

/// Measures the strain between two groups of particles from their mean distance along an axis.
struct Gauge {
  std::vector<int> group[2];
  int axis;

  double mean(const OnHost<VectorField<double>>& values, int g) const {
    double sum = 0;
    for (const int i : group[g]) sum += values(i, axis);
    return sum / static_cast<double>(group[g].size());
  }
  bool has_triangles() const { return !group[0].empty() && !group[1].empty(); }
  double strain(const Particles& p) const {
    const auto u = on_host(p.u), x0 = on_host(p.x0);
    return (mean(u, 1) - mean(u, 0)) / (mean(x0, 1) - mean(x0, 0));
  }
};

/// The gauges along x, between the flanks in the middle 60 % of the height, and along y, between 20 and 80 % of it.
std::array<Gauge, 2> gauges_of(const Particles& p, const Extent& e) {
  std::array<Gauge, 2> gauges{{{{}, 0}, {{}, 1}}};
  const auto x0 = on_host(p.x0);
  for (int i = 0; i < p.count; ++i) {
    const double across = (x0(i, 0) - e.left) / e.width(), up = (x0(i, 1) - e.bottom) / e.height();
    const bool in_middle = std::abs(up - 0.5) <= 0.3;
    if (in_middle && across < 0.15) gauges[0].group[0].push_back(i);
    if (in_middle && across > 0.85) gauges[0].group[1].push_back(i);
    if (std::abs(up - 0.2) < 0.05) gauges[1].group[0].push_back(i);
    if (std::abs(up - 0.8) < 0.05) gauges[1].group[1].push_back(i);
  }
  return gauges;
}

/// Mean height of the centroids that a platen holds.
double held_height(const Mechanics& rock, RockSide side) {
  const auto x0 = on_host(rock.particles().x0);
  double sum = 0, n = 0;
  for (const BoundaryEdge& edge : rock.boundary()) {
    if (edge.side != static_cast<int>(side)) continue;
    sum += x0(edge.particle, 1);
    n += 1;
  }
  return sum / n;
}

/// Sets the velocities of uniform straining, so that no shock starts at the platen.
void start_uniform_straining(const Particles& p, double low, double high, double speed) {
  const auto x0 = on_host(p.x0);
  const HostWriter v(p.v);
  for (int i = 0; i < p.count; ++i) v(i, 1) = -speed * (x0(i, 1) - low) / (high - low);
}

/// Takes `steps` steps, in each of which the specimen warms at its rate, but not beyond the time `end`.
void advance_warming(const Exec& exec, Mechanics& rock, double heating_rate, double dt, long steps, double end) {
  for (long s = 0; s < steps; ++s) {
    throw_if_stop_requested();
    Kokkos::deep_copy(exec, rock.particles().temperature_change, heating_rate * std::min(rock.time() + dt, end));
    rock.advance(exec, dt, 1);
  }
}

void require_consistent(const PlatenTest& test, double expansion) {
  if ((test.speed == 0) == (test.heating_rate == 0))
    throw InputError("laboratory: a specimen is strained either by the platens' speed or by its heating rate");
  if (test.heating_rate != 0 && expansion == 0)
    throw InputError("laboratory: nothing of the specimen grows when heated");
  if (test.flanks != Support::free && test.flanks != Support::servo)
    throw InputError("laboratory: flanks are confined by a membrane (free) or by servo platens");
  if (test.specimen == Specimen::disc && (test.confinement != 0 || test.heating_rate != 0 || test.speed < 0))
    throw InputError("laboratory: a disc is compressed, without confinement or heating");
  if (test.flanks == Support::servo && !(test.confinement > 0))
    throw InputError("laboratory: servo platens need a confinement to hold");
}

/// Slope of y over x by least squares, for the samples before the peak whose stress is 20 to 50 % of it. NaN where
/// there are too few of them.
double chord(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& stress,
             double strength) {
  const auto peak = static_cast<std::size_t>(std::max_element(stress.begin(), stress.end()) - stress.begin());
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t k = 0; k < peak; ++k) {
    if (stress[k] < 0.2 * strength || stress[k] > 0.5 * strength) continue;
    n += 1, sx += x[k], sy += y[k], sxx += x[k] * x[k], sxy += x[k] * y[k];
  }
  const double spread = n * sxx - sx * sx;
  if (n < 2 || !(spread > 0)) return std::numeric_limits<double>::quiet_NaN();
  return (n * sxy - sx * sy) / spread;
}

/// Whether the specimen bore half of its strength, where chord ends, only after sound had crossed it and half of it
/// once more: before, stress and strain are those of the first wave. `rate` of the strain, 1/s; `crossing`, s.
bool is_past_first_wave(const PlatenResult& result, double rate, double crossing) {
  const auto half = std::find_if(result.stress.begin(), result.stress.end(),
                                 [&](double stress) { return stress >= 0.5 * result.strength; });
  return half != result.stress.end() && result.strain[half - result.stress.begin()] >= 1.5 * rate * crossing;
}

}  // namespace

double loaded_length(const Assembly& specimen, const std::vector<BoundaryEdge>& boundary, RockSide side) {
  const int number = static_cast<int>(side), along = 1 - number % 2;
  double length = 0;
  for (const BoundaryEdge& edge : boundary)
    if (edge.side == number)
      length += std::abs(specimen.vertices[edge.vertex[1]][along] - specimen.vertices[edge.vertex[0]][along]);
  return length;
}

double flat_width(const Assembly& disc, const std::vector<BoundaryEdge>& boundary) {
  const double flats = loaded_length(disc, boundary, RockSide::top) + loaded_length(disc, boundary, RockSide::bottom);
  return std::min(1.0, 0.5 * flats / extent_of(disc).width());
}

Loads press(const PlatenTest& test) {
  Loads loads;
  loads.support[static_cast<std::size_t>(RockSide::top)] = Support::roller;
  loads.support[static_cast<std::size_t>(RockSide::bottom)] = Support::roller;
  for (const RockSide flank : {RockSide::right, RockSide::left}) {
    loads.traction[static_cast<std::size_t>(flank)] = {flank == RockSide::right ? -test.confinement : test.confinement,
                                                       0};
    loads.support[static_cast<std::size_t>(flank)] = test.flanks;
  }
  return loads;
}

PlatenResult load_between_platens(const Exec& exec, const Assembly& specimen, const MechanicsParameters& parameters,
                                  const PlatenTest& test, const LaboratoryWatch& watch) {
  const bool heated = test.heating_rate != 0;
  const double expansion = heated ? mean_expansion(parameters, specimen) : 0;
  require_consistent(test, expansion);
  const Extent extent = extent_of(specimen);
  Mechanics rock(specimen, without_rest(parameters), press(test));
  Kokkos::deep_copy(rock.bonds().d_c, test.chemical_damage);
  if (test.confinement != 0) rock.preload(exec, test.confining_time, test.confining_damping);
  const double low = held_height(rock, RockSide::bottom), high = held_height(rock, RockSide::top);
  const double sign = test.speed < 0 ? -1 : 1;
  const double rate = std::abs(test.speed) / (high - low) + std::abs(expansion * test.heating_rate);
  rock.set_platen_velocity(RockSide::top, {0, -test.speed});
  start_uniform_straining(rock.particles(), low, high, test.speed);
  rock.reset_ledger(exec);
  const bool block = test.specimen == Specimen::block;
  const double area = block ? extent.width()
                            : 0.5 * Kokkos::numbers::pi * extent.width() /
                                  splitting_share(std::asin(flat_width(specimen, rock.boundary())));
  const double flank = 0.5 * (loaded_length(specimen, rock.boundary(), RockSide::left) +
                              loaded_length(specimen, rock.boundary(), RockSide::right));
  const auto [lateral, axial] = gauges_of(rock.particles(), extent);
  const double axial_start = axial.strain(rock.particles()), lateral_start = lateral.strain(rock.particles());
  PlatenResult result;
  result.gauged = !block || (axial.has_triangles() && lateral.has_triangles());
  result.preload = rock.ramped();
  result.time_step = test.step_fraction * rock.critical_step();
  const long stride = whole_steps(test.sample_strain / (rate * result.time_step), "laboratory.sample_strain");
  const double warm_at = test.largest_strain / rate;  // s: when a heated specimen has grown by the largest strain
  const double steps_of_heating = std::ceil((1 - 1e-12) * warm_at / result.time_step);
  std::vector<double> axial_strain, lateral_strain;
  while (true) {
    if (heated) {
      const double left = steps_of_heating - static_cast<double>(result.steps);
      const long steps = static_cast<long>(std::min(static_cast<double>(stride), left));
      advance_warming(exec, rock, test.heating_rate, result.time_step, steps, warm_at);
      result.steps += steps;
    } else {
      advance_long(exec, rock, result.time_step, stride);
      result.steps += stride;
    }
    require_sound(exec, rock);
    const double force = 0.5 * (rock.reaction(RockSide::bottom).y - rock.reaction(RockSide::top).y);
    result.strain.push_back(heated ? rate * std::min(rock.time(), warm_at) : rate * rock.time());
    result.stress.push_back(sign * force / area);
    const double push = 0.5 * (rock.reaction(RockSide::left).x - rock.reaction(RockSide::right).x);
    result.confinement.push_back(test.flanks == Support::servo ? push / flank : test.confinement);
    axial_strain.push_back(-sign * (axial.strain(rock.particles()) - axial_start));
    lateral_strain.push_back(sign * (lateral.strain(rock.particles()) - lateral_start));
    const BondCounts bonds = rock.bond_counts();
    if (result.stress.back() > result.strength) {
      result.strength = result.stress.back();
      result.peak_strain = result.strain.back();
      result.bonds_at_peak = bonds;
    }
    const bool fallen =
        broken(bonds) > 0 && (result.strength <= 0 || result.stress.back() < test.stop_below * result.strength);
    const bool ended =
        heated ? static_cast<double>(result.steps) >= steps_of_heating : result.strain.back() >= test.largest_strain;
    const bool last = fallen || ended;
    if (watch) watch(rock, result, last);
    if (last) break;
  }
  result.bonds_at_end = rock.bond_counts();
  result.energies = rock.energies(exec);
  if (block && test.heating_rate == 0) {
    const bool known = is_past_first_wave(result, rate, sound_crossing(parameters, specimen));
    const auto slope = [&](const std::vector<double>& of) {
      return known ? chord(axial_strain, of, result.stress, result.strength) : std::numeric_limits<double>::quiet_NaN();
    };
    result.modulus = slope(result.stress);
    result.poisson = slope(lateral_strain);
  }
  return result;
}

Spread spread_of(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  Spread s;
  for (const double value : values) s.mean += value / n;
  for (const double value : values) s.deviation += (value - s.mean) * (value - s.mean);
  s.deviation = n > 1 ? std::sqrt(s.deviation / (n - 1)) : 0;
  return s;
}

}  // namespace vug
