#include "kernels/reaction/mineral_sums.hpp"

#include "kernels/launch/launch.hpp"

namespace vug {

/// The value where the mineral is `wanted`, else 0.
struct OfMineral {
  Kokkos::View<const double*> value;
  Kokkos::View<const std::uint8_t*> mineral;
  int wanted;
  KOKKOS_FUNCTION double operator()(int i) const { return mineral(i) == wanted ? value(i) : 0.0; }
};

std::vector<double> sums_by_mineral(const Exec& exec, const std::string& label, int n,
                                    const Kokkos::View<const double*>& value,
                                    const Kokkos::View<const std::uint8_t*>& mineral, int minerals) {
  std::vector<double> sums;
  const ScalarField<double> partial("vug::minerals::partial", block_count(n));
  for (int m = 0; m < minerals; ++m) {
    Kokkos::deep_copy(exec, partial, 0.0);
    add_per_block(exec, label, n, OfMineral{value, mineral, m}, partial);
    exec.fence();
    sums.push_back(sum_in_order(partial));
  }
  return sums;
}

}  // namespace vug
