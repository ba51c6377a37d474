#include "coupling/handed_push.hpp"

#include "dem/dissolved_rock.hpp"
#include "kernels/launch/launch.hpp"

namespace vug {

namespace {

/// Who leans on whom.
struct Leaning {
  TriangleNeighbours neighbours;
  Particles p;

  KOKKOS_FORCEINLINE_FUNCTION bool gone(int t) const { return is_gone(p.solid_fraction(t)); }
  KOKKOS_FORCEINLINE_FUNCTION Vec2 force(int t) const { return {p.force(t, 0), p.force(t, 1)}; }
  KOKKOS_FORCEINLINE_FUNCTION Vec2 between(int from, int to) const {
    return {p.x0(to, 0) - p.x0(from, 0), p.x0(to, 1) - p.x0(from, 1)};
  }
  /// How much triangle g, which is gone, leans on t (-1: none there).
  KOKKOS_FUNCTION double on(int g, int t) const {
    return t < 0 || gone(t) ? 0.0 : Kokkos::fmax(0.0, dot(force(g), between(g, t)));
  }
  KOKKOS_FUNCTION double on_all(int g) const {
    return on(g, neighbours(g, 0)) + on(g, neighbours(g, 1)) + on(g, neighbours(g, 2));
  }
};

struct TakePush {
  Leaning leaning;
  KOKKOS_FUNCTION void operator()(int t) const {
    const Particles& p = leaning.p;
    if (leaning.gone(t)) return;
    for (int k = 0; k < 3; ++k) {
      const int g = leaning.neighbours(t, k);
      if (g < 0 || !leaning.gone(g)) continue;
      const double own = leaning.on(g, t);
      if (own == 0) continue;
      const double share = own / leaning.on_all(g);
      const Vec2 f = share * leaning.force(g);
      p.force(t, 0) += f.x;
      p.force(t, 1) += f.y;
      p.torque(t) += share * p.torque(g) + cross(leaning.between(t, g), f);
    }
  }
};

}  // namespace

void hand_on_push(const Exec& exec, const TriangleNeighbours& neighbours, const Particles& particles) {
  for_each_node(exec, "vug::mechanics::take_push", particles.count, TakePush{{neighbours, particles}});
}

}  // namespace vug
