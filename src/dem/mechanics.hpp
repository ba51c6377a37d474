#pragma once
// The rock as a whole: particles, bonds, loads and the loop over sub-steps.
#include "dem/bonds.hpp"
#include "dem/energy.hpp"
#include "dem/integrate.hpp"
#include "dem/loads.hpp"
#include "dem/mass_loss.hpp"
#include "dem/monitors.hpp"
#include "dem/neighbour_grid.hpp"
#include "dem/outer_forces.hpp"
#include "dem/preload_report.hpp"
#include "dem/recording.hpp"
#include "dem/rest.hpp"
#include "dem/rock_share.hpp"
#include "dem/servo.hpp"
#include "dem/support_growth.hpp"
#include "dem/timed_loads.hpp"
#include "ranks/ranks.hpp"

#include <map>
#include <optional>
#include <vector>

namespace vug {

/// Cundall's alpha while the preload comes to rest: 0.5 to 0.9 need about the same number of steps.
inline constexpr double default_preload_damping = 0.7;

/// Sub-steps between two checks of which rock rests; meanwhile a wave passes some ten triangles.
inline constexpr int steps_between_looks = 16;

/// Sub-steps between two searches for contacts. None is missed while no particle moves by a quarter of the skin, a
/// twentieth of an edge, in so many: at 0.3 of the critical step up to some 0.014 of the speed of sound, 47 m/s in the
/// paper's rock at mass_scaling 1. Pieces that are faster, though far below runaway_speed, may overlap until the next.
inline constexpr int steps_between_searches = 50;

/// Whether the rock has changed since the last call of Mechanics::advance.
enum class RockIs { changed, the_same };

/// Mechanics of bonded triangles. The coupling writes force, torque and temperature_change of `particles()`, calls
/// `dissolve` when solid has been lost, then `advance`.
class Mechanics {
 public:
  /// Throws InputError for an assembly that is no triangulation or parameters that are out of range.
  Mechanics(const Assembly& assembly, const MechanicsParameters& parameters, const Loads& loads);

  /// Makes `advance` move only this rank's share of the rock from now on. Nothing is shared where a ledger sums up
  /// losses or a servo moves platens. Called by all ranks. Where rock is shared, `advance` and `make_whole` wait for
  /// the other ranks.
  void share(const Ranks& ranks);
  /// Whether this rank moves the particle.
  bool moves(int particle) const { return !share_ || share_->moves(particle); }
  /// Brings positions and damage of all rock to all ranks, for analyses of cracks and fragments.
  void make_positions_whole(const Exec& exec) const;
  /// Brings the whole state to all ranks; call it before anything else reads the state.
  void make_whole(const Exec& exec) const;

  /// Lower bound of the largest stable time step at the current masses, s; use at most 0.3 of it.
  double critical_step() const;

  /// Takes `substeps` steps of dt with constant outside forces and temperatures. A step is two kernels; one more per
  /// servo platen, with loads that change in time and with a ledger, and two more every 50 steps. Unless ranks share
  /// the rock there is no fence, no allocation and no host copy. Where rock may sleep (parameters().rest_tolerance)
  /// every 16th step has up to three more kernels, and a host reads a count; between these checks nothing is launched
  /// on a host while all rock sleeps. `rock` says whether temperatures, solid and damage are those of the previous
  /// call; a check then need not evaluate what sleeps. On a GPU the sub-steps between searches and checks are one
  /// launch, unless loads change in time, a servo moves platens, ranks share the rock or there is a ledger.
  /// `times` > 1 does the same as that many calls between which nothing changes.
  void advance(const Exec& exec, double dt, int substeps, RockIs rock = RockIs::changed, int times = 1);

  /// Sets what is left of the solid from now on: solid_fraction (particle) and d_c (bond). Momentum and energy of what
  /// is lost are booked. Call it between steps of dt.
  void dissolve(const Exec& exec, double dt, const ScalarField<double>& solid_fraction, const ScalarField<double>& d_c);

  /// Applies boundary loads and gravity in a ramp, with Cundall's local damping, and waits until the rock is at rest.
  /// Velocities are then zero; u_reference and angle_reference hold the displacements and rotations reached. Throws
  /// Interrupted.
  PreloadReport preload(const Exec& exec, double ramp_time, double damping = default_preload_damping);

