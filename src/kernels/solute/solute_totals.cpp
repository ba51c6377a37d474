#include "kernels/solute/solute_totals.hpp"

#include "kernels/launch/own_items.hpp"
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

template <class T>
struct RangeOfField {
  Kokkos::View<const T*> field;
  OwnItems own;
  KOKKOS_FUNCTION void operator()(int place, double& least, double& most, int& first_bad) const {
    const int i = own(place);
    if (i < 0) return;
    const double value = double(field(i));
    if (!Kokkos::isfinite(value)) {
      if (i < first_bad) first_bad = i;
      return;
    }
    if (value < least) least = value;
    if (value > most) most = value;
  }
};

template <class T>
FieldRange field_range(const Exec& exec, const ScalarField<T>& field, const Share& list) {
  FieldRange range;
  const OwnItems own{list};
  int first_bad = list.n;
  Kokkos::parallel_reduce("vug::solute_totals::range", Kokkos::RangePolicy<Exec>(exec, 0, own.places()),
                          RangeOfField<T>{field, own}, Kokkos::Min<double>(range.min), Kokkos::Max<double>(range.max),
                          Kokkos::Min<int>(first_bad));
  if (first_bad < list.n) range.first_not_finite = first_bad;
  return range;
}

#define VUG_INSTANTIATE(T)                                                                        \
  template void add_change<T>(const Exec&, const FluidNodes&, const Kokkos::View<const T*>&, int, \
                              const ScalarField<T>&, const ScalarField<double>&);                 \
  template void add_solute<D2Q5, T>(const Exec&, const FluidNodes&, const SoluteFields<T>&,       \
                                    const ScalarField<double>&);                                  \
  template void add_solute<D2Q9, T>(const Exec&, const FluidNodes&, const SoluteFields<T>&,       \
                                    const ScalarField<double>&);                                  \
  template FieldRange field_range<T>(const Exec&, const ScalarField<T>&, const Share&);
VUG_INSTANTIATE(float)
VUG_INSTANTIATE(double)
#undef VUG_INSTANTIATE

}  // namespace vug
