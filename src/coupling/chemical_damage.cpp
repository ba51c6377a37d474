#include "coupling/chemical_damage.hpp"

#include "coupling/group_sum.hpp"
#include "kernels/launch.hpp"

namespace vug {

struct NodeValue {
  Kokkos::View<const double*> values;
  KOKKOS_FUNCTION double operator()(int node, int) const { return values(node); }
};

struct StoreShare {
  Kokkos::View<const double*> initial;
  ScalarField<double> share;
  KOKKOS_FUNCTION void operator()(int group, double dissolved) const {
    const double ratio = initial(group) > 0 ? dissolved / initial(group) : 0.0;
    share(group) = ratio < 1 ? ratio : 1.0;
  }
};

void dissolved_share(const Exec& exec, const Groups& groups, const ScalarField<double>& dissolved,
                     const ScalarField<double>& initial, const ScalarField<double>& share) {
  sum_groups<double>(exec, "vug::chemical_damage::share", groups, NodeValue{dissolved}, StoreShare{initial, share});
}

struct StoreSum {
  ScalarField<double> sum;
  KOKKOS_FUNCTION void operator()(int group, double value) const { sum(group) = value; }
};

void sum_over_nodes(const Exec& exec, const Groups& groups, const ScalarField<double>& values,
                    const ScalarField<double>& sum) {
  sum_groups<double>(exec, "vug::chemical_damage::sum", groups, NodeValue{values}, StoreSum{sum});
}

struct Complement {
  Kokkos::View<const double*> share;
  ScalarField<double> remaining;
  KOKKOS_FUNCTION void operator()(int g) const { remaining(g) = 1 - share(g); }
};

void remaining_share(const Exec& exec, const ScalarField<double>& share, const ScalarField<double>& remaining) {
  for_each_node(exec, "vug::chemical_damage::remaining", static_cast<int>(share.extent(0)),
                Complement{share, remaining});
}

}  // namespace vug
