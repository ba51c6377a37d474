#pragma once
// The only place where SI and lattice units are converted: one line per quantity.
#include <cmath>

namespace vug {

/// Factors between SI and lattice units (spacing = time step = density = 1). Thickness is 1 m: forces are N per metre.
/// A coarse lattice may compute with pressures divided by `pressure_scale`; `pressure` and `force` undo that, so that
/// callers use physical pascals and newtons only (docs/model.md, "Coarse lattices").
struct LatticeUnits {
  double spacing = 1;                ///< m
  double time_step = 1;              ///< s
  double fluid_density = 1;          ///< kg/m3
  double reference_pressure = 0;     ///< Pa; lattice pressures are differences from it
  double pressure_scale = 1;         ///< factor by which pressures on the lattice are reduced
  double reference_temperature = 0;  ///< K; lattice temperatures are differences from it, in kelvin
  double concentration = 1;          ///< mol/m3 of one lattice unit of concentration

  double velocity() const { return spacing / time_step; }                    ///< m/s
  double acceleration() const { return spacing / (time_step * time_step); }  ///< m/s2
  double diffusivity() const { return spacing * spacing / time_step; }       ///< m2/s, viscosity as well
  double pressure() const { return fluid_density * velocity() * velocity() * pressure_scale; }  ///< Pa
  double force() const { return pressure() * spacing; }       ///< N/m: force per metre of thickness
  double volume() const { return spacing * spacing; }         ///< m3/m: one node
  double amount() const { return concentration * volume(); }  ///< mol/m
  double rate_constant() const { return velocity(); }         ///< m/s, of a surface reaction

  /// Lattice pressure from a physical one (Pa, absolute).
  double lattice_pressure(double pa) const { return (pa - reference_pressure) / pressure(); }
  double lattice_temperature(double kelvin) const { return kelvin - reference_temperature; }
};

inline constexpr double gas_constant = 8.314462618;  ///< J/(mol K)

}  // namespace vug
