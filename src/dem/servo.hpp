#pragma once
// Servo platens: rigid, frictionless, and moved so that they press on the rock with a given stress.
#include "dem/bonds.hpp"
#include "dem/loads.hpp"

#include <algorithm>
#include <vector>

namespace vug {

/// Share of the stress error of the layer of bonds behind it that a platen removes in a step. The stress responds a
/// step later, s(n + 1) = s(n) - g s(n - 1): this is stable below 1, and with 1/2 an error halves in every step.
inline constexpr double servo_gain = 0.5;

/// One platen. Its outward speed is
///   v = G (p - p_wanted),  G = servo_gain / (K dt),
/// where p is the pressure on it in the last step, and K the sum of (k_n n^2 + k_t t^2) l over the bonds between held
/// and free particles, divided by the length of the platen. This is the servo of granular mechanics (Itasca, PFC):
///   v = G (sigma_measured - sigma_required),  G = alpha A / (k_n N dt).
/// Dashpots of these bonds answer to v at once, with C v, C being the sum of eta (M_n n^2 + M_t t^2) l over the length.
/// With s(n + 1) = s(n) - g s(n - 1) - G C (s(n) - s(n - 1)) this is stable for G C < 1 - g / 2. Where dashpots are
/// strong or steps short, G is therefore no more than servo_gain / C.
/// To waves it is a boundary of impedance 1 / G. Rock that keeps moving outwards at v presses with p_wanted + v / G.
struct ServoPlaten {
  int axis = 0;           ///< of its normal
  double outward = 1;     ///< sign of the outward normal
  double pressure = 0;    ///< wanted, Pa
  double length = 0;      ///< of the side at the start, m
  double compliance = 0;  ///< servo_gain / K, m/Pa
  double fluidity = 0;    ///< servo_gain / C, m/(s Pa); infinite without dashpots

  /// G for steps of dt, m/(s Pa).
  double speed_per_stress(double dt) const { return std::min(compliance / dt, fluidity); }
  IndexList held;  ///< its particles, ascending
};

/// Makes the servo platens of the loads. Throws InputError where no bond joins the triangles that one holds to others.
std::vector<ServoPlaten> make_servo_platens(const std::vector<BoundaryEdge>& boundary, const Assembly& assembly,
                                            const Loads& loads, const BondParameters& law, const Bonds& bonds);

/// Sets the platen's speed for the next step, after `dt`, from its reaction in this one. Sums in the order of `held`,
/// so that the bits are the same for any number of threads. `load_factor` scales the wanted pressure, for ramps.
void follow_pressure(const Exec& exec, const ServoPlaten& platen, double dt, double load_factor,
                     const Particles& particles);

}  // namespace vug
