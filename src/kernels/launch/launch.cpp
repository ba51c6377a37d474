#include "kernels/launch/launch.hpp"

namespace vug {

namespace {

constexpr int most_copied = 1 << 16;

}  // namespace

double sum_in_order(const ScalarField<double>& values) {
  if constexpr (!runs_on_host)
    if (const int n = static_cast<int>(values.extent(0)); n > most_copied)
      return sum_of_list(Exec{}, "vug::sum_in_order", n, ValueOf{values});
  const auto host = on_host(values);
  double sum = 0;
  for (std::size_t i = 0; i < host.extent(0); ++i) sum += host(i);
  return sum;
}

}  // namespace vug
