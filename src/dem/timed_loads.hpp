#pragma once
// Loads and platens that change in time: the particles that they act on, and their values in a step.
#include "dem/loads.hpp"

#include <optional>

namespace vug {

/// Largest number of parts of sides that may change or move: their values are arguments of a kernel.
inline constexpr int most_timed_parts = 16;

/// Pieces of the boundary that change or move, grouped by particle.
struct TimedLoads {
  std::vector<SidePart> parts;        ///< that change or move
  IndexList particle;                 ///< (entry)
  IndexList row;                      ///< (entry + 1) its pieces are [row(j), row(j + 1))
  IndexList part;                     ///< (piece) number among `parts`
  ScalarField<double> length;         ///< (piece) m
  VectorField<double> arm;            ///< (piece, axis) m
  IndexList axes;                     ///< (piece) bits 1, 2: the axes that its platen moves
  VectorField<double> force, moment;  ///< (entry) of all other loads, as in BoundaryLoads

  bool moves() const;
};

/// Makes the timed loads; none where no part changes or moves. Throws InputError for more than most_timed_parts.
std::optional<TimedLoads> make_timed_loads(const Assembly& assembly, const std::vector<BoundaryEdge>& boundary,
                                           const Loads& loads, const Particles& particles,
                                           const BoundaryLoads& at_start);

/// Sets tractions to those at `time` and the speeds of platens to those half a step of `dt` later, when they act. One
/// kernel; the bits do not depend on previous calls.
void follow_loads(const Exec& exec, const TimedLoads& timed, double time, double dt, const BoundaryLoads& loads,
                  const Particles& particles);

}  // namespace vug
