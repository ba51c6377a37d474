#include "kernels/launch/launch.hpp"

namespace vug {

double sum_in_order(const ScalarField<double>& values) {
  const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, values);
  double sum = 0;
  for (std::size_t i = 0; i < host.extent(0); ++i) sum += host(i);
  return sum;
}

}  // namespace vug
