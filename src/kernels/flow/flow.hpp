#pragma once
// The flow of a fluid through its nodes: populations, and the one sweep that streams and collides them.
//
// Between steps f holds the populations after collision. The population of a link out of the fluid is at home, in slot
// q * capacity + i of the node that it leaves. A population about to move to a fluid neighbour is at home too or, after
// an odd number of steps in place, has changed places with the one that moves the other way (`turned`). A step is
//   dress the slots of open and moving boundaries (open_boundary.hpp) -> collide_and_stream,
// and what reads f (momentum exchange, births, guards, mass) does so after the sweep and before the dressing.
#include "kernels/flow/mrt.hpp"
#include "kernels/nodes/fluid_nodes.hpp"

namespace vug {

/// Populations and velocity of the fluid nodes, lattice units, as deviations from rest at the reference pressure.
template <class T>
struct FlowFields {
  ScalarField<T> f;  ///< (q * capacity + fluid) after collision
  int turned = 0;    ///< 1 after an odd number of steps in place (see settle); belongs to f in a checkpoint
  VectorField<T> u;  ///< (fluid, axis) velocity, with half the body force
};

/// rho' = 3 p' of a node: the sum of the populations that it sent out in the last sweep. Valid until slots are dressed.
template <class T>
struct Density {
  Kokkos::View<const T*> f;
  Kokkos::View<const int*> source;
  int capacity, turned;

  Density(const FluidNodes& nodes, const FlowFields<T>& fields)
      : f(fields.f), source(nodes.source), capacity(nodes.capacity), turned(fields.turned) {}

  KOKKOS_FORCEINLINE_FUNCTION T operator()(int i) const {
    if (!turned) return sum_of_populations<D2Q9, T>(&f(i), capacity);
    T sum = f(i);
    for (int q = 1; q < D2Q9::Q; ++q) sum += f(source(q * capacity + i));
    return sum;
  }
};

/// Parameters of one step.
template <class T>
struct FlowStep {
  Collision collision = Collision::trt;
  RelaxationRates rates;
  std::array<T, 2> body_force{0, 0};  ///< per volume over reference density, lattice units
  /// Largest speed before collision, lattice units; momentum above it is removed, mass kept. 0: no limiter.
  T speed_limit = 0;
  /// (fluid) Temperature; empty where the flow does not depend on it. `buoyancy` is what a kelvin adds to the body
  /// force.
  ScalarField<T> theta{};
  std::array<T, 2> buoyancy{0, 0};
  /// (fluid) tau - 1/2 = 3 nu of each node; empty: as in `rates`. Needs theta, and trt or bgk as collision.
  ScalarField<T> spread{};
  ScalarField<double> limited;  ///< (block) uses of the limiter are added to it; needed with a speed limit
};

/// Fields for `nodes` at rest at the reference pressure.
template <class T>
FlowFields<T> make_flow_fields(const Exec& exec, const FluidNodes& nodes);

/// (fluid) the density of every node that this process computes; allocated, for output.
template <class T>
ScalarField<T> densities(const Exec& exec, const FluidNodes& nodes, const FlowFields<T>& fields);

/// One time step: pulls the populations, computes their moments, limits the speed, collides and stores.
template <class T>
void collide_and_stream(const Exec& exec, const FluidNodes& nodes, FlowFields<T>& fields, const FlowStep<T>& step);

/// Populations of the new nodes [first, last): rest at the mean rho' of their fluid neighbours that were there before
/// (index below `first`); at the reference pressure where there is none. The mass added is the sum of their density.
template <class T>
void initialise_births(const Exec& exec, const FluidNodes& nodes, int first, int last, FlowFields<T>& fields);

/// total(block) += sum of the populations kept by the block's nodes; all blocks together are the mass of the fluid.
template <class T>
void add_mass(const Exec& exec, const FluidNodes& nodes, const FlowFields<T>& fields, const ScalarField<double>& total);

/// total(block) += sum of u(i, axis) over the block's nodes. The same bits for any number of threads.
template <class T>
void add_velocity(const Exec& exec, const FluidNodes& nodes, const VectorField<T>& u, int axis,
                  const ScalarField<double>& total);

}  // namespace vug
