#include "kernels/reaction/surface_normal.hpp"

#include "kernels/base/unroll.hpp"
#include "kernels/launch/launch.hpp"
#include "kernels/nodes/dense_neighbour.hpp"
#include "kernels/reaction/link_area.hpp"
#include "kernels/reaction/solid_share.hpp"

namespace vug {

/// A quadratic fitted to V over 5 x 5 nodes with weights w = exp(-(dx^2 + dy^2)/4): its gradient gives the normal, its
/// second derivatives the curvature kappa (positive where the solid bulges). The reaction acts on the outline of the
/// pixels, which lies outside the true surface by half the depth of what has dissolved of the pixel; that depth is
/// (1 - V)/(|n_x| + |n_y|), 0.8 (1 - V) in the mean over all orientations. The outline is longer by the factor
/// 1 + 0.4 (1 - V) kappa, and the normal is shortened by it.
///
/// The gradient beside a flat wall is 0.34, beside a wall two pixels thick 0.17, and 0 across one of a single pixel,
/// where whatever the volume happens to do along the wall would give the direction, and faces at right angles to it
/// would never react: below 0.1 there is no normal.
struct SurfaceNormal {
  DenseNeighbour lattice;
  IndexList node;
  Kokkos::View<const double*> volume, dissolved;
  VectorField<double> normal;

  KOKKOS_FORCEINLINE_FUNCTION double V(int n) const { return solid_share(volume(n), dissolved(n)); }

  /// Derivatives of the fitted quadratic at its centre.
  struct Fit {
    double x = 0, y = 0, xx = 0, yy = 0, xy = 0;
  };

  /// One axis' factor of the weights.
  KOKKOS_FORCEINLINE_FUNCTION static double weight(int distance) {
    constexpr double gaussian[3] = {1, 0.77880078307140488, 0.36787944117144233};
    return gaussian[distance < 0 ? -distance : distance];
  }
  /// `share(dx, dy)` is V that far away. The weights are a product, so that sums along rows serve all terms.
  template <class Share>
  KOKKOS_FORCEINLINE_FUNCTION static Fit fit(const Share& share) {
    const double m0 = 1 + 2 * weight(1) + 2 * weight(2);
    const double m2 = 2 * weight(1) + 8 * weight(2);
    const double m4 = 2 * weight(1) + 32 * weight(2);
    const double spread = m2 / m0, variance = m0 * (m4 - m2 * spread);
    Fit f;
    VUG_UNROLL
    for (int dy = -2; dy <= 2; ++dy) {
      double sum = 0, first = 0, second = 0;  // of the row: V, dx V, (dx^2 - spread) V
      VUG_UNROLL
      for (int dx = -2; dx <= 2; ++dx) {
        const double wV = weight(dx) * share(dx, dy);
        sum += wV;
        first += dx * wV;
        second += (dx * dx - spread) * wV;
      }
      f.x += weight(dy) * first;
      f.y += weight(dy) * dy * sum;
      f.xx += weight(dy) * second;
      f.yy += weight(dy) * (dy * dy - spread) * sum;
      f.xy += weight(dy) * dy * first;
    }
    return {f.x / (m0 * m2), f.y / (m0 * m2), f.xx * 2 / variance, f.yy * 2 / variance, f.xy / (m2 * m2)};
  }
  /// Most nodes have all their neighbours inside, which spares the search for each.
  KOKKOS_FUNCTION Fit fit_around(int n) const {
    const Lattice& l = lattice.lattice;
    const int x = l.x(n), y = l.y(n);
    if (x >= 2 && y >= 2 && x < l.nx - 2 && y < l.ny - 2)
      return fit([&](int dx, int dy) { return V(n + dy * l.pitch + dx); });
    return fit([&](int dx, int dy) { return V(lattice.nearest(n, dx, dy)); });
  }
  KOKKOS_FUNCTION void operator()(int s) const {
    const Fit f = fit_around(node(s));
    const double length = Kokkos::sqrt(f.x * f.x + f.y * f.y);
    constexpr double least = 0.1;
    if (!(length > least)) {
      normal(s, 0) = normal(s, 1) = 0;
      return;
    }
    const double bend = -(f.xx * f.y * f.y - 2 * f.xy * f.x * f.y + f.yy * f.x * f.x) / (length * length * length);
    const double curvature = bend < -0.5 ? -0.5 : bend > 0.5 ? 0.5 : bend;  // a pixel resolves no sharper bend
    const double missing = 1 - V(node(s));
    const double share = 1 - 0.4 * (missing < 1 ? missing : 1.0) * curvature;
    normal(s, 0) = -f.x / length * share;
    normal(s, 1) = -f.y / length * share;
  }
};

void find_normals(const Exec& exec, const FluidNodes& nodes, const Surface& surface, const ScalarField<double>& volume,
                  const ScalarField<double>& dissolved, VectorField<double>& normal, const std::optional<Share>& only) {
  if (static_cast<int>(normal.extent(0)) < surface.count)
    normal = VectorField<double>("vug::surface_normal::normal", surface.count + surface.count / 2);
  for_each_node(exec, "vug::surface_normal::find", only.value_or(Share(surface.count)),
                SurfaceNormal{DenseNeighbour(nodes), surface.node, volume, dissolved, normal});
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
