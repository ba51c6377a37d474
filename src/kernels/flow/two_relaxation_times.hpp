#pragma once
// The collision of flow populations with two relaxation times, and with one (BGK), as a small pure function object like
// those of mrt.hpp.
#include "kernels/flow/mrt.hpp"
#include "kernels/packs/pack.hpp"

#include <type_traits>

namespace vug {

/// Whether two relaxation times must keep the momentum by their form. Weights and rates rounded to float would take or
/// give up to 1e-7 of it at every node in every step, always with the same sign. Beside the force 8 nu u/n^2 that
/// drives a channel of n cells that is 0.5 % for n = 100, nu = 0.02. In double precision it is 1e-9 of that.
template <class T>
inline constexpr bool conserves_in_float = std::is_same_v<T, float>;

/// Two relaxation times: the even part of f relaxes with `even` = s_nu, the odd part with `odd` = s_q. The same as the
/// moment form with s_e = s_eps = s_nu, in half the arithmetic; equal rates are BGK. Rates have the type R, because
/// those of several nodes may differ. What the moving populations gain is subtracted from the one at rest: rounded
/// weights do not add up to one, and the difference (7e-9 of rho' in float) would be gained or lost at every node in
/// every step. Giving it the rest of rho' instead would be rounded in the same way in every step of a steady flow (the
/// mass of a fluid was 1.5e-5 off after 32 000 steps).
///
/// Where conserves_in_float, the odd part relaxes by its changes, which have no momentum however they are rounded.
template <class T, class R = T>
struct TwoRelaxationTimes {
  R even, odd;
  TwoRelaxationTimes(const RelaxationRates& rates) : even(T(rates.s_nu)), odd(T(rates.s_q)) {}
  KOKKOS_FORCEINLINE_FUNCTION TwoRelaxationTimes(const R& even_rate, const R& odd_rate)
      : even(even_rate), odd(odd_rate) {}

  template <class V, class Force>
  KOKKOS_FORCEINLINE_FUNCTION void operator()(V (&f)[9], const Macroscopic<V>& m, const Force& force) const {
    const V isotropic = m.rho - T(1.5) * (m.ux * m.ux + m.uy * m.uy);
    const V power = m.ux * force.x + m.uy * force.y;
    const R even_kept = (T(1) - even) / 2, odd_kept = (T(1) - odd) / 2;
    const V on_axes = T(D2Q9::w(1)) * even * isotropic;
    const Odd<V> turned = odd_change(f);
    V gained{};
    unroll<D2Q9::Q>([&](auto direction) VUG_INLINED {
      constexpr int q = direction, opposite = D2Q9::opposite(q);
      if constexpr (q < opposite) {
        constexpr T w = T(D2Q9::w(q)), of_axes = T(D2Q9::w(q) / D2Q9::w(1));
        const V cu = along(q, m.ux, m.uy), there = f[q], back = f[opposite];
        const V even_target = of_axes * on_axes + T(4.5) * w * even * (cu * cu);
        V even_part, odd_part;  // of the populations or, by changes, of what they gain
        if constexpr (by_changes) {
          even_part = even_target - even / 2 * (there + back);
          odd_part = (q < 5 ? T(-2) : T(1)) * along(q, turned.x, turned.y);
        } else {
          even_part = even_kept * (there + back) + even_target;
          odd_part = odd_kept * (there - back) + T(3) * w * odd * cu;
        }
        if constexpr (Force::present) {
          const auto cF = along(q, force.x, force.y);
          even_part += (T(1) - even / 2) * w * (T(9) * cu * cF - T(3) * power);
          if constexpr (by_changes)
            odd_part += T(3) * w * cF;
          else
            odd_part += (T(1) - odd / 2) * T(3) * w * cF;
        }
        f[q] = even_part + odd_part;
        f[opposite] = even_part - odd_part;
        if constexpr (by_changes) {
          f[q] += there;
          f[opposite] += back;
        }
        gained += (f[q] - there) + (f[opposite] - back);
      }
    });
    f[0] -= gained;
  }

 private:
  static constexpr bool by_changes = conserves_in_float<T>;
  template <class V>
  struct Odd {
    V x{}, y{};
  };
  /// (x, y) = odd (q_eq - q)/12 with the odd moments q other than the momentum j, q_eq = -j: a diagonal population
  /// gains c.(x, y), one on an axis -2 c.(x, y). Nothing where it is not needed.
  template <class V>
  KOKKOS_FORCEINLINE_FUNCTION Odd<V> odd_change(const V (&f)[9]) const {
    Odd<V> change;
    if constexpr (by_changes) {
      const V d57 = f[5] - f[7], d86 = f[8] - f[6];
      const R rate = T(1.0 / 12) * odd;
      change.x = rate * ((f[1] - f[3]) - T(2) * (d57 + d86));
      change.y = rate * ((f[2] - f[4]) - T(2) * (d57 - d86));
    }
    return change;
  }
};

/// Two relaxation times of a viscosity that differs from node to node: spread (fluid) = tau - 1/2 = 3 nu.
template <class T>
struct VaryingRelaxationTimes {
  Kokkos::View<const T*> spread;
  T magic;  ///< (tau_even - 1/2)(tau_odd - 1/2); 0: both are the same
  template <class V>
  KOKKOS_FORCEINLINE_FUNCTION TwoRelaxationTimes<T, V> at(int i) const {
    const V wide = fetch<V>(&spread(i)), even = T(1) / (wide + T(0.5));
    return {even, magic > 0 ? wide / (T(0.5) * wide + magic) : even};
  }
};

}  // namespace vug
