#pragma once
// Effect of the flow through a boundary on a scalar that has a given value there.
#include "kernels/scalar/displacement.hpp"
#include "kernels/scalar/scalar_equilibrium.hpp"

namespace vug {

/// The links through which fluid crosses a boundary and the displacement of the fluid in a step of the scalar. By
/// default it crosses nowhere.
template <class T>
struct Crossing {
  Kokkos::View<const std::uint16_t*> open_links{};  ///< (fluid) as of FluidNodes
  Displacement<T> u{VectorField<T>()};

  /// Sum of the populations that go out and come in through link q of fluid node i at equilibrium, over 2 w C: one at
  /// rest and on D2Q5. On D2Q9 it has the even part of the equilibrium, without which fluid that flows in has that much
  /// less of the scalar than the boundary.
  template <class Set>
  KOKKOS_FORCEINLINE_FUNCTION T pair(int i, int q) const {
    if constexpr (Set::Q == D2Q5::Q) {
      return T(1);
    } else {
      if (open_links.extent(0) == 0 || !(open_links(i) >> q & 1)) return T(1);
      return T(1) + scalar_even_part<T>(q, u(i, 0), u(i, 1));
    }
  }
};

}  // namespace vug
