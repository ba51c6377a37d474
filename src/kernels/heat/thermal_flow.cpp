#include "kernels/heat/thermal_flow.hpp"

#include "kernels/launch/launch.hpp"

namespace vug {

template <class T>
struct GatherTemperature {
  IndexList node;
  Temperature<T> temperature;
  int first;
  ScalarField<T> theta;
  KOKKOS_FUNCTION void operator()(int i) const {
    if (i >= first) theta(i) = temperature(node(i));
  }
};

template <class T>
void gather_temperatures(const Exec& exec, const FluidNodes& nodes, const HeatFields<T>& fields, int first,
                         const ScalarField<T>& theta) {
  for_each_node(exec, "vug::thermal_flow::temperatures", nodes.near(nodes.count),
                GatherTemperature<T>{nodes.node, Temperature<T>(fields), first, theta});
}

template <class T>
struct MixWithBefore {
  T share;
  ScalarField<T> before, theta;
  KOKKOS_FUNCTION void operator()(int i) const {
    const T now = theta(i);
    theta(i) = now + share * (before(i) - now);
    before(i) = now;
  }
};

template <class T>
void mix_with_before(const Exec& exec, const FluidNodes& nodes, double share, const ScalarField<T>& before,
                     const ScalarField<T>& theta) {
  for_each_node(exec, "vug::thermal_flow::mix", nodes.near(nodes.count), MixWithBefore<T>{T(share), before, theta});
}

template <class T>
struct SetSpread {
  ScalarField<T> theta;
  ViscosityLaw law;
  ScalarField<T> spread;
  KOKKOS_FUNCTION void operator()(int i) const { spread(i) = static_cast<T>(3 * law(static_cast<double>(theta(i)))); }
};

template <class T>
void set_spread(const Exec& exec, const Share& list, const ScalarField<T>& theta, const ViscosityLaw& law,
                const ScalarField<T>& spread) {
  for_each_node(exec, "vug::thermal_flow::viscosities", list, SetSpread<T>{theta, law, spread});
}

VUG_COMPILE_FOR_NUMBERS(gather_temperatures)
VUG_COMPILE_FOR_NUMBERS(mix_with_before)
VUG_COMPILE_FOR_NUMBERS(set_spread)

}  // namespace vug
