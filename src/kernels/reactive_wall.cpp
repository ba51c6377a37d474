#include "kernels/reactive_wall_kernel.hpp"

namespace vug {

template void store_rates(const Exec&, const FluidNodes&, const Surface&, const UniformRate&,
                          const ScalarField<double>&);

#define VUG_INSTANTIATE(T, Set, Rate)                                                                            \
  template void react_at_wall<Set, T, Rate>(const Exec&, const FluidNodes&, const Surface&, const ReactiveWall&, \
                                            const Rate&, const VectorField<double>&, const SoluteFields<T>&,     \
                                            const SoluteFields<T>*, const ReactionLedger&);
VUG_INSTANTIATE(float, D2Q5, UniformRate)
VUG_INSTANTIATE(float, D2Q5, StoredRate)
VUG_INSTANTIATE(double, D2Q5, UniformRate)
VUG_INSTANTIATE(double, D2Q5, StoredRate)
VUG_INSTANTIATE(float, D2Q9, UniformRate)
VUG_INSTANTIATE(float, D2Q9, StoredRate)
VUG_INSTANTIATE(double, D2Q9, UniformRate)
VUG_INSTANTIATE(double, D2Q9, StoredRate)
#undef VUG_INSTANTIATE

}  // namespace vug
