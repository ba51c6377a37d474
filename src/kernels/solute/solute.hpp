#pragma once
// Transport of one dissolved species over the fluid nodes: the lattice kinetic scheme (paper Eqs. 14-20) as one sweep
// over any velocity set.
//
// Order within a lattice step: dress the outgoing populations in `h` (solute_boundary.hpp), then advance_solute, which
// pulls, collides and stores in place (streaming.hpp), then react_at_wall (reactive_wall.hpp), which dresses the
// populations that have just gone out. Births come between two steps (dissolution.hpp).
#include "base/velocity_set.hpp"
#include "kernels/nodes/fluid_nodes.hpp"
#include "kernels/scalar/rounding.hpp"
#include "kernels/scalar/scalar_equilibrium.hpp"

#include <optional>

namespace vug {

/// Relaxation times of the lattice kinetic scheme. Its closed form relaxes the first moment with tau_1 and every other
/// moment with tau_h; the paper's adjustable factor is tau_B = tau_h - tau_1.
struct SoluteParameters {
  double tau_1 = 1;    ///< of the first moment: 1/2 + 3 D (Eq. 19 with tau_1 = tau_h - tau_B)
  double tau_h = 1;    ///< of all other moments
  double carried = 1;  ///< factor of the displacement in the collision (turning.hpp)
  double diffusivity() const { return (tau_1 - 0.5) / 3; }
};

/// Relaxation times for a diffusivity in lattice units and tau_h > 1/2 (paper Table 2); without a tau_h that for which
/// (tau_1 - 1/2)(tau_h - 1/2) = 1/4: then halfway walls lie half way and transport is linearly stable for every
/// diffusivity. Throws InputError unless D > 0.
SoluteParameters solute_parameters(double D, std::optional<double> tau_h = {});

/// Parameters of the one step after which a step takes `stretch` times as many lattice steps (turning.hpp); for D2Q5
/// and a tau_h that follows from the diffusivity.
SoluteParameters turning_parameters(const SoluteParameters& parameters, double stretch);

/// Populations and concentration of one species on the fluid nodes.
template <class T>
struct SoluteFields {
  ScalarField<T> h;            ///< (q * capacity + fluid) post-collision populations, outgoing
  int turned = 0;              ///< 1 after an odd number of steps (streaming.hpp); belongs to h in a checkpoint
  ScalarField<T> C;            ///< (fluid) concentration of the last sweep
  StepRounding<T> rounding{};  ///< of the next step
};

/// Fields of one species for `nodes`, at rest with a uniform concentration.
template <class Set, class T>
SoluteFields<T> make_solute_fields(const Exec& exec, const FluidNodes& nodes, double concentration = 0);

/// What carries solutes: nothing, a flow, or a flow in advective form, in which a uniform concentration stays uniform
/// although the stair-step, pseudo-compressible velocity field has the discrete divergence e.
template <class T>
struct SoluteCarrier {
  std::optional<Displacement<T>> displacement;
  /// (fluid) e: advective_defect<Set> of advective_form.hpp, taken from the velocity of the last sweep.
  std::optional<ScalarField<T>> defect;
};

/// A species that takes a step.
template <class T>
struct SteppingSolute {
  const SoluteParameters& parameters;
  SoluteFields<T>& fields;
  /// (block) What the advective form adds to the total, the sum of -C e, is added to it; unused without that form. At
  /// least block_count(nodes.count) entries.
  ScalarField<double> correction;
};

/// One lattice step of a species.
template <class Set, class T>
void advance_solute(const Exec& exec, const FluidNodes& nodes, const SoluteCarrier<T>& carrier,
                    const SteppingSolute<T>& solute);

/// total(block) += the solute in the block's nodes, for the blocks of this process: the sum of all populations, in
/// double and in a fixed order. Valid at any moment of a step.
template <class Set, class T>
void add_solute(const Exec& exec, const FluidNodes& nodes, const SoluteFields<T>& s, const ScalarField<double>& total);

/// total(block) += |C - before| over the block's nodes below `count`, for the blocks of this process; before (fluid) is
/// C afterwards, for all their nodes. In single precision, a change of a few last places (2^-21 C) is none: before
/// stays until more has come together.
template <class T>
void add_change(const Exec& exec, const FluidNodes& nodes, const Kokkos::View<const T*>& C, int count,
                const ScalarField<T>& before, const ScalarField<double>& total);

}  // namespace vug
