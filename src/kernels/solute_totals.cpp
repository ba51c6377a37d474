#include "kernels/solute_totals.hpp"

#include "kernels/streaming.hpp"

namespace vug {

template <class Set, class T>
double total_solute(const Exec& exec, const FluidNodes& nodes, const SoluteFields<T>& s) {
  const ScalarField<double> total("vug::solute_totals::total", block_count(nodes.count));
  add_per_block(exec, "vug::solute_totals::sum", nodes.count, SumOfSlots<T, Set>{s.h, nodes.capacity}, total);
  exec.fence();
  return sum_in_order(total);
}

template <class T>
struct RangeOfField {
  Kokkos::View<const T*> field;
  KOKKOS_FUNCTION void operator()(int i, double& least, double& most, int& first_bad) const {
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
FieldRange field_range(const Exec& exec, const ScalarField<T>& field, int count) {
  FieldRange range;
  int first_bad = count;
  Kokkos::parallel_reduce("vug::solute_totals::range", Kokkos::RangePolicy<Exec>(exec, 0, count),
                          RangeOfField<T>{field}, Kokkos::Min<double>(range.min), Kokkos::Max<double>(range.max),
                          Kokkos::Min<int>(first_bad));
  if (first_bad < count) range.first_not_finite = first_bad;
  return range;
}

#define VUG_INSTANTIATE(T)                                                                       \
  template double total_solute<D2Q5, T>(const Exec&, const FluidNodes&, const SoluteFields<T>&); \
  template double total_solute<D2Q9, T>(const Exec&, const FluidNodes&, const SoluteFields<T>&); \
  template FieldRange field_range<T>(const Exec&, const ScalarField<T>&, int);
VUG_INSTANTIATE(float)
VUG_INSTANTIATE(double)
#undef VUG_INSTANTIATE

}  // namespace vug
