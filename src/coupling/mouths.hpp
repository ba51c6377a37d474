#pragma once
// Mouths, through which fluid or solutes may enter and leave: sides and openings with the fluid nodes beside them, on
// the host.
#include "coupling/fluid_picture.hpp"
#include "io/scene.hpp"
#include "io/units.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

namespace vug {

/// A stretch or an opening with the fluid nodes beside it.
struct Mouth {
  std::string key;  ///< "boundary.left", "boundary.shape.well"
  const BoundarySection* conditions;
  std::vector<std::size_t> nodes{};
  std::vector<double> length{};  ///< (node) of its boundary, cells
  double inflow = 0;             ///< volume that enters per step and cell of length; only for prescribed velocities
  std::function<double(double)> inflow_at{};  ///< the same at a time (s), where `inflow` is that of the peak
  /// (node) Volume, cells, that the surface of a moving shape pushes into it per step and unit of velocity along x and
  /// y; only for shapes that are walls with a velocity.
  std::vector<std::array<double, 2>> push{};
  /// Largest prescribed speed at one point, lattice units; infinite where the shares of a rate have no positive sum.
  double peak_speed = 0;
  std::optional<Side> side{};          ///< of the lattice; none for an opening
  std::array<double, 2> centre{0, 0};  ///< of the side, stretch or opening, cells

  double total_length() const { return std::accumulate(length.begin(), length.end(), 0.0); }

  bool lets_fluid_through() const {
    const FlowBoundaryKind kind = conditions->flow.kind;
    return kind == FlowBoundaryKind::pressure || kind == FlowBoundaryKind::velocity ||
           kind == FlowBoundaryKind::outflow;
  }
  bool lets_solute_through() const {
    const SoluteBoundaryKind kind = conditions->solute.kind;
    return kind != SoluteBoundaryKind::no_flux && kind != SoluteBoundaryKind::periodic;
  }
  bool moves() const { return !push.empty(); }
  /// Whether the flow through it follows from the pressure, in either direction.
  bool yields() const { return lets_fluid_through() && conditions->flow.kind != FlowBoundaryKind::velocity; }
};

/// The mouths of a scene, in the order of boundary_stretches. They point into scene and geometry, which must outlive
/// them.
std::vector<Mouth> mouths_of(const Scene& scene, const Geometry& geometry, const LatticeUnits& units,
                             const FluidPicture& picture);

}  // namespace vug
