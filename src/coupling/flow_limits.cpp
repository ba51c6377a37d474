// Bounds of the flow's speed, its limits, and the guard against divergence.
#include "base/require.hpp"
#include "coupling/driving_pressure.hpp"
#include "coupling/flow_module.hpp"
#include "coupling/flow_paths.hpp"
#include "coupling/plane_waves.hpp"
#include "coupling/velocity_profile.hpp"
#include "kernels/flow/guards.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vug {

namespace {

/// Flow past a disc that leaves two thirds of a channel open is stable at a Mach number of 0.26 in the passage and
/// diverges at 0.39 (docs/stability.md).
constexpr double largest_prescribed_mach = 0.35;

/// The lowest relaxation time at which the flow in a stair-step geometry was stable, for a pressure difference in
/// lattice units (docs/stability.md).
double lowest_relaxation_time(Collision collision, double pressure) {
  if (pressure > 0.04) return 0.764;
  if (pressure > 0.01) return 0.60;
  switch (collision) {
    case Collision::trt:
      return 0.55;
    case Collision::bgk:
      return 0.52;
    case Collision::regularised:
      return 0.51;
    case Collision::lallemand_luo:
      break;
  }
  return 0.505;
}

/// Speed that a pressure gives fluid which nothing holds back, lattice units.
double bernoulli_speed(double pressure) {
  return std::sqrt(2 * pressure);
}

}  // namespace

template <class T>
void FlowModule<T>::look(const Exec& exec, const Clock& clock, const FlowExtremes& extremes) {
  // share of the velocity that is rounding (measured): it is a difference of populations that contain the pressure
  constexpr double rounding = 4 * static_cast<double>(std::numeric_limits<T>::epsilon());
  constexpr double most = 1e-3;  // otherwise all of a flow that has hardly started would be rounding
  const double noise = extremes.speed > 0 ? std::min(rounding * extremes.density / extremes.speed, most) : 0;
  gather_sums();
  Crossed crossed;
  for (StretchLinks& boundary : boundaries_) {
    const double gain = boundary.total() - boundary.looked;
    boundary.looked += gain;
    crossed.net += gain;
    crossed.all += std::abs(gain);
  }
  const double steps = steady_.interval();
  // a pore with one opening gains and loses nothing in the end: the flow through a cell face in it is then the scale
  crossed.all = std::max(crossed.all, steps * extremes.speed);
  crossed.rounding = rounding * extremes.density * std::sqrt(static_cast<double>(geometry_.fluid.count)) * steps;
  steady_.look(exec, clock, geometry_.fluid, fields_.u, extremes.speed, noise, crossed);
}

template <class T>
void FlowModule<T>::guard(const Exec& exec, const Clock& clock) {
  const Split& split = geometry_.split;
  if (steady_.on() && !split.alone()) split.make_whole(split.of_fluid(geometry_.fluid), fields_.u);
  const FlowExtremes extremes = this->extremes(exec);
  if (steady_.due(clock) && !(fills_slowly_ && geometry_.slits.count > 0)) look(exec, clock, extremes);
  if (extremes.bad < 0) return;
  int node = 0;
  Kokkos::deep_copy(node, Kokkos::subview(geometry_.fluid.node, extremes.bad));
  throw StabilityError(
      fmt::format("flow diverged at step {}: node ({}, {}) is not finite or beyond |u| = {}, |rho'| = {} (lattice "
                  "units); {}",
                  clock.step, geometry_.lattice.x(node), geometry_.lattice.y(node), speed_bound, density_bound,
                  advice_on_divergence()));
}

template <class T>
std::string FlowModule<T>::advice_on_divergence() const {
  const double pressure = driving_pressure(), speed = std::max(prescribed_speed(), paths_.passage_speed);
  if (pressure_difference() > 0 && bernoulli_speed(pressure) >= speed)
    return "lower the pressure or the time step, or ramp the pressure (boundary.*.flow.ramp_time)";
  return speed > 0 ? "lower the prescribed velocity or the time step" : "lower what drives the flow or the time step";
}

template <class T>
double FlowModule<T>::pressure_difference() const {
  std::vector<Span> given;
  for (const StretchLinks& boundary : boundaries_)
    if (const FlowBoundary& flow = boundary.stretch.conditions.flow; flow.kind == FlowBoundaryKind::pressure)
      given.push_back(pressures_of(flow, units_));
  return largest_drive(given, {});
}

