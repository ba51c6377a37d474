#include "kernels/reaction/surface_normal.hpp"

#include "base/unroll.hpp"
#include "kernels/launch/launch.hpp"
#include "kernels/launch/prefetch.hpp"
#include "kernels/packs/pack.hpp"
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
/// where accidental variations of the volume along the wall would give the direction, and faces at right angles to it
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

  // Factor of the weights along one axis, exp(-d^2/4). The weights are products, so that sums along columns serve all
  // terms.
  static constexpr double w1 = 0.77880078307140488, w2 = 0.36787944117144233;
  static constexpr double m0 = 1 + 2 * w1 + 2 * w2, m2 = 2 * w1 + 8 * w2, m4 = 2 * w1 + 32 * w2;
  static constexpr double spread = m2 / m0, variance = m0 * (m4 - m2 * spread);

  /// Sums of w V, w d V and w (d^2 - spread) V over five numbers at the distances d = -2 to 2.
  template <class V>
  KOKKOS_FORCEINLINE_FUNCTION static V level(const V* v) {
    return v[2] + w1 * (v[3] + v[1]) + w2 * (v[4] + v[0]);
  }
  template <class V>
  KOKKOS_FORCEINLINE_FUNCTION static V slope(const V* v) {
    return w1 * (v[3] - v[1]) + 2 * w2 * (v[4] - v[0]);
  }
  template <class V>
  KOKKOS_FORCEINLINE_FUNCTION static V bend(const V* v) {
    return w1 * (1 - spread) * (v[3] + v[1]) + w2 * (4 - spread) * (v[4] + v[0]) - spread * v[2];
  }
  /// The fit from these sums of all five columns, dx = -2 to 2.
  KOKKOS_FORCEINLINE_FUNCTION static Fit across(const double* levels, const double* slopes, const double* bends) {
    constexpr double first = 1 / (m0 * m2), second = 2 / variance, mixed = 1 / (m2 * m2);
    return {first * slope(levels), first * level(slopes), second * bend(levels), second * level(bends),
            mixed * slope(slopes)};
  }
  /// Whether all neighbours of a node are inside, as for most nodes: they need not be searched for then.
  KOKKOS_FORCEINLINE_FUNCTION bool is_inside(int n) const {
    const Lattice& l = lattice.lattice;
    const int x = l.x(n), y = l.y(n);
    return x >= 2 && y >= 2 && x < l.nx - 2 && y < l.ny - 2;
  }
  KOKKOS_FUNCTION Fit fit_around(int n) const {
    const bool inside = is_inside(n);
    double levels[5], slopes[5], bends[5];
    for (int dx = -2; dx <= 2; ++dx) {
      double column[5];
      for (int dy = -2; dy <= 2; ++dy)
        column[dy + 2] = V(inside ? n + dy * lattice.lattice.pitch + dx : lattice.nearest(n, dx, dy));
      levels[dx + 2] = level(column);
      slopes[dx + 2] = slope(column);
      bends[dx + 2] = bend(column);
    }
    return across(levels, slopes, bends);
  }
  KOKKOS_FORCEINLINE_FUNCTION void set(int s, const Fit& f, double share_here) const {
    const double length = Kokkos::sqrt(f.x * f.x + f.y * f.y);
    constexpr double least = 0.1;
    const bool is_defined = length > least;
    const double over = 1 / (is_defined ? length : 1.0), nx = f.x * over, ny = f.y * over;
    const double curving = -(f.xx * ny * ny - 2 * f.xy * nx * ny + f.yy * nx * nx) * over;
    const double curvature = curving < -0.5 ? -0.5 : curving > 0.5 ? 0.5 : curving;  // a pixel resolves no sharper bend
    const double missing = 1 - share_here;
    const double share = is_defined ? 1 - 0.4 * (missing < 1 ? missing : 1.0) * curvature : 0.0;
    normal(s, 0) = -nx * share;
    normal(s, 1) = -ny * share;
  }
  KOKKOS_FUNCTION void operator()(int s) const { set(s, fit_around(node(s)), V(node(s))); }
};

/// A block of surface nodes on a host: the five columns around a node are five lanes of a pack, and what follows from
/// the fits of all nodes vectorises. The same bits as one by one.
template <class T>
struct NormalsOfBlock {
  SurfaceNormal one;
  int count;

