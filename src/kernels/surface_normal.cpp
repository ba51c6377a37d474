#include "kernels/surface_normal.hpp"

#include "kernels/dense_neighbour.hpp"
#include "kernels/launch.hpp"
#include "kernels/link_area.hpp"

namespace vug {

/// Weighted first moment of V over 5 x 5 nodes, normalised: w = exp(-(dx^2 + dy^2)/2).
struct SurfaceNormal {
  DenseNeighbour lattice;
  IndexList node;
  ScalarField<double> V;
  VectorField<double> normal;

  KOKKOS_FORCEINLINE_FUNCTION static double weight(int distance2) {
    constexpr double gaussian[9] = {
        1, 0.60653065971263342, 0.36787944117144233, 0, 0.13533528323661270, 0.082084998623898795, 0,
        0, 0.018315638888734179};
    return gaussian[distance2];
  }
  KOKKOS_FUNCTION void operator()(int s) const {
    double gx = 0, gy = 0;
    for (int dy = -2; dy <= 2; ++dy)
      for (int dx = -2; dx <= 2; ++dx) {
        const double wV = weight(dx * dx + dy * dy) * V(lattice.nearest(node(s), dx, dy));
        gx += wV * dx;
        gy += wV * dy;
      }
    const double length = Kokkos::sqrt(gx * gx + gy * gy);
    const bool defined = length > 1e-6;
    normal(s, 0) = defined ? -gx / length : 0;
    normal(s, 1) = defined ? -gy / length : 0;
  }
};

void find_normals(const Exec& exec, const FluidNodes& nodes, const Surface& surface, const ScalarField<double>& V,
                  VectorField<double>& normal) {
  if (static_cast<int>(normal.extent(0)) < surface.count)
    normal = VectorField<double>("vug::surface_normal::normal", surface.count + surface.count / 2);
  for_each_node(exec, "vug::surface_normal::find", surface.count,
                SurfaceNormal{DenseNeighbour(nodes), surface.node, V, normal});
}

/// Area of the links of one surface node.
template <class Set, class Area>
struct SurfaceNodeArea {
  DenseNeighbour lattice;
  IndexList node, index;
  Area area;
  KOKKOS_FUNCTION double operator()(int s) const {
    double sum = 0;
    for (int q = 1; q < Set::Q; ++q) {
      if (lattice.fluid_along(index, node(s), q) >= 0) sum += 6 * Set::w(q) * area.share(s, q);
    }
    return sum;
  }
};

template <class Set>
double surface_area(const Exec& exec, const FluidNodes& nodes, const Surface& surface,
                    const VectorField<double>& normal) {
  const ScalarField<double> total("vug::surface_normal::area", block_count(surface.count));
  with_link_area(normal, [&](const auto& area) {
    using Area = std::decay_t<decltype(area)>;
    add_per_block(exec, "vug::surface_normal::sum_area", surface.count,
                  SurfaceNodeArea<Set, Area>{DenseNeighbour(nodes), surface.node, nodes.index, area}, total);
  });
  exec.fence();
  return sum_in_order(total);
}

template double surface_area<D2Q5>(const Exec&, const FluidNodes&, const Surface&, const VectorField<double>&);
template double surface_area<D2Q9>(const Exec&, const FluidNodes&, const Surface&, const VectorField<double>&);

}  // namespace vug
