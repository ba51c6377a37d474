#include "coupling/thermal_exchange.hpp"

#include "coupling/group_sum.hpp"

namespace vug {

template <class T>
struct NodeTemperature {
  Kokkos::View<const T*> theta;
  KOKKOS_FUNCTION double operator()(int node, int) const { return static_cast<double>(theta(node)); }
};

struct StoreMean {
  IndexList offset;
  double reference;
  ScalarField<double> change;
  KOKKOS_FUNCTION void operator()(int particle, double sum) const {
    const int nodes = offset(particle + 1) - offset(particle);
    change(particle) = nodes > 0 ? sum / nodes - reference : 0.0;
  }
};

template <class T>
void warm_particles(const Exec& exec, const Groups& nodes_of_particle, const ScalarField<T>& theta, double reference,
                    const ScalarField<double>& change) {
  sum_groups<double>(exec, "vug::thermal_exchange::mean", nodes_of_particle, NodeTemperature<T>{theta},
                     StoreMean{nodes_of_particle.offset, reference, change});
}

template void warm_particles(const Exec&, const Groups&, const ScalarField<float>&, double, const ScalarField<double>&);
template void warm_particles(const Exec&, const Groups&, const ScalarField<double>&, double,
                             const ScalarField<double>&);

}  // namespace vug
