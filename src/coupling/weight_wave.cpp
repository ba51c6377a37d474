#include "coupling/weight_wave.hpp"

#include "coupling/pore_runs.hpp"
#include "coupling/temperature_range.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace vug {

namespace {

/// A piece of fluid, seen along one axis.
struct Column {
  int height = 0;                  ///< rows across the axis that have nodes of it
  double widest = 0;               ///< width of its widest pore, cells
  bool open = false;               ///< the flow through one of its mouths follows from the pressure
  std::array<bool, 2> open_end{};  ///< one at either end of the axis
  bool pressed = false;            ///< one has a given pressure other than that of the start, and at once
};

/// The pieces of fluid along an axis; `width` is that of pores.
std::vector<Column> columns_along(const AxisView& view, const std::vector<double>& width,
                                  const std::vector<Mouth>& mouths, const std::vector<int>& piece,
                                  const LatticeUnits& units) {
  const int pieces = piece.empty() ? 0 : *std::max_element(piece.begin(), piece.end()) + 1;
  std::vector<Column> columns(pieces);
  std::vector<int> seen(pieces, -1);
  for (int k = 0; k < view.length(); ++k)
    for (int line = 0; line < view.lines(); ++line) {
      const std::size_t n = view.node(line, k);
      if (piece[n] < 0) continue;
      Column& column = columns[piece[n]];
      if (seen[piece[n]] != k) ++column.height;
      seen[piece[n]] = k;
      column.widest = std::max(column.widest, width[n]);
    }
  for (const Mouth& mouth : mouths) {
    if (!mouth.yields()) continue;
    const FlowBoundary& flow = mouth.conditions->flow;
    const Span given = flow.kind == FlowBoundaryKind::pressure ? pressures_of(flow, units) : Span{};
    const bool presses = flow.ramp_time == 0 && (given.low != 0 || given.high != 0);
    for (const std::size_t n : mouth.nodes) {
      Column& column = columns[piece[n]];
      column.open = true;
      column.pressed = column.pressed || presses;
      if (mouth.side && view.along(n) == 0) column.open_end[0] = true;
      if (mouth.side && view.along(n) == view.length() - 1) column.open_end[1] = true;
    }
  }
  return columns;
}

}  // namespace

double weight_wave(double g, double height, bool open) {
  return std::sqrt(3.0) * g * height * (open ? 1.0 : 0.5);
}

double weight_wave_speed(const Scene& scene, const BodyForces& forces, const FluidPicture& picture,
                         const std::vector<double>& width, const std::vector<Mouth>& mouths,
                         const std::vector<int>& piece, const LatticeUnits& units) {
  if (forces.at_start == std::array{0.0, 0.0}) return 0;
  const double viscosity = lowest_viscosity(scene) / units.diffusivity();
  std::vector<double> squared;  // (piece) of the speeds along both axes
  for (int axis = 0; axis < 2; ++axis) {
    const double g = std::abs(forces.at_start[axis]);
    const AxisView view{picture, axis};
    const std::vector<Column> columns = columns_along(view, width, mouths, piece, units);
    squared.resize(columns.size(), 0);
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const Column& column = columns[c];
      const bool joined = periodic_sides(scene)[axis] && column.height == view.length();
      if (joined || (column.open_end[0] && column.open_end[1] && !column.pressed)) continue;
      double speed = weight_wave(g, column.height, column.open);
      if (!column.pressed) speed = std::min(speed, g * column.widest * column.widest / (8 * viscosity));
      squared[c] += speed * speed;
    }
  }
  return squared.empty() ? 0 : std::sqrt(*std::max_element(squared.begin(), squared.end()));
}

}  // namespace vug
