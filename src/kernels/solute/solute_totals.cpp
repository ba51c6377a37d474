#include "kernels/solute/solute_totals.hpp"

#include "kernels/launch/launch.hpp"
#include "kernels/nodes/streaming.hpp"

namespace vug {

template <class Set, class T>
void add_solute(const Exec& exec, const FluidNodes& nodes, const SoluteFields<T>& s, const ScalarField<double>& total) {
  add_per_block(exec, "vug::solute_totals::sum", nodes.share(), SumOfSlots<T, Set>{s.h, nodes.capacity}, total);
}

template <class T>
struct ChangeOfNode {
  Kokkos::View<const T*> C;
  int count;
  ScalarField<T> before;
  KOKKOS_FUNCTION double operator()(int i) const {
    const double change = double(C(i)) - double(before(i));
    before(i) = C(i);
    return i < count ? Kokkos::abs(change) : 0;
  }
};

template <class T>
void add_change(const Exec& exec, const FluidNodes& nodes, const Kokkos::View<const T*>& C, int count,
                const ScalarField<T>& before, const ScalarField<double>& total) {
  add_per_block(exec, "vug::solute_totals::change", nodes.share(), ChangeOfNode<T>{C, count, before}, total);
}

VUG_COMPILE_FOR_NUMBERS(add_change)
VUG_COMPILE_FOR_SETS(add_solute)

}  // namespace vug
