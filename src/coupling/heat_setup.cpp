// The heat of a case in the units of its steps: minerals, parameters, conditions at sides and openings.
#include "coupling/heat_module.hpp"

#include <algorithm>
#include <cmath>

namespace vug {

template <class T>
void HeatModule<T>::set_up_minerals(const Scene& scene) {
  const Mineral rock{"rock", section_.solid_diffusivity, section_.solid_density, section_.solid_heat_capacity};
  minerals_.push_back(rock);
  bool differ = false;
  for (const MineralSection& mineral : scene.minerals) {
    minerals_.push_back({mineral.name, mineral.diffusivity, mineral.density, mineral.heat_capacity});
    const double held = mineral.density * mineral.heat_capacity, of_rock = rock.density * rock.heat_capacity;
    const auto other = [](double a, double b) { return std::abs(a - b) > 1e-12 * b; };  // rounding of the reader
    differ = differ || other(held, of_rock) || other(mineral.diffusivity * held, rock.diffusivity * of_rock);
  }
  if (!differ) minerals_.clear();
  if (!differ || !scene.reaction) return;
  solid_share_ = ScalarField<double>("vug::minerals::solid_share", minerals_.size());
  const HostWriter share(solid_share_);
  for (std::size_t m = 0; m < minerals_.size(); ++m)
    share(m) = solid_share(minerals_[m].density, minerals_[m].heat_capacity, minerals_[m].diffusivity);
}

template <class T>
double HeatModule<T>::solid_share(double density, double heat_capacity, double diffusivity) const {
  const double fluid = section_.fluid_density * section_.fluid_heat_capacity * section_.fluid_diffusivity;
  const double solid = density * heat_capacity * diffusivity;
  return solid / (fluid + solid);
}

template <class T>
HeatParameters HeatModule<T>::parameters() const {
  const double scale = interval_ / units_.diffusivity();
  const auto sigma = [&](double density, double capacity) {
    return density * capacity / (section_.fluid_density * section_.fluid_heat_capacity);
  };
  HeatParameters given{scale * section_.fluid_diffusivity,
                       scale * section_.solid_diffusivity,
                       sigma(section_.solid_density, section_.solid_heat_capacity),
                       section_.velocity_set,
                       {}};
  for (const Mineral& mineral : minerals_)
    given.minerals.push_back({scale * mineral.diffusivity, sigma(mineral.density, mineral.heat_capacity)});
  return given;
}

template <class T>
double HeatModule<T>::value_of(const HeatBoundary& heat, double time) const {
  if (heat.kind == HeatCondition::temperature || heat.kind == HeatCondition::convection)
    return units_.lattice_temperature(heat.temperature.at(time));
  if (heat.kind != HeatCondition::flux) return 0;
  return interval_ * heat.flux.at(time) / (section_.fluid_density * section_.fluid_heat_capacity * units_.velocity());
}

template <class T>
double HeatModule<T>::value_of(const HeatBoundary& heat, const StepTimes& times) const {
  if (heat.temperature.constant() && heat.flux.constant()) return value_of(heat, times.last);
  const auto at = [&](double moment) { return value_of(heat, moment); };
  return heat.kind == HeatCondition::flux ? times.mean(at) : times.mean_about_last(at);
}

template <class T>
double HeatModule<T>::transfer_of(const HeatBoundary& heat) const {
  return interval_ * heat.coefficient / (section_.fluid_density * section_.fluid_heat_capacity * units_.velocity());
}

template <class T>
void HeatModule<T>::set_values(double time) {
  const StepTimes times{time, units_.time_step, interval_};
  const auto set = [&](auto& surface, const HeatBoundary& heat) { surface.value = value_of(heat, times); };
  for (std::size_t s = 0; s < sides_.size(); ++s) set(sides_[s], stretches_[s].conditions.heat);
  for (std::size_t o = 0; o < openings_.size(); ++o) set(openings_[o], geometry_.openings[o].conditions.heat);
}

#define VUG_INSTANTIATE(T)                                                              \
  template void HeatModule<T>::set_up_minerals(const Scene&);                           \
  template double HeatModule<T>::solid_share(double, double, double) const;             \
  template HeatParameters HeatModule<T>::parameters() const;                            \
  template double HeatModule<T>::value_of(const HeatBoundary&, double) const;           \
  template double HeatModule<T>::value_of(const HeatBoundary&, const StepTimes&) const; \
  template double HeatModule<T>::transfer_of(const HeatBoundary&) const;                \
  template void HeatModule<T>::set_values(double);
VUG_FOR_NUMBERS(VUG_INSTANTIATE)
#undef VUG_INSTANTIATE

}  // namespace vug
