#pragma once
// What the parts of a step that reach here and there must move in whole cache lines: memory hands out no less.
#include "step_bytes.hpp"

#include <algorithm>
#include <vector>

namespace vug::perf {

/// The cache lines of one field that a sweep touches, each once, however often it is asked for.
class TouchedLines {
 public:
  TouchedLines(std::size_t entries, double size)
      : per_line_(static_cast<std::size_t>(line / size)), touched_(entries) {}
  void touch(int entry) { touched_[static_cast<std::size_t>(entry) / per_line_] = true; }
  double bytes() const { return line * static_cast<double>(std::count(touched_.begin(), touched_.end(), true)); }

 private:
  static constexpr double line = 64;
  std::size_t per_line_;
  std::vector<bool> touched_;
};

/// Bytes of the lines that hold what walls ask for.
struct ScatteredBytes {
  double population;   ///< of every link of D2Q9 from the fluid into rock, where it lies
  double volume;       ///< a dense number of doubles at every surface node
  double around;       ///< the same at the 5 x 5 nodes around each
  double temperature;  ///< a dense lattice number at the surface nodes and the fluid nodes of D2Q5 links
};

inline ScatteredBytes scattered_bytes(const Geometry& geometry, double T) {
  const FluidNodes& fluid = geometry.fluid;
  const auto links = on_host(fluid.solid_links);
  const auto fluid_node = on_host(fluid.node), surface_node = on_host(geometry.surface.node);
  const auto dense = static_cast<std::size_t>(geometry.lattice.size());
  TouchedLines population(D2Q9::Q * static_cast<std::size_t>(fluid.capacity), T), temperature(dense, T);
  TouchedLines volume(dense, sizeof(double)), around(dense, sizeof(double));
  for (int i = 0; i < fluid.count; ++i) {
    for (int q = 1; q < D2Q9::Q; ++q)
      if ((links(i) >> q & 1) != 0) population.touch(q * fluid.capacity + i);
    if ((links(i) & ((1 << D2Q5::Q) - 2)) != 0) temperature.touch(fluid_node(i));
  }
  const Lattice& lattice = geometry.lattice;
  for (int s = 0; s < geometry.surface.count; ++s) {
    const int n = surface_node(s);
    volume.touch(n);
    temperature.touch(n);
    for (int dy = -2; dy <= 2; ++dy)
      for (int dx = -2; dx <= 2; ++dx) {
        const int x = std::clamp(lattice.x(n) + dx, 0, lattice.nx - 1),
                  y = std::clamp(lattice.y(n) + dy, 0, lattice.ny - 1);
        around.touch(lattice.node(x, y));
      }
  }
  return {population.bytes(), volume.bytes(), around.bytes(), temperature.bytes()};
}

/// bytes_of() with whole lines where a part does not read in order; 0 for the other parts.
inline std::array<double, part_count> lines_of(const Scene& scene, const Sizes& s, const Geometry& geometry,
                                               const std::array<double, part_count>& bytes) {
  const double T = bytes_of_number(scene);
  const ScatteredBytes lines = scattered_bytes(geometry, T);
  const double every = scene.accuracy.update_interval;
  std::array<double, part_count> result{};
  // volumes and what has dissolved: around each surface node for its normal, of its own both ways for its turnover
  const double refresh = 2 * lines.around - 8 * 8 * s.surface + lines.temperature - 2 * T * s.links5;
  const double book = 4 * lines.volume - 32 * s.surface;
  result[reaction] = bytes[reaction] + book / every + refresh / scene.accuracy.wall_interval;
  result[fluid_force] = bytes[fluid_force] + (lines.population - T * s.links9) / scene.accuracy.exchange_interval;
  result[pores] = bytes[pores] + (lines.volume - 8 * s.surface) / every;
  return result;
}

}  // namespace vug::perf
