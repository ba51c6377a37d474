#pragma once
// Conditions on the sides of the lattice, on stretches of them and on the surfaces of named shapes.
#include "base/choices.hpp"
#include "base/side.hpp"
#include "dem/support.hpp"
#include "io/time_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vug {

enum class FlowBoundaryKind { wall, pressure, velocity, outflow, periodic };
struct FlowBoundary {
  FlowBoundaryKind kind = FlowBoundaryKind::wall;
  TimeTable pressure;                  ///< Pa, absolute
  std::array<TimeTable, 2> velocity;   ///< m/s (wall: tangential speed of a moving wall)
  double ramp_time = 0;                ///< s, over which pressure or velocity rise from the values of fluid at rest
  TimeTable speed;                     ///< m/s, of fluid that flows out of an opening across its surface
  std::optional<TimeTable> flow_rate;  ///< m2/s: volume per depth that enters; then velocity and speed are 0
  std::optional<TimeTable> mass_flow_rate;  ///< kg/(m s), likewise
  VelocityShape profile = VelocityShape::uniform;
  std::vector<std::array<double, 2>> profile_table;  ///< (m along the stretch, share of the velocity)

  /// The flow rate that is given, whichever it is; null: none.
  const TimeTable* given_rate() const { return flow_rate ? &*flow_rate : mass_flow_rate ? &*mass_flow_rate : nullptr; }
  bool has_rate() const { return given_rate() != nullptr; }
  /// Prescribed volume per depth that enters, m2/s.
  double rate(double density, double time) const {
    return flow_rate ? flow_rate->at(time) : mass_flow_rate ? mass_flow_rate->at(time) / density : 0.0;
  }
  double peak_rate(double density) const {
    return flow_rate ? flow_rate->peak() : mass_flow_rate ? mass_flow_rate->peak() / density : 0.0;
  }
  /// Largest prescribed velocity or speed, m/s.
  double peak_speed() const {
    return std::max(std::hypot(velocity[0].peak(), velocity[1].peak()), std::abs(speed.peak()));
  }
  /// Calls visit(table) for everything that may change in time, besides the ramp.
  template <class Visit>
  void for_each_table(const Visit& visit) const {
    for (const TimeTable* table : {&pressure, &velocity[0], &velocity[1], &speed}) visit(*table);
    if (flow_rate) visit(*flow_rate);
    if (mass_flow_rate) visit(*mass_flow_rate);
  }
  /// Time after which nothing of it changes, s.
  double settled() const {
    double last = ramp_time;
    for_each_table([&](const TimeTable& table) { last = std::max(last, table.settled()); });
    return last;
  }
  /// Share of its value that a ramp has reached at a time (s).
  double risen(double time) const { return ramp_time > 0 ? std::min(1.0, time / ramp_time) : 1.0; }
};
/// Whether fluid may cross it.
inline bool is_open(const FlowBoundary& flow) {
  return flow.kind == FlowBoundaryKind::pressure || flow.kind == FlowBoundaryKind::outflow ||
         flow.kind == FlowBoundaryKind::velocity;
}
/// Whether a given velocity or flow rate draws fluid out at some time, through a side or, without one, an opening.
inline bool draws(const FlowBoundary& flow, std::optional<Side> side) {
  if (flow.kind != FlowBoundaryKind::velocity) return false;
  if (const TimeTable* rate = flow.given_rate()) return rate->lowest() < 0;
  if (!side) return flow.speed.lowest() < 0;
  const TimeTable& across = flow.velocity[is_upright(*side) ? 0 : 1];
  return *side == Side::left || *side == Side::bottom ? across.lowest() < 0 : across.highest() > 0;
}
struct HeatBoundary {
  HeatCondition kind = HeatCondition::adiabatic;
  TimeTable temperature;   ///< K
  TimeTable flux;          ///< W/m2 into the domain
  double coefficient = 0;  ///< W/(m2 K) of convection beyond the side, where the fluid has the temperature given
};
enum class SoluteBoundaryKind { no_flux, concentration, flux, outflow, periodic };
struct SoluteBoundary {
  SoluteBoundaryKind kind = SoluteBoundaryKind::no_flux;
  std::map<std::string, TimeTable> concentration;  ///< mol/m3 by species; missing species: 0
  std::map<std::string, TimeTable> flux;           ///< mol/(m2 s) into the lattice, by species; missing species: 0
};
struct TractionLoad {
  Support support = Support::free;
  TimeTable normal_stress;            ///< Pa, compression positive
  TimeTable shear_stress;             ///< Pa, on the rock along the side: positive to the right, or up
  double stiffness = 0;               ///< Pa/m, of the rock beyond: additional stress per outward displacement
  std::array<TimeTable, 2> velocity;  ///< m/s, velocity of a held side after the preload
};
struct TractionPart {
  double from = 0, to = 0;  ///< m along the side; equal: the one triangle there
  TractionLoad load;
};
struct TractionBoundary {
  TractionLoad load;
  std::vector<TractionPart> parts;  ///< with their own loads; where they overlap, the later one counts
};
struct BoundarySection {
  FlowBoundary flow;
  HeatBoundary heat;
  SoluteBoundary solute;
  TractionBoundary traction;
};
/// A stretch of one side with its own conditions.
struct InjectionSection {
  std::string key = "boundary.injection";  ///< of its table
  std::string name = "injection";          ///< for columns of the history and names of state blocks
  Side side = Side::left;
  double centre = 0;  ///< m along the side
  double width = 0;   ///< m
  BoundarySection conditions;
};

/// The conditions on the surface of a named shape.
struct OpeningSection {
  int shape = 0;  ///< index in GeometrySection::shapes
  BoundarySection conditions;
};

}  // namespace vug
