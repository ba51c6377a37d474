#pragma once
// Rock and pores on the lattice, shared by all modules. Written by build_modules and when pores grow; the reaction also
// writes `volume` and `dissolved` (book_turnover).
#include "coupling/split.hpp"
#include "io/scene.hpp"
#include "kernels/nodes/fluid_nodes.hpp"
#include "kernels/nodes/opening.hpp"
#include "kernels/nodes/slit_nodes.hpp"

#include <functional>
#include <vector>

namespace vug {

/// An opening with its conditions.
struct InnerOpening {
  std::string name;  ///< for columns and states: "shape_" and the name of the shape
  Opening nodes;
  BoundarySection conditions;
  std::array<double, 2> centre{0, 0};  ///< of the area in its outline, cells
  std::string key{};                   ///< of its table in the case: "boundary.shape.well"
};

/// The lattice: node types, the list of fluid nodes with its link tables, the wet surface of the rock.
struct Geometry {
  Lattice lattice;
  double spacing = 1;            ///< m
  Kokkos::View<NodeType*> type;  ///< (dense node)
  FluidNodes fluid;              ///< empty where the scene has neither flow nor solute
  Surface surface;
  std::vector<InnerOpening> openings;
  Kokkos::View<std::uint8_t*> mineral;  ///< (dense node) number of its mineral from 1; 0: none; empty without minerals
  ScalarField<double> volume;           ///< (dense node) solid volume V, pixels; empty without [reaction]
  ScalarField<double> dissolved;        ///< (dense node) volume dissolved so far, pixels; empty without [reaction]
  SlitNodes slits;                      ///< of pathways narrower than a cell, grouped by triangle (slits.hpp)
  std::int64_t slit_changes = 0;        ///< how often the slits have changed
  Split split;                          ///< how the ranks share this work
};

/// Part of a side of the lattice, or the surface of an opening, with one set of boundary conditions.
struct Stretch {
  std::string name;  ///< "left", "injection", ... as in the case file, or that of the opening
  Side side;
  int first, last;  ///< node coordinates along the side, both included
  BoundarySection conditions;
  const Opening* opening = nullptr;    ///< of the geometry; then side, first and last mean nothing
  std::array<double, 2> centre{0, 0};  ///< of the whole side, the injection or the opening, cells
  std::string key{};                   ///< of its table in the case: "boundary.left", "boundary.shape.well"
  /// The same of the whole side or injection, which a profile spans; a side with injections on it has several parts.
  int whole_first = 0, whole_last = -1;

  int whole_length() const { return whole_last + 1 - whole_first; }  ///< cells
};

/// The four sides, divided where injections are.
std::vector<Stretch> boundary_stretches(const Scene& scene);
/// The same, followed by the openings.
std::vector<Stretch> boundary_stretches(const Scene& scene, const Geometry& geometry);

/// The opening that contains each node (row by row, without halo), as an index into scene.openings; -1: none. Empty
/// when the case has no openings.
std::vector<int> opening_of_nodes(const Scene& scene);

/// Throws InputError when an opening has no node.
std::vector<InnerOpening> make_openings(const Scene& scene, const Lattice& lattice);

/// Whether left and right, and bottom and top, are periodic according to the boundaries of flow and scalars.
std::array<bool, 2> periodic_sides(const Scene& scene);

/// Columns x0 to x1 - 1 and rows y0 to y1 - 1 of cells, also beyond the lattice.
struct CellWindow {
  int x0, y0, x1, y1;
};

/// Calls visit(x, y) for every cell of a window whose centre is in the form.
void for_each_cell_in(const Form& form, double spacing, const CellWindow& window,
                      const std::function<void(int, int)>& visit);

/// Calls visit(node) for every node (row by row, without halo) whose centre is in the form.
void for_each_node_in(const Form& form, const LatticeSection& lattice, const std::function<void(std::size_t)>& visit);

/// Solid nodes (row by row, without halo) of a geometry that is open, drawn or read from an image.
struct DrawnRock {
  std::vector<bool> solid;
  std::vector<std::uint8_t> of_label;  ///< the mineral that a label map gives each node; empty without
  std::string warning;                 ///< for a picture that shows no rock at all; otherwise empty
};
DrawnRock drawn_rock(const Scene& scene);

}  // namespace vug
