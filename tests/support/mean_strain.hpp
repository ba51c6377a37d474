#pragma once
// Strain of a block of rock.
#include "dem/mechanics.hpp"
#include "support/host_copy.hpp"

namespace vug::test {

/// Slope of the displacements along an axis over the places, by least squares over all particles.
inline double mean_strain(const Mechanics& rock, int axis) {
  const auto x0 = host_copy(rock.particles().x0), u = host_copy(rock.particles().u);
  double n = 0, sx = 0, su = 0, sxx = 0, sxu = 0;
  for (int i = 0; i < rock.particles().count; ++i) {
    const double x = x0(i, axis);
    n += 1, sx += x, su += u(i, axis), sxx += x * x, sxu += x * u(i, axis);
  }
  return (n * sxu - sx * su) / (n * sxx - sx * sx);
}

}  // namespace vug::test
