#pragma once
// Flow, heat and dissolved species.
#include "base/choices.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace vug {

struct FlowSection {
  double density = 1000;                   ///< kg/m3
  double viscosity = 0;                    ///< kinematic, m2/s
  double viscosity_activation_energy = 0;  ///< J/mol, of the Arrhenius law about the reference temperature
  /// (K, m2/s); if given, `viscosity` is its value at the reference temperature.
  std::vector<std::array<double, 2>> viscosity_table;
  std::array<double, 2> gravity{0, 0};  ///< m/s2, acts on differences of density
  double thermal_expansion = 0;         ///< 1/K, of the volume
  double reference_temperature = 0;     ///< K, of density and viscosity; heat.initial_temperature unless given
  Collision collision = Collision::trt;
  std::array<double, 2> body_force{0, 0};  ///< m/s2
  double initial_pressure = 1e5;           ///< Pa, also the reference of the gauge pressure
  double speed_limit = 0.2;                ///< lattice units; 0 switches the limiter off

  bool buoyant() const { return thermal_expansion != 0 && (gravity[0] != 0 || gravity[1] != 0); }
  bool viscosity_varies() const { return viscosity_activation_energy != 0 || !viscosity_table.empty(); }
  /// Kinematic viscosity at a temperature (K), m2/s: nu exp(E_a / R (1/T - 1/T_0)), or from the table.
  double viscosity_at(double temperature) const;
  /// Lowest kinematic viscosity between two temperatures (K), m2/s: at one of them or at a point of the table between.
  double lowest_viscosity(double coldest, double hottest) const;

  /// S_p >= 1 for coarse lattices: the lattice flows under the gauge pressures of the case divided by S_p; the fluid's
  /// force on the rock, and every pressure that is written out, is multiplied by it (docs/model.md).
  double pressure_scale = 1;
};

struct HeatSection {
  ScalarVelocitySet velocity_set = ScalarVelocitySet::d2q5;
  double fluid_diffusivity = 0, solid_diffusivity = 0;            ///< m2/s
  double fluid_density = 1000, solid_density = 2500;              ///< kg/m3
  double fluid_heat_capacity = 4000, solid_heat_capacity = 1000;  ///< J/(kg K)
  double initial_temperature = 293.15;                            ///< K
};

struct Species {
  std::string name;
  double diffusivity = 0;  ///< m2/s
  double initial = 0;      ///< mol/m3
};
struct SoluteSection {
  std::vector<Species> species;
  ScalarVelocitySet velocity_set = ScalarVelocitySet::d2q5;
  /// tau_h of the lattice kinetic scheme; absent: chosen so that Lambda = 1/4
  std::optional<double> relaxation_time;
  bool advective_form = true;  ///< keep a uniform concentration uniform in a stair-step flow
  bool face_exchange = false;  ///< also conserve the solute: neighbours exchange what the advective form would create
};

}  // namespace vug