template <class T>
double FlowModule<T>::driving_pressure() const {
  const Lattice& lattice = geometry_.lattice;
  std::array<double, 2> force = forces_.at_start;  // where sides are joined, it has no potential
  for (int axis = 0; axis < 2; ++axis)
    if (geometry_.fluid.periodic[axis]) force[axis] = 0;
  const auto potentials = [&](std::array<double, 2> from, std::array<double, 2> to) {
    Span span;
    for (int axis = 0; axis < 2; ++axis) {
      const double begin = -force[axis] * from[axis], end = -force[axis] * to[axis];
      span = {span.low + std::min(begin, end), span.high + std::max(begin, end)};
    }
    return span;
  };
  std::vector<Span> mouths;
  for (const StretchLinks& boundary : boundaries_) {
    const Stretch& stretch = boundary.stretch;
    if (stretch.conditions.flow.kind != FlowBoundaryKind::pressure) continue;
    std::array<double, 2> from = stretch.centre, to = stretch.centre;
    if (!stretch.opening) from[is_upright(stretch.side)] = stretch.first;
    if (!stretch.opening) to[is_upright(stretch.side)] = stretch.last + 1.0;
    const Span pressures = pressures_of(stretch.conditions.flow, units_), along = potentials(from, to);
    mouths.push_back({pressures.low + along.low, pressures.high + along.high});
  }
  return largest_drive(mouths, potentials({0, 0}, {double(lattice.nx), double(lattice.ny)}));
}

template <class T>
double FlowModule<T>::prescribed_speed() const {
  double prescribed = 0;
  for (const StretchLinks& boundary : boundaries_) {
    const FlowBoundary& flow = boundary.stretch.conditions.flow;
    double speed = flow.peak_speed() / units_.velocity();
    if (flow.has_rate() && boundary.inflow != 0)
      speed = std::abs(flow.peak_rate(section_.density) / (units_.diffusivity() * boundary.inflow));
    prescribed = std::max(prescribed, largest_share(flow) * speed);
  }
  return prescribed;
}

template <class T>
double FlowModule<T>::lowest_viscosity() const {
  return section_.lowest_viscosity(range_.coldest, range_.hottest) / units_.diffusivity();
}

template <class T>
double FlowModule<T>::largest_speed() const {
  if (is_driven()) return speed_limit();
  const double prescribed = std::max(prescribed_speed(), paths_.passage_peak);
  const double pressed = std::max(bernoulli_speed(driving_pressure()), paths_.pressed.speed / lowest_viscosity());
  const double warmed = std::max(buoyant_speed_, paths_.lasting_force_speed);
  return std::min(speed_limit(), prescribed + warmed + paths_.weight_speed + pressed);
}

template <class T>
bool FlowModule<T>::is_driven() const {
  const bool yields = std::any_of(boundaries_.begin(), boundaries_.end(), [](const StretchLinks& boundary) {
    const FlowBoundaryKind kind = boundary.stretch.conditions.flow.kind;
    return kind == FlowBoundaryKind::pressure || kind == FlowBoundaryKind::outflow;
  });
  const auto drives = [&](int axis) {
    return forces_.at_start[axis] != 0 && (yields || geometry_.fluid.periodic[axis]);
  };
  return drives(0) || drives(1);
}

