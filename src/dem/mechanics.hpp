#pragma once
// The rock as one moving thing: particles, bonds, loads and the loop over sub-steps.
#include "dem/bonds.hpp"
#include "dem/energy.hpp"
#include "dem/integrate.hpp"
#include "dem/loads.hpp"
#include "dem/monitors.hpp"
#include "dem/neighbour_grid.hpp"

#include <optional>
#include <vector>

namespace vug {

/// How the preload ended.
struct PreloadReport {
  long steps = 0;
  bool settled = false;  ///< kinetic energy fell below 1e-9 of the elastic one
  double kinetic_over_elastic = 0;
  BondCounts bonds;  ///< damage that the preload did
};

/// Mechanics of bonded triangles. The coupling writes force, torque, solid_fraction and temperature_change of
/// `particles()` and d_c of `bonds()`, then calls `advance`.
class Mechanics {
 public:
  /// Throws InputError for an assembly that is no triangulation or parameters that are out of range.
  Mechanics(const Assembly& assembly, const MechanicsParameters& parameters, const Loads& loads);

  /// Safe bound of the largest stable time step at the current masses, s; take at most 0.3 of it.
  double critical_step() const;

  /// Takes `substeps` steps of dt with outside forces and temperatures held. Three kernels each and two more every 50
  /// steps; no fence, no allocation, no host copy.
  void advance(const Exec& exec, double dt, int substeps);

  /// Puts boundary loads and gravity on the rock in a ramp, with local damping 0.7, and waits until it is at rest.
  /// Velocities are then zero and u_reference holds the displacements reached.
  PreloadReport preload(const Exec& exec, double ramp_time);

  /// Velocity of the platen of a held side from now on, m/s.
  void set_platen_velocity(RockSide side, std::array<double, 2> velocity);
  /// Force that holds a side, N per m of thickness.
  Vec2 reaction(RockSide side) const;
  /// The energy ledger, J per m; work and losses only with parameters().energy_ledger.
  Energies energies(const Exec& exec) const;
  /// Starts the ledger anew from the present state.
  void reset_ledger(const Exec& exec);
  /// The first particle that is not finite or faster than `largest_speed`.
  RunawayParticle runaway(const Exec& exec, double largest_speed) const;
  BondCounts bond_counts() const { return count_bonds(bonds_); }

  const Particles& particles() const { return particles_; }
  const Bonds& bonds() const { return bonds_; }
  const Contacts& contacts() const { return contacts_; }
  const MechanicsParameters& parameters() const { return parameters_; }
  const std::vector<BoundaryEdge>& boundary() const { return boundary_; }
  double time() const { return time_; }

  /// Calls view(name, View) and value(name, number &) for all that a restart needs beyond construction.
  template <class OnView, class OnValue>
  void visit_state(const OnView& view, const OnValue& value);

 private:
  void step(const Exec& exec, const StepControl& control);
  template <class Keeper>
  void step(const Exec& exec, const StepControl& control, const Keeper& accounts);
  long ramp(const Exec& exec, double dt, double ramp_time);
  double kinetic_over_elastic(const Exec& exec) const;

  MechanicsParameters parameters_;
  std::vector<BoundaryEdge> boundary_;
  Particles particles_;
  Bonds bonds_;
  Contacts contacts_;
  NeighbourGrid grid_;
  BoundaryLoads loads_;
  std::optional<Accounts> accounts_;
  double initial_energy_ = 0;
  double last_dt_ = 0;
  double time_ = 0;
  long steps_ = 0;
};

template <class OnView, class OnValue>
void Mechanics::visit_state(const OnView& view, const OnValue& value) {
  const Particles& p = particles_;
  view("u", p.u);
  view("u_reference", p.u_reference);
  view("v", p.v);
  view("angle", p.angle);
  view("spin", p.spin);
  view("rotation", p.rotation);
  view("solid_fraction", p.solid_fraction);
  view("temperature_change", p.temperature_change);
  const Bonds& b = bonds_;
  view("point_damage", b.point_damage);
  view("d_m", b.d_m);
  view("d_c", b.d_c);
  view("state", b.state);
  view("joint", b.joint);
  view("events", b.events);
  view("slip", b.slip);
  view("stress", b.stress);
  const Contacts& c = contacts_;
  view("contact_status", c.status);
  view("contact_first", c.first);
  view("contact_other", c.other);
  view("contact_stretch", c.stretch);
  view("contact_row", c.row);
  view("contact_entry", c.entry);
  view("contact_u_built", c.u_built);
  view("contact_angle_built", c.angle_built);
  value("last_dt", last_dt_);
  value("time", time_);
  value("steps", steps_);
}

}  // namespace vug
