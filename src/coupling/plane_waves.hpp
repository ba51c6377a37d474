#pragma once
// Von Neumann's stability analysis of plane waves on an unbounded lattice without walls, carried by a uniform velocity.
// One step turns the amplitudes F_q of a wave exp(i k.x) into exp(-i k.c_q) (J F)_q, with J the Jacobian of the
// collision; the wave grows where the modulus of an eigenvalue exceeds one. J is computed from the collisions of the
// kernels.
#include "base/choices.hpp"
#include "kernels/solute/solute.hpp"

#include <array>
#include <complex>
#include <vector>

namespace vug {

using Vector2 = std::array<double, 2>;

/// The eigenvalues, one per population, of a wave in flow of velocity u (nodes per step) with the relaxation time tau.
std::vector<std::complex<double>> flow_waves(Collision collision, double tau, const Vector2& u, const Vector2& k);

/// The same for a solute that the fluid carries by u per solute step. Set: D2Q5 or D2Q9.
template <class Set>
std::vector<std::complex<double>> solute_waves(const SoluteParameters& parameters, const Vector2& u, const Vector2& k);

/// The same for heat in fluid only; diffusivity in nodes^2 per heat step.
template <class Set>
std::vector<std::complex<double>> heat_waves(double diffusivity, const Vector2& u, const Vector2& k);

/// The largest modulus of the eigenvalues at the given speed along 0, 22.5 and 45 degrees, over all waves of a periodic
/// box of 24 x 24 nodes.
double flow_wave_growth(Collision collision, double tau, double speed);
template <class Set>
double solute_wave_growth(const SoluteParameters& parameters, double speed);
template <class Set>
double heat_wave_growth(double diffusivity, double speed);

/// Growth per step up to which a wave counts as neutral: rounding, and growth that needs more than 1e5 steps to matter.
inline constexpr double neutral_growth = 1 + 1e-5;

}  // namespace vug
