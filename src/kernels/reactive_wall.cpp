#include "kernels/reactive_wall_kernel.hpp"

namespace vug {

#define VUG_INSTANTIATE(T, Set)                                                                \
  template void react_at_wall<Set, T, UniformRate>(                                            \
      const Exec&, const FluidNodes&, const Surface&, const ReactiveWall&, const UniformRate&, \
      const VectorField<double>&, const SoluteFields<T>&, const SoluteFields<T>*, const ReactionLedger&);
VUG_INSTANTIATE(float, D2Q5)
VUG_INSTANTIATE(double, D2Q5)
VUG_INSTANTIATE(float, D2Q9)
VUG_INSTANTIATE(double, D2Q9)
#undef VUG_INSTANTIATE

}  // namespace vug