template <class T>
void FlowModule<T>::limits(LimitTable& table) const {
  const double nu = section_.viscosity / units_.diffusivity();
  const double highest = pressure_difference();
  const double lowest_tau = lowest_relaxation_time(section_.collision, highest);
  const auto viscosity = [&](const std::string& where, double value) {
    table.push_back({"flow", "relaxation time tau_f" + where, 0.5 + 3 * value, "1", lowest_tau - 1e-9, 2.5,
                     "change lattice.time_step: tau - 1/2 is proportional to it"});
    table.push_back({"flow", "viscosity" + where, value, "lattice", 0, 1, "change lattice.time_step"});
  };
  viscosity("", nu);
  if (section_.viscosity_varies()) {
    viscosity(", coldest", section_.viscosity_at(range_.coldest) / units_.diffusivity());
    viscosity(", hottest", section_.viscosity_at(range_.hottest) / units_.diffusivity());
  }
  if (buoyant_speed_ > 0)
    table.push_back({"flow", "Mach number of free convection, (g beta dT L)^1/2 / c_s", std::sqrt(3.0) * buoyant_speed_,
                     "1", 0, 0.35, "lower lattice.time_step"});
  const std::string advice = std::string("lower lattice.time_step") +
                             (pathways_in_cells_ ? ", or raise flow.pressure_scale on a coarse lattice" : "");
  table.push_back({"flow", "pressure difference", highest, "lattice", 0, 0.125, advice});
  if (driving_pressure() > 0) {
    // where no wall holds the fluid back, the pressures drive any speed in the end
    const bool held = std::isfinite(paths_.pressed.speed);
    const double free = bernoulli_speed(driving_pressure()),
                 viscous = held ? paths_.pressed.speed / lowest_viscosity() : 0;
    const std::string where =
        viscous > free ? fmt::format("from {} to {}: ", paths_.pressed.from, paths_.pressed.to) : std::string();
    table.push_back({"flow", "Mach number that the pressures drive", std::sqrt(3.0) * std::max(free, viscous), "1", 0,
                     0.9, where + advice});
  }
  const auto prescribed = [&](const char* name, double speed) {
    if (speed > 0)
      table.push_back({"flow", name, std::sqrt(3.0) * speed, "1", 0, largest_prescribed_mach,
                       "lower the velocity or lattice.time_step (docs/stability.md)"});
  };
  prescribed("Mach number of the prescribed velocities", prescribed_speed());
  prescribed("Mach number in the narrowest passage", paths_.passage_speed);
  if (paths_.force_speed > 0)
    table.push_back({"flow", "Mach number that the body force can reach", std::sqrt(3.0) * paths_.force_speed, "1", 0,
                     largest_prescribed_mach,
                     "lower flow.body_force (or flow.gravity with flow.thermal_expansion) or lattice.time_step: the "
                     "speed is up to g w^2/(8 nu) in pores w wide"});
  if (paths_.weight_speed > 0)
    table.push_back({"flow", "Mach number while the weight sets in", std::sqrt(3.0) * paths_.weight_speed, "1", 0,
                     largest_prescribed_mach,
                     "lower lattice.time_step, or leave the weight out (flow.body_force 0, flow.reference_temperature "
                     "that of the start): a run starts from one pressure, and sound of up to g H/c_s builds up that of "
                     "a column of height H"});
  if (paths_.passage_pressure > 0)
    table.push_back({"flow", "pressure that the prescribed velocities need", paths_.passage_pressure, "lattice", 0,
                     0.125, "lower the velocity or lattice.time_step: 12 nu u L/n^2 along a channel of n cells"});
  if (steady_.on() && paths_.settling_steps > 0)
    table.push_back({"flow", "steps, at least, in which a change of the flow falls to 1/e", paths_.settling_steps, "1",
                     0, std::numeric_limits<double>::infinity(),
                     "use a coarser lattice or a lower viscosity in lattice units"});
  // The speed that a pressure causes is not known in advance.
  const double speed = std::max(prescribed_speed(), paths_.passage_speed);
  const auto growth = [&](double at) { return flow_wave_growth(section_.collision, 0.5 + 3 * at, speed); };
  if (speed > 0)
    table.push_back({"flow", "growth per step of a plane wave at that speed",
                     section_.viscosity_varies() ? std::max(growth(nu), growth(lowest_viscosity())) : growth(nu), "1",
                     0, neutral_growth,
                     "lower the velocity or lattice.time_step, or choose another flow.collision (docs/stability.md)"});
}

#define VUG_INSTANTIATE(T)                                       \
  template void FlowModule<T>::guard(const Exec&, const Clock&); \
  template double FlowModule<T>::prescribed_speed() const;       \
  template double FlowModule<T>::lowest_viscosity() const;       \
  template double FlowModule<T>::largest_speed() const;          \
  template bool FlowModule<T>::is_driven() const;                \
  template void FlowModule<T>::limits(LimitTable&) const;
VUG_FOR_NUMBERS(VUG_INSTANTIATE)
#undef VUG_INSTANTIATE

}  // namespace vug
