#pragma once
// Collisions of the flow populations (paper Sec. 3.1: multiple relaxation times), each a small pure function object:
//   f* = f - M^-1 S (M f - meq) + M^-1 (1 - S/2) F,
// with M the moment basis of Lallemand and Luo. All conserve rho' = sum f and add exactly the body force to sum c f.
// They take the populations of one node or of several at once: V is the number type T or a pack of such numbers.
#include "base/choices.hpp"
#include "kernels/flow/equilibrium.hpp"
#include "kernels/packs/pack.hpp"

namespace vug {

/// Rates of shear stress, energy, energy squared and energy flux; s_nu = 1/tau, nu = (tau - 1/2)/3.
struct RelaxationRates {
  double s_nu = 1, s_e = 1, s_eps = 1, s_q = 1;
};

/// The odd rate that belongs to an even rate s at the magic product Lambda = (1/s - 1/2)(1/s_q - 1/2).
KOKKOS_INLINE_FUNCTION constexpr double odd_rate(double s, double magic) {
  return 1 / (0.5 + magic / (1 / s - 0.5));
}

/// Lambda with which halfway bounce-back puts a straight wall exactly half way.
inline constexpr double exact_wall_magic = 3.0 / 16.0;

inline constexpr RelaxationRates relaxation_rates(Collision collision, double tau) {
  const double s_nu = 1 / tau;
  switch (collision) {
    case Collision::trt:
      return {s_nu, s_nu, s_nu, odd_rate(s_nu, exact_wall_magic)};
    case Collision::lallemand_luo:
      return {s_nu, 1.63, 1.14, 1.92};
    case Collision::bgk:
      return {s_nu, s_nu, s_nu, s_nu};
    case Collision::regularised:
      break;
  }
  return {s_nu, s_nu, 1, 1};
}

/// The product Lambda of the rates, which decides where a straight wall comes to lie.
inline constexpr double wall_magic(const RelaxationRates& rates) {
  return (1 / rates.s_nu - 0.5) * (1 / rates.s_q - 0.5);
}

/// Flow through a straight channel of n rows over that between plates n cells apart, 1 + (8 Lambda - 1)/n^2: the slip
/// of halfway bounce-back, (4 Lambda/3 - 1/4) G/(2 nu) (Ginzburg and d'Humieres 2003), and the sum over n points in
/// place of the integral.
inline constexpr double carried_by_rows(int n, double magic) {
  return 1 + (8 * magic - 1) / (n * n);
}

/// The moment basis, rows (rho', e, eps, jx, qx, jy, qy, pxx, pxy) over q; rows are orthogonal.
struct MomentBasis {
  enum Moment { rho, e, eps, jx, qx, jy, qy, pxx, pxy };
  KOKKOS_FORCEINLINE_FUNCTION static constexpr int row(int moment, int q) {
    const int cx = D2Q9::c(q, 0), cy = D2Q9::c(q, 1), c2 = cx * cx + cy * cy;
    switch (moment) {
      case rho:
        return 1;
      case e:
        return 3 * c2 - 4;
      case eps:
        return (9 * c2 * c2 - 21 * c2 + 8) / 2;
      case jx:
        return cx;
      case qx:
        return (3 * c2 - 5) * cx;
      case jy:
        return cy;
      case qy:
        return (3 * c2 - 5) * cy;
      case pxx:
        return cx * cx - cy * cy;
      default:
        return cx * cy;
    }
  }
  KOKKOS_FORCEINLINE_FUNCTION static constexpr int norm2(int moment) {
    constexpr int norms[9] = {9, 36, 36, 6, 12, 6, 12, 4, 4};
    return norms[moment];
  }
};

/// The law, or the force, of node i or of a pack of nodes from there on: of one that differs from node to node its
/// at<V>(i), otherwise itself.
template <class V, class Law>
KOKKOS_FORCEINLINE_FUNCTION decltype(auto) law_at(const Law& law, int i) {
  if constexpr (requires { law.template at<V>(i); })
    return law.template at<V>(i);
  else
    return (law);
}

/// No body force: costs nothing in the kernel.
template <class T>
struct NoForce {
  static constexpr bool present = false;
  T x = 0, y = 0;
};
/// A body force per volume over the reference density, the same everywhere, lattice units.
template <class T>
struct BodyForce {
  static constexpr bool present = true;
  T x, y;
};
/// The same with the buoyancy of the node's temperature (Boussinesq): force + per_kelvin theta.
template <class T>
struct Buoyancy {
  static constexpr bool present = true;
  T x, y, x_per_kelvin, y_per_kelvin;
  Kokkos::View<const T*> theta;  ///< (fluid)
  template <class V>
  KOKKOS_FORCEINLINE_FUNCTION BodyForce<V> at(int i) const {
    const V warmth = fetch<V>(&theta(i));
    return {x + x_per_kelvin * warmth, y + y_per_kelvin * warmth};
  }
};

/// Relaxes every moment with its own rate.
template <class T>
struct MultipleRelaxationTimes {
  T s_nu, s_e, s_eps, s_q;
  MultipleRelaxationTimes(const RelaxationRates& r)
      : s_nu(T(r.s_nu)), s_e(T(r.s_e)), s_eps(T(r.s_eps)), s_q(T(r.s_q)) {}