  /// Solves for the state at the end of the preload, where the loads balance, instead of computing the path to it.
  /// Returns false and restores the state (visit_state) where this does not find that state (see
  /// find_static_equilibrium), where servos move platens, or where it would damage a bond: how far damage goes then
  /// depends on the path.
  bool preload_statically(const Exec& exec);

  /// Report of the last ramped preload; empty where there was none, as after preload_statically.
  const std::optional<PreloadReport>& ramped() const { return ramped_; }

  /// Sets the velocity of the platen of a held side from now on, m/s.
  void set_platen_velocity(RockSide side, std::array<double, 2> velocity);
  /// Sets the velocity of the listed triangles, m/s; not their spin.
  void set_velocity(const std::vector<int>& triangles, std::array<double, 2> velocity);
  /// Force that holds a side, N per m of thickness.
  Vec2 reaction(RockSide side) const;
  /// What stresses, springs and supports of the sides add to the stress of triangles (mean_stress.hpp), for output.
  ForceMoments outer_moments() const { return outer_forces_.moments(particles_, time_); }
  /// The energy ledger, J per m; work and losses only with parameters().energy_ledger.
  Energies energies(const Exec& exec) const;
  /// Restarts the ledger from the present state.
  void reset_ledger(const Exec& exec);
  /// The first particle whose motion is not finite or faster than `largest_speed`.
  RunawayParticle runaway(const Exec& exec, double largest_speed) const;
  /// What has been lost with the rock that dissolved; not for use inside a step.
  LostWithRock lost() const { return lost_with_rock(particles_, loss_); }
  BondCounts bond_counts() const { return count_bonds(bonds_); }
  /// Share of the groups of triangles that are awake.
  double awake_share() const { return rest_ ? vug::awake_share(*rest_) : 1.0; }

  const Particles& particles() const { return particles_; }
  const Bonds& bonds() const { return bonds_; }
  const Contacts& contacts() const { return contacts_; }
  const MechanicsParameters& parameters() const { return parameters_; }
  const std::vector<BoundaryEdge>& boundary() const { return boundary_; }
  const std::vector<ServoPlaten>& servos() const { return servos_; }
  /// Calls visit(name, View) for everything that a resumed run must restore to the bit, besides time() and steps(). For
  /// indices and switches it calls visit(name, View, least, most) with the range that they may have.
  template <class Visit>
  void visit_state(const Visit& visit) const;

  double time() const { return time_; }
  /// For a resumed run.
  void set_time(double time) {
    time_ = time;
    if (share_) share_->forget_pairs();
  }
  /// Steps taken, preload included. Contacts are searched at every fiftieth, so a resumed run must continue the count.
  long steps() const { return steps_; }
  void set_steps(long steps) { steps_ = steps; }
  /// Whether the next check of what rests evaluates all bonds; a resumed run must do the same as the run it continues.
  bool all_due() const { return !rest_ || rest_->all_due; }
  void set_all_due(bool all_due) {
    if (rest_) rest_->all_due = all_due;
  }

 private:
  /// `rest` says what sleeps, `share` what other ranks move; null: no rock, as in a preload.
  void step(const Exec& exec, const StepControl& control, Rest* rest = nullptr, RockShare* share = nullptr);
  template <class Keeper>
  void step(const Exec& exec, const StepControl& control, const Keeper& accounts, Rest* rest, RockShare* share);
  void search_contacts(const Exec& exec, RockShare* share);
  /// How many of the next sub-steps, at most `most`, consist of the same two kernels; 0 or 1 where nothing is recorded.
  int alike(int most) const;
  /// Takes `count` sub-steps in one launch, which is recorded first if that has not been done for this `count` and dt.
  void replay(const Exec& exec, const StepControl& control, int count);
  long ramp(const Exec& exec, double dt, double ramp_time, double damping);
  double kinetic_over_elastic(const Exec& exec) const;
  /// Throws Interrupted where a stop was requested, on all ranks in the same of their steps.
  void end_if_asked(long step) const;
  /// End of both kinds of preload: the rock is at rest, its displacements become the reference.
  void take_as_reference(const Exec& exec);
  double contact_energy(const Exec& exec) const;
  /// Updates Particles::warming from the temperatures, and what follows from it at supports: one kernel where the rock
  /// is of several materials, and one where supports hold it.
  void follow_temperature(const Exec& exec);

