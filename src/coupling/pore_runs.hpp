#pragma once
// Runs of fluid nodes along an axis of the lattice, on the host.
#include "coupling/fluid_picture.hpp"
#include "io/scene.hpp"

#include <array>
#include <vector>

namespace vug {

/// A picture seen along one axis: `k` counts along it, `line` across it.
struct AxisView {
  const FluidPicture& picture;
  int axis;
  int length() const { return axis == 0 ? picture.nx : picture.ny; }
  int lines() const { return axis == 0 ? picture.ny : picture.nx; }
  std::size_t node(int line, int k) const { return axis == 0 ? picture.number(k, line) : picture.number(line, k); }
  bool is_fluid(int line, int k) const { return picture.is_fluid(node(line, k)); }
  /// Where a node is along the axis.
  int along(std::size_t n) const { return static_cast<int>(axis == 0 ? n % picture.nx : n / picture.nx); }
};

/// What bounds the fluid at the two ends of an axis: sides that are joined, or open.
struct AxisEnds {
  bool joined = false;
  std::array<bool, 2> open{false, false};
};
AxisEnds ends_of(const Scene& scene, int axis);

/// (node) Width, cells, of the channel between walls in which fluid would flow as in its run of fluid nodes along an
/// axis: twice the run where one end of it is at an open side, infinite where nothing holds the fluid; 0 in rock.
std::vector<double> widths_along(const AxisView& view, const AxisEnds& ends);

/// (node) The width of a pore: the shorter of the widths along x and along y.
std::vector<double> shorter_widths(const Scene& scene, const FluidPicture& picture);

}  // namespace vug
