#pragma once
// From fields on the device to plain arrays over the lattice for output: row by row, without halo, in SI.
#include "coupling/geometry.hpp"
#include "kernels/base/host_and_device.hpp"

#include <algorithm>
#include <span>

namespace vug {

/// How stored values become SI: scale * value + shift, and what stands where nothing is stored.
struct Conversion {
  double scale = 1;
  double shift = 0;
  double elsewhere = 0;
};

/// Spreads one value per fluid node over the lattice, as component `component` of `components`.
template <class ViewType>
void read_fluid(const FluidNodes& fluid, const ViewType& values, const Conversion& conversion, std::span<double> out,
                int component = 0, int components = 1) {
  const auto node = on_host(fluid.node);
  const auto host = on_host(values);
  const Lattice& lattice = fluid.lattice;
  for (std::size_t n = component; n < out.size(); n += components) out[n] = conversion.elsewhere;
  for (int i = 0; i < fluid.count; ++i) {
    const std::size_t n = static_cast<std::size_t>(lattice.y(node(i))) * lattice.nx + lattice.x(node(i));
    out[n * components + component] = conversion.scale * static_cast<double>(host(i)) + conversion.shift;
  }
}

/// Copies the interior of a dense field.
template <class ViewType>
void read_dense(const Lattice& lattice, const ViewType& values, const Conversion& conversion, std::span<double> out) {
  const auto host = on_host(values);
  for (int y = 0; y < lattice.ny; ++y)
    for (int x = 0; x < lattice.nx; ++x)
      out[static_cast<std::size_t>(y) * lattice.nx + x] =
          conversion.scale * static_cast<double>(host(lattice.node(x, y))) + conversion.shift;
}

/// Number of the mineral of every node of rock, from 1; 0 in rock of none, -1 elsewhere.
inline void read_mineral(const Geometry& geometry, std::span<double> out) {
  const auto mineral = on_host(geometry.mineral);
  const auto type = on_host(geometry.type);
  const Lattice& lattice = geometry.lattice;
  for (int y = 0; y < lattice.ny; ++y)
    for (int x = 0; x < lattice.nx; ++x) {
      const int n = lattice.node(x, y);
      out[static_cast<std::size_t>(y) * lattice.nx + x] = type(n) == NodeType::solid ? mineral(n) : -1.0;
    }
}

/// share(V, dissolved) of every node of rock that can dissolve.
template <class Share>
void read_solid(const Geometry& geometry, const Share& share, std::span<double> out) {
  const auto volume = on_host(geometry.volume);
  const auto dissolved = on_host(geometry.dissolved);
  const Lattice& lattice = geometry.lattice;
  for (int y = 0; y < lattice.ny; ++y)
    for (int x = 0; x < lattice.nx; ++x) {
      const int n = lattice.node(x, y);
      out[static_cast<std::size_t>(y) * lattice.nx + x] = share(volume(n), dissolved(n));
    }
}

}  // namespace vug