  template <class V, class Force>
  KOKKOS_FORCEINLINE_FUNCTION void operator()(V (&f)[9], const Macroscopic<V>& m, const Force& force) const {
    using M = MomentBasis;
    const V ux = m.ux, uy = m.uy, u2 = ux * ux + uy * uy, zero{};
    const T rate[9] = {T(0), s_e, s_eps, T(0), s_q, T(0), s_q, s_nu, s_nu};
    const V meq[9] = {zero,   T(3) * u2 - T(2) * m.rho, m.rho - T(3) * u2, zero, -ux, zero, -uy, ux * ux - uy * uy,
                      ux * uy};
    const V power = ux * force.x + uy * force.y;
    const V source[9] = {zero,
                         T(6) * power,
                         T(-6) * power,
                         zero + force.x,
                         zero - force.x,
                         zero + force.y,
                         zero - force.y,
                         T(2) * (ux * force.x - uy * force.y),
                         ux * force.y + uy * force.x};
    V change[9] = {};
    unroll<9>([&](auto moment) VUG_INLINED {
      constexpr int k = moment;
      if constexpr (k == M::rho || ((k == M::jx || k == M::jy) && !Force::present)) return;
      V value = zero;
      if constexpr (k != M::jx && k != M::jy) {
        unroll<9>([&](auto q) VUG_INLINED {
          if constexpr (M::row(k, q) != 0) value += T(M::row(k, q)) * f[q];
        });
        value = rate[k] * (meq[k] - value);
      }
      if constexpr (Force::present) value += (T(1) - rate[k] / 2) * source[k];
      value *= T(1.0 / M::norm2(k));
      unroll<9>([&](auto q) VUG_INLINED {
        if constexpr (M::row(k, q) != 0) change[q] += T(M::row(k, q)) * value;
      });
    });
    unroll<9>([&](auto q) VUG_INLINED { f[q] += change[q]; });
  }
};

/// f* = feq + 9/2 w (cc - c_s^2 I) : [(1 - s_nu) Pi_neq + (1 - s_nu/2)(uF + Fu)] + 3/2 w c.F; the population at rest
/// loses what the moving ones gain, for the reason given at TwoRelaxationTimes.
template <class T>
struct Regularised {
  T s_nu;
  Regularised(const RelaxationRates& rates) : s_nu(T(rates.s_nu)) {}

  template <class V, class Force>
  KOKKOS_FORCEINLINE_FUNCTION void operator()(V (&f)[9], const Macroscopic<V>& m, const Force& force) const {
    const V isotropic = m.rho - T(1.5) * (m.ux * m.ux + m.uy * m.uy);
    V xx{}, yy{}, xy{};
    unroll<9>([&](auto direction) VUG_INLINED {
      constexpr int q = direction, cx = D2Q9::c(q, 0), cy = D2Q9::c(q, 1);
      if constexpr (cx != 0) xx += f[q];
      if constexpr (cy != 0) yy += f[q];
      if constexpr (cx * cy != 0) xy += T(cx * cy) * f[q];
    });
    // second moments of the equilibrium: rho'/3 I + u u
    xx = (T(1) - s_nu) * (xx - m.rho / T(3) - m.ux * m.ux);
    yy = (T(1) - s_nu) * (yy - m.rho / T(3) - m.uy * m.uy);
    xy = (T(1) - s_nu) * (xy - m.ux * m.uy);
    if constexpr (Force::present) {
      xx += (T(2) - s_nu) * m.ux * force.x;
      yy += (T(2) - s_nu) * m.uy * force.y;
      xy += (T(1) - s_nu / 2) * (m.ux * force.y + m.uy * force.x);
    }
    V gained{};
    unroll<9>([&](auto direction) VUG_INLINED {
      constexpr int q = direction, cx = D2Q9::c(q, 0), cy = D2Q9::c(q, 1);
      if constexpr (q == 0) return;
      const V cu = along(q, m.ux, m.uy);
      V stress = (T(cx * cx) - T(1.0 / 3.0)) * xx + (T(cy * cy) - T(1.0 / 3.0)) * yy;
      if constexpr (cx * cy != 0) stress += T(2 * cx * cy) * xy;
      V value = isotropic + T(3) * cu + T(4.5) * (cu * cu + stress);
      if constexpr (Force::present) value += T(1.5) * along(q, force.x, force.y);
      const V before = f[q];
      f[q] = T(D2Q9::w(q)) * value;
      gained += f[q] - before;
    });
    f[0] -= gained;
  }
};

}  // namespace vug
