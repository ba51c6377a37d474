#include "coupling/force_change.hpp"

namespace vug {

namespace {

struct ChangeOfForce {
  VectorField<double> force, before;
  KOKKOS_FUNCTION void operator()(int i, double& change, double& most) const {
    const double x = force(i, 0), y = force(i, 1);
    change = Kokkos::max(change, Kokkos::hypot(x - before(i, 0), y - before(i, 1)));
    most = Kokkos::max(most, Kokkos::hypot(x, y));
    before(i, 0) = x;
    before(i, 1) = y;
  }
};

}  // namespace

ForceChange largest_force_change(const Exec& exec, const VectorField<double>& force,
                                 const VectorField<double>& before) {
  ForceChange found;
  const int count = static_cast<int>(force.extent(0));
  if (count == 0) return found;
  Kokkos::parallel_reduce("vug::mechanics::force_change", Kokkos::RangePolicy<Exec>(exec, 0, count),
                          ChangeOfForce{force, before}, Kokkos::Max<double>(found.change),
                          Kokkos::Max<double>(found.force));
  return found;
}

}  // namespace vug
