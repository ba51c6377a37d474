#pragma once
// Pieces of a case in lattice units (spacing 1 m, step 1 s), as text.
#include <fmt/format.h>

#include <string>

namespace vug::test {

/// [lattice] and [time] of nx x ny cells.
inline std::string unit_lattice(int nx, int ny) {
  return fmt::format("[lattice]\nsize = [{}, {}]\nspacing = 1\ntime_step = 1\n[time]\nsteps = 1000000\n", nx, ny);
}

inline std::string rectangle(double x0, double y0, double x1, double y1, const std::string& more = "") {
  return fmt::format("[[geometry.shapes]]\ntype = \"rectangle\"\nfrom = [{}, {}]\nto = [{}, {}]\n{}\n", x0, y0, x1, y1,
                     more);
}

inline std::string disc(double x, double y, double radius, const std::string& more = "") {
  return fmt::format("[[geometry.shapes]]\ntype = \"disc\"\ncentre = [{:.17g}, {:.17g}]\nradius = {:.17g}\n{}\n", x, y,
                     radius, more);
}

}  // namespace vug::test
