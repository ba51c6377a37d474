#pragma once
// Von Neumann's stability analysis: what becomes of plane waves on an unbounded lattice without walls, carried by a
// uniform velocity. One step turns the amplitudes F_q of a wave exp(i k.x) into exp(-i k.c_q) (J F)_q, J being the
// Jacobian of the collision; the wave grows where an eigenvalue is larger than one. J is taken of the kernels' own
// laws.
#include "kernels/base/choices.hpp"
#include "kernels/solute/solute.hpp"

#include <array>
#include <complex>
#include <vector>

namespace vug {

using Vector2 = std::array<double, 2>;

/// The eigenvalues, one per population, of a wave in flow of velocity u (nodes per step) with the relaxation time tau.
std::vector<std::complex<double>> flow_waves(Collision collision, double tau, const Vector2& u, const Vector2& k);

/// Those of a solute that the fluid carries by u per step of it. Set: D2Q5 or D2Q9.
template <class Set>
std::vector<std::complex<double>> solute_waves(const SoluteParameters& parameters, const Vector2& u, const Vector2& k);

/// Those of heat in fluid alone; diffusivity in nodes^2 per step of it.
template <class Set>
std::vector<std::complex<double>> heat_waves(double diffusivity, const Vector2& u, const Vector2& k);

/// The largest modulus of any of these at the given speed along 0, 22.5 and 45 degrees, over all waves that a box of
/// 24 x 24 joined nodes has.
double flow_wave_growth(Collision collision, double tau, double speed);
template <class Set>
double solute_wave_growth(const SoluteParameters& parameters, double speed);
template <class Set>
double heat_wave_growth(double diffusivity, double speed);

/// Growth per step up to which a wave counts as neutral: rounding, and what would take more than 1e5 steps to matter.
inline constexpr double neutral_growth = 1 + 1e-5;

}  // namespace vug
