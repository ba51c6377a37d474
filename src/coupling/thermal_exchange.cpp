#include "coupling/thermal_exchange.hpp"

#include "coupling/run_sum.hpp"

namespace vug {

struct StoreMean {
  IndexList nodes;
  double reference;
  ScalarField<double> change;
  KOKKOS_FUNCTION void operator()(int particle, double sum) const {
    change(particle) = nodes(particle) > 0 ? sum / nodes(particle) - reference : 0.0;
  }
};

template <class T>
void warm_particles(const Exec& exec, const NodeGroups& nodes_of_particle, const ScalarField<T>& theta,
                    double reference, const ScalarField<double>& change, const std::optional<IndexList>& only) {
  sum_runs(exec, "vug::thermal_exchange::mean", nodes_of_particle, theta,
           StoreMean{nodes_of_particle.nodes, reference, change}, only);
}

template void warm_particles(const Exec&, const NodeGroups&, const ScalarField<float>&, double,
                             const ScalarField<double>&, const std::optional<IndexList>&);
template void warm_particles(const Exec&, const NodeGroups&, const ScalarField<double>&, double,
                             const ScalarField<double>&, const std::optional<IndexList>&);

}  // namespace vug
