#include "dem/mechanics.hpp"

#include "dem/critical_step.hpp"
#include "dem/forces.hpp"
#include "dem/materials.hpp"
#include "dem/pieces.hpp"
#include "dem/require_parameters.hpp"
#include "host/interruption.hpp"
#include "host/this_process.hpp"
#include "kernels/launch/launch.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <set>

namespace vug {

namespace {

constexpr int steps_between_stops = 100000;  // sub-steps between two looks at requests to stop
constexpr double longest_wait = 10;          // s until a lattice step ends that a stop waits for

/// Checks the parameters, and sets thermal_expansion to the largest of all materials: those of particles are relative
/// to it.
MechanicsParameters checked(MechanicsParameters parameters) {
  require_parameters(parameters);
  parameters.thermal_expansion = largest_expansion(parameters);
  return parameters;
}

/// (particle) Thermal expansion over the `largest` of all materials; empty where the rock is of one material.
ScalarField<double> relative_expansions(const Assembly& assembly, const MechanicsParameters& given, double largest) {
  if (assembly.region.empty()) return {};
  const ScalarField<double> relative("vug::dem::relative_expansion", assembly.triangles.size());
  const HostWriter host(relative);
  for (int i = 0; i < static_cast<int>(assembly.triangles.size()); ++i) {
    const double own = material_of(given, assembly, i).thermal_expansion;
    host(i) = own == largest ? 1 : own / largest;
  }
  return relative;
}

struct FollowTemperature {
  ScalarField<double> relative;
  Particles p;
  KOKKOS_FUNCTION void operator()(int i) const { p.warming(i) = relative(i) * p.temperature_change(i); }
};

/// Whether gravity acts on a piece that nothing holds: its weight is far less than bonds bear, so that it would sleep.
bool may_fall(const Loads& loads, const Particles& particles, const Bonds& bonds) {
  return (loads.gravity[0] != 0 || loads.gravity[1] != 0) && has_unsupported_piece(particles, bonds);
}

}  // namespace

Mechanics::Mechanics(const Assembly& assembly, const MechanicsParameters& parameters, const Loads& loads)
    : parameters_(checked(parameters)),
      boundary_(find_boundary(assembly)),
      particles_(make_particles(assembly, parameters)),
      relative_expansion_(relative_expansions(assembly, parameters, parameters_.thermal_expansion)),
      bonds_(make_bonds(assembly, particles_, parameters)),
      contacts_(make_contacts(particles_, bonds_, faces_itself(assembly, boundary_))),
      grid_(make_neighbour_grid(particles_, contacts_.skin)),
      loads_(apply_loads(assembly, boundary_, loads, particles_)),
      growth_(find_support_growth(assembly, boundary_, loads, particles_, parameters_.thermal_expansion)),
      outer_forces_(assembly, boundary_, loads, particles_),
      servos_(make_servo_platens(boundary_, assembly, loads, parameters.bond, bonds_)),
      timed_(make_timed_loads(assembly, boundary_, loads, particles_, loads_)),
      loss_(make_mass_loss(particles_, bonds_)),
      sound_crossing_(vug::sound_crossing(parameters, assembly)) {
  if (parameters_.energy_ledger) accounts_ = make_accounts(particles_, bonds_, contacts_);
  // a ledger needs the losses of every step, a servo the reaction in every step, and a platen that starts to move wakes
  // no rock
  const bool driven = !servos_.empty() || (timed_ && timed_->moves());
  if (parameters_.rest_tolerance > 0 && !accounts_ && !driven && !may_fall(loads, particles_, bonds_))
    rest_ = make_rest(particles_, bonds_, least_normal_strength(parameters_), loads, parameters_.rest_tolerance);
}

void Mechanics::share(const Ranks& ranks) {
  ranks_ = ranks;
  if (ranks.alone() || accounts_ || !servos_.empty()) return;
  share_.emplace(ranks, particles_, bonds_, contacts_);
  if (!rest_) return;
  rest_->particles.ours = share_->particles().ours;
  rest_->bonds.ours = rest_->due.ours = share_->bonds().ours;
}

void Mechanics::make_positions_whole(const Exec& exec) const {
  if (share_) share_->make_positions_whole(exec);
}

void Mechanics::make_whole(const Exec& exec) const {
  if (share_) share_->make_whole(exec, loss_);
}

double Mechanics::critical_step() const {
  return vug::critical_step(Exec(), parameters_, particles_, bonds_, loads_);
}

/// Takes one step. For a check of what rests, all bonds are evaluated if the rock has changed since the last one, else
/// those that are due (Rest); otherwise only those that are awake.
template <class Keeper>
void Mechanics::step(const Exec& exec, const StepControl& control, const Keeper& accounts, Rest* rest,
                     RockShare* share) {
  const bool look = rest && steps_ % steps_between_looks == 0;
  if (steps_++ % steps_between_searches == 0) search_contacts(exec, share);
  if (rest && rest->awake == 0 && !look) return;
  const Groups* const bonds = rest && !look            ? &rest->bonds
                              : rest && !rest->all_due ? &rest->due
                              : share                  ? &share->bonds()
                                                       : nullptr;
  const Groups* const particles = rest ? &rest->particles : share ? &share->particles() : nullptr;
  compute_forces(exec, parameters_, control.dt, particles_, bonds_, contacts_, accounts,
                 {bonds, share ? &share->pairs() : nullptr});
  if (look) {
    rest->all_due = false;
    look_at_rest(exec, control, bonds_, contacts_, loads_, particles_, *rest);
    if (share) share->tell_rest(exec, *rest);
    wake_bonds(exec, bonds_, *rest);
  }
  integrate(exec, control, bonds_, contacts_, loads_, particles_, accounts, particles);
  if (share) share->exchange_motion(exec);
  for (const ServoPlaten& servo : servos_) follow_pressure(exec, servo, control.dt, control.load_factor, particles_);
}

void Mechanics::step(const Exec& exec, const StepControl& control, Rest* rest, RockShare* share) {
  last_dt_ = control.dt;
  if (accounts_) {
    step(exec, control, *accounts_, rest, share);
  } else {
    step(exec, control, NoAccounts{}, rest, share);
  }
}

void Mechanics::search_contacts(const Exec& exec, RockShare* share) {
  if (share) share->prepare_search(exec);
  update_contacts(exec, grid_, particles_, bonds_, contacts_);
  if (share) share->follow_pairs(exec);
}

void Mechanics::follow_temperature(const Exec& exec) {
  if (relative_expansion_.extent(0) > 0)
    for_each_node(exec, "vug::dem::follow_temperature", particles_.count,
                  FollowTemperature{relative_expansion_, particles_});
  grow_at_supports(exec, growth_, parameters_.thermal_expansion, particles_);
}

void Mechanics::advance(const Exec& exec, double dt, int substeps, RockIs rock, int times) {
  if (rock == RockIs::changed) {
    follow_temperature(exec);
    if (rest_) rest_->all_due = true;
  }
  const StepControl control{dt, parameters_.local_damping, parameters_.mass_scaling, 1};
  const int together = share_ || timed_ ? 1 : times;
  const std::int64_t all = std::int64_t{together} * substeps;
  for (int done = 0; done < times; done += together) {
    if (share_) share_->follow_pairs(exec);
    std::int64_t looked = 0;
    const double start = steady_seconds();
    for (std::int64_t s = 0; s < all;) {
      if (ranks_.alone() && s - looked >= steps_between_stops) {  // ranks have to agree, which they do between calls
        // after the lattice step, the run saves a checkpoint; only where that is far away, what was done since the last
        // one is given up
        const double left = (steady_seconds() - start) / static_cast<double>(s) * static_cast<double>(all - s);
        if (left > longest_wait) throw_if_stop_requested();
        looked = s;
      }
      const int most = static_cast<int>(std::min<std::int64_t>(all - s, std::numeric_limits<int>::max()));
      if (const int count = alike(most); count > 1) {
        replay(exec, control, count);
        s += count;
        continue;
      }
      if (timed_) follow_loads(exec, *timed_, time_ + static_cast<double>(s) * dt, dt, loads_, particles_);
      step(exec, control, rest_ ? &*rest_ : nullptr, share_ ? &*share_ : nullptr);
      ++s;
    }
    for (int t = 0; t < together; ++t) time_ += dt * substeps;
  }
}

/// Energy that contacts store at the present outlines, plus what they have lost to friction so far.
double Mechanics::contact_energy(const Exec& exec) const {
  compute_contact_forces(exec, parameters_, 0, particles_, bonds_, contacts_, *accounts_);
  exec.fence("vug::dem::contact_energy");
  return sum_in_order(contacts_.energy) + sum_in_order(accounts_->pair_friction);
}

void Mechanics::dissolve(const Exec& exec, double dt, const ScalarField<double>& solid_fraction,
                         const ScalarField<double>& d_c) {
  if (accounts_) lost_contact_energy_ += contact_energy(exec);
  take_mass(exec, solid_fraction, d_c, parameters_.mass_scaling,
            {parameters_.bond, parameters_.thermal_expansion, dt, particles_, bonds_}, loss_);
  if (accounts_) lost_contact_energy_ -= contact_energy(exec);
}

void Mechanics::set_platen_velocity(RockSide side, std::array<double, 2> velocity) {
  vug::set_platen_velocity(boundary_, side, velocity, particles_);
}

void Mechanics::set_velocity(const std::vector<int>& triangles, std::array<double, 2> velocity) {
  const auto v = on_host(particles_.v);
  for (const int i : triangles)
    for (std::size_t axis = 0; axis < 2; ++axis) v(i, axis) = velocity[axis];
  Kokkos::deep_copy(particles_.v, v);
}

Vec2 Mechanics::reaction(RockSide side) const {
  std::set<int> held;  // a corner's triangle may have two edges on one side
  for (const BoundaryEdge& edge : boundary_) {
    if (edge.side == static_cast<int>(side)) held.insert(edge.particle);
  }
  return reaction_of({held.begin(), held.end()}, particles_);
}

Energies Mechanics::energies(const Exec& exec) const {
  Energies e = measure_energies(exec, parameters_, last_dt_, particles_, bonds_, contacts_, accounts_);
  e.initial = initial_energy_;
  const LostWithRock gone = lost();
  e.dissolved = gone.kinetic + gone.elastic + lost_contact_energy_;
  return e;
}

void Mechanics::reset_ledger(const Exec& exec) {
  vug::reset(exec, loss_);
  lost_contact_energy_ = 0;
  if (!accounts_) return;
  vug::reset(exec, *accounts_);
  const Energies e = energies(exec);
  initial_energy_ = e.kinetic + e.elastic;
}

RunawayParticle Mechanics::runaway(const Exec& exec, double largest_speed) const {
  return find_runaway(exec, particles_, largest_speed);
}

}  // namespace vug
