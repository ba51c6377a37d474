#pragma once
// What is rock and what is pore on the lattice, shared by all modules. Written by `build` and by births only.
#include "io/scene.hpp"
#include "kernels/fluid_nodes.hpp"

#include <vector>

namespace vug {

/// The pixels: node types, the list of fluid nodes with its link tables, the wet surface of the rock.
struct Geometry {
  Lattice lattice;
  double spacing = 1;            ///< m
  Kokkos::View<NodeType*> type;  ///< (dense node)
  FluidNodes fluid;              ///< empty where the scene has neither flow nor solute
  Surface surface;
  ScalarField<double> volume;     ///< (dense node) solid volume V, pixels; empty unless the rock can dissolve
  ScalarField<double> dissolved;  ///< (dense node) volume dissolved so far, pixels; empty likewise
};

/// Part of a side of the lattice with one set of boundary conditions.
struct Stretch {
  std::string name;  ///< key in the case file: "left", "injection", ...
  Side side;
  int first, last;  ///< node coordinates along the side, inclusive
  BoundarySection conditions;
};

/// The four sides, cut where the injection lies.
std::vector<Stretch> boundary_stretches(const Scene& scene);

/// Joined pairs of sides {left-right, bottom-top} according to the flow or scalar boundaries.
std::array<bool, 2> periodic_sides(const Scene& scene);

/// Solid mask (row by row, without halo; true = solid) of an open, drawn or photographed geometry.
std::vector<bool> solid_mask(const Scene& scene);

}  // namespace vug