  /// Prefetches both ends of the five rows around a later surface node, because these are scattered over the lattice.
  /// Inlined, because a compiler may drop a call without effect.
  KOKKOS_FORCEINLINE_FUNCTION void announce(int s) const {
    constexpr int ahead = 24;
    const int later = one.node(s + ahead < count ? s + ahead : count - 1), pitch = one.lattice.lattice.pitch;
    VUG_UNROLL
    for (int dy = -2; dy <= 2; ++dy)
      for (const T* field : {one.volume.data(), one.dissolved.data()}) {
        prefetch(field + (later + dy * pitch - 2));
        prefetch(field + (later + dy * pitch + 2));
      }
  }
  /// Solid shares of the nodes from n on; those behind the fifth are not used.
  Pack<T> row(int n) const {
    using P = PackOf<T>;
    const Pack<T> volume = P::load(&one.volume(n)), given = volume + P::load(&one.dissolved(n));
    return P::any_above(given, Pack<T>{} + own_cell) ? of_heirs(n) : volume;
  }
  /// The same where a node was given more than its own cell.
  __attribute__((noinline)) Pack<T> of_heirs(int n) const {
    T share[pack_size];
    for (int l = 0; l < pack_size; ++l) share[l] = one.V(n + l);
    return PackOf<T>::load(share);
  }
  SurfaceNormal::Fit fit_around(int n) const {
    if (!one.is_inside(n)) return one.fit_around(n);
    Pack<T> rows[5];
    VUG_UNROLL
    for (int dy = 0; dy < 5; ++dy) rows[dy] = row(n + (dy - 2) * one.lattice.lattice.pitch - 2);
    T levels[pack_size], slopes[pack_size], bends[pack_size];
    PackOf<T>::store(levels, SurfaceNormal::level(rows));
    PackOf<T>::store(slopes, SurfaceNormal::slope(rows));
    PackOf<T>::store(bends, SurfaceNormal::bend(rows));
    return SurfaceNormal::across(levels, slopes, bends);
  }
  void operator()(int first, int last) const {
    const NormalsOfBlock local = *this;
    T x[nodes_per_block], y[nodes_per_block], xx[nodes_per_block], yy[nodes_per_block], xy[nodes_per_block],
        share[nodes_per_block];
    const int nodes = last - first;
    for (int i = 0; i < nodes; ++i) {
      local.announce(first + i);
      const int n = local.one.node(first + i);
      const SurfaceNormal::Fit f = local.fit_around(n);
      x[i] = f.x;
      y[i] = f.y;
      xx[i] = f.xx;
      yy[i] = f.yy;
      xy[i] = f.xy;
      share[i] = local.one.V(n);
    }
    VUG_VECTORISE
    for (int i = 0; i < nodes; ++i) local.one.set(first + i, {x[i], y[i], xx[i], yy[i], xy[i]}, share[i]);
  }
};

template <class T>
static void launch_normals(const Exec& exec, const Share& list, const SurfaceNormal& normal) {
  const char* label = "vug::surface_normal::find";
  if constexpr (runs_on_host)
    for_each_block(exec, label, list, NormalsOfBlock<T>{normal, list.n}, block_of_list(list.n));
  else
    for_each_node(exec, label, list, normal);
}

void find_normals(const Exec& exec, const FluidNodes& nodes, const Surface& surface, const ScalarField<double>& volume,
                  const ScalarField<double>& dissolved, VectorField<double>& normal, const std::optional<Share>& only) {
  if (static_cast<int>(normal.extent(0)) < surface.count)
    normal = VectorField<double>("vug::surface_normal::normal", surface.count + surface.count / 2);
  launch_normals<double>(exec, only.value_or(Share(surface.count)),
                         SurfaceNormal{nodes.around(), surface.node, volume, dissolved, normal});
}

/// Area of the links of one surface node.
template <class Set>
struct SurfaceNodeArea {
  DenseNeighbour lattice;
  IndexList node, index;
  LinkArea area;
  ReactingNodes reacts;
  KOKKOS_FUNCTION double operator()(int s) const {
    if (!reacts(node(s))) return 0;
    double sum = 0;
    for (int q = 1; q < Set::Q; ++q) {
      if (lattice.fluid_along(index, node(s), q) >= 0) sum += 6 * Set::w(q) * area.share(s, q);
    }
    return sum;
  }
};

template <class Set>
double surface_area(const Exec& exec, const FluidNodes& nodes, const Surface& surface,
                    const VectorField<double>& normal, const ReactingNodes& reacts) {
  return sum_of_list(exec, "vug::surface_normal::sum_area", surface.count,
                     SurfaceNodeArea<Set>{nodes.around(), surface.node, nodes.index, {normal}, reacts});
}

VUG_COMPILE(surface_area<D2Q5>)
VUG_COMPILE(surface_area<D2Q9>)

}  // namespace vug
