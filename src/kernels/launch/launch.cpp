#include "kernels/launch/launch.hpp"

#include "kernels/base/host_and_device.hpp"

namespace vug {

double sum_in_order(const ScalarField<double>& values) {
  const auto host = on_host(values);
  double sum = 0;
  for (std::size_t i = 0; i < host.extent(0); ++i) sum += host(i);
  return sum;
}

}  // namespace vug
