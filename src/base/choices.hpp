#pragma once
// The forms of the lattice physics between which a case chooses. Without Kokkos, for code that only reads a case.

namespace vug {

/// Collision of the flow: how the moments that the viscosity does not determine are relaxed.
enum class Collision {
  trt,            ///< two rates with Lambda = 3/16: walls sit exactly half way at any viscosity (default)
  lallemand_luo,  ///< rates of Lallemand and Luo, more stable at low viscosity
  bgk,            ///< one rate
  regularised     ///< non-equilibrium projected on its second moment, the rest dropped
};

/// Velocities of a scalar field.
enum class ScalarVelocitySet {
  d2q5,  ///< along the axes
  d2q9   ///< diagonal ones as well
};

/// Condition of the heat at a side or an opening.
enum class HeatCondition {
  adiabatic,    ///< nothing passes
  temperature,  ///< given half way along the links
  flux,         ///< given, into the domain
  convection,   ///< Newton's law of cooling, towards a temperature beyond
  outflow,      ///< no gradient
  periodic      ///< sides only: joined to the opposite side
};

/// How a wall link reacts.
enum class ReactiveWallLaw {
  kinetic,  ///< flux from the outgoing populations, closed form: acid, product and solid balance to the last digit
  paper     ///< wall concentrations by finite differences (Eqs. 21-24): links carry acid, faces dissolve
};

/// How a velocity is distributed over a stretch of a side.
enum class VelocityShape {
  uniform,
  parabolic,  ///< 6 x (1 - x), x from 0 to 1 along the stretch: the mean is 1
  table       ///< given by the case
};

/// How a newborn fluid node gets its solute.
enum class BirthFill {
  mean,  ///< mean concentration of the old fluid neighbours (paper); creates solute, which the ledger reports
  split  ///< an equal share of the content of every old fluid neighbour; conserves
};

}  // namespace vug