  MechanicsParameters parameters_;
  Ranks ranks_;  ///< which stop together
  std::vector<BoundaryEdge> boundary_;
  Particles particles_;
  ScalarField<double> relative_expansion_;  ///< (particle) over parameters().thermal_expansion; empty: 1
  Bonds bonds_;
  Contacts contacts_;
  NeighbourGrid grid_;
  BoundaryLoads loads_;
  SupportGrowth growth_;
  OuterForces outer_forces_;
  std::vector<ServoPlaten> servos_;
  std::optional<TimedLoads> timed_;  ///< where loads change in time or platens move as given by a table
  MassLoss loss_;
  std::optional<Accounts> accounts_;
  std::optional<Rest> rest_;           ///< where rock may sleep
  std::optional<RockShare> share_;     ///< where several ranks share it
  std::map<int, Recording> recorded_;  ///< by the number of sub-steps, for recorded_dt_
  double recorded_dt_ = 0;
  double sound_crossing_ = 0;            ///< s, of the intact rock
  std::optional<PreloadReport> ramped_;  ///< the last preload by a ramp
  double initial_energy_ = 0;
  double lost_contact_energy_ = 0;  ///< lost with the outlines that dissolved; only with accounts_
  double last_dt_ = 0;
  double time_ = 0;
  long steps_ = 0;
};

template <class Visit>
void Mechanics::visit_state(const Visit& visit) const {
  visit("u", particles_.u);
  visit("u_reference", particles_.u_reference);
  visit("v", particles_.v);
  visit("angle", particles_.angle);
  visit("angle_reference", particles_.angle_reference);
  visit("spin", particles_.spin);
  if (!servos_.empty()) visit("drive", particles_.drive);
  visit("rotation", particles_.rotation);
  visit("solid_fraction", particles_.solid_fraction, 0, 1);
  visit("temperature_change", particles_.temperature_change);
  if (relative_expansion_.extent(0) > 0) visit("warming", particles_.warming);
  if (growth_.warming.extent(0) > 0) visit("support_warming", growth_.warming);
  visit("lost_momentum", loss_.momentum);
  visit("lost_kinetic", loss_.kinetic);
  visit("lost_elastic", loss_.elastic);
  visit("point_damage", bonds_.point_damage, 0, 1);
  visit("d_m", bonds_.d_m, 0, 1);
  visit("d_c", bonds_.d_c, 0, 1);
  visit("state", bonds_.state, 0, static_cast<int>(BondState::cracked_at_start));
  visit("slip", bonds_.slip);
  visit("joint", bonds_.joint, 0, static_cast<int>(faces_dissolved));
  visit("events", bonds_.events, 0, 1);
  visit("contact_status", contacts_.status, 0, 1);
  visit("contact_first", contacts_.first, 0, contacts_.capacity);
  visit("contact_other", contacts_.other, 0, particles_.count - 1);
  visit("contact_stretch", contacts_.stretch);
  visit("contact_idle_overlap", contacts_.idle_overlap);
  visit("contact_row", contacts_.row, 0, 2 * contacts_.capacity);
  visit("contact_entry", contacts_.entry, 0, 2 * contacts_.capacity - 1);
  visit("contact_u_built", contacts_.u_built);
  visit("contact_angle_built", contacts_.angle_built);
  if (!rest_) return;
  visit("awake", rest_->particles.runs, 0, 1);
  visit("bonds_awake", rest_->bonds.runs, 0, 1);
  visit("bonds_due", rest_->due.runs, 0, 1);
  visit("stress", bonds_.stress);  // of sleeping rock, for pictures and sums until the next check
  visit("contact_energy", contacts_.energy);
  visit("load", bonds_.load);
  visit("reaction", particles_.reaction);
}

}  // namespace vug
