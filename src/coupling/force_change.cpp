#include "coupling/force_change.hpp"

#include "kernels/base/host_and_device.hpp"

namespace vug {

namespace {

struct ChangeOfForce {
  VectorField<double> force, before;
  IndexList only;
  bool all;
  KOKKOS_FUNCTION void operator()(int item, double& change, double& most) const {
    const int i = all ? item : only(item);
    const double x = force(i, 0), y = force(i, 1);
    change = Kokkos::max(change, Kokkos::hypot(x - before(i, 0), y - before(i, 1)));
    most = Kokkos::max(most, Kokkos::hypot(x, y));
    before(i, 0) = x;
    before(i, 1) = y;
  }
};

}  // namespace

ForceChange largest_force_change(const Exec& exec, const VectorField<double>& force, const VectorField<double>& before,
                                 const std::optional<IndexList>& only) {
  ForceChange found;
  const int count = static_cast<int>(only ? only->extent(0) : force.extent(0));
  Kokkos::parallel_reduce("vug::mechanics::force_change", Kokkos::RangePolicy<Exec>(exec, 0, count),
                          ChangeOfForce{force, before, only.value_or(IndexList()), !only},
                          Kokkos::Max<double>(found.change), Kokkos::Max<double>(found.force));
  if (count == 0) return {};
  return found;
}

}  // namespace vug
