#include "coupling/rock_fields.hpp"

#include "dem/mean_stress.hpp"
#include "kernels/base/host_and_device.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <utility>

namespace vug {

void add_rock_fields(const Mechanics& rock, FieldList& list, const std::vector<std::string>& asked_for) {
  const Particles& particles = rock.particles();
  const Bonds& bonds = rock.bonds();
  const auto scalar = [](std::vector<Field>& group, std::string name, std::string unit, auto view) {
    group.push_back({std::move(name), std::move(unit), 1, [view](std::span<double> out) {
                       const auto host = on_host(view);
                       for (std::size_t i = 0; i < out.size(); ++i) out[i] = static_cast<double>(host(i));
                     }});
  };
  const auto vector = [](std::vector<Field>& group, std::string name, std::string unit, auto view) {
    group.push_back({std::move(name), std::move(unit), 2, [view](std::span<double> out) {
                       const auto host = on_host(view);
                       for (std::size_t i = 0; i < out.size(); ++i) out[i] = host(i / 2, i % 2);
                     }});
  };
  list.particles.push_back({"displacement", "m", 2, [particles](std::span<double> out) {
                              const auto u = on_host(particles.u), reference = on_host(particles.u_reference);
                              for (std::size_t i = 0; i < out.size(); ++i)
                                out[i] = u(i / 2, i % 2) - reference(i / 2, i % 2);
                            }});
  list.particles.push_back({"rotation", "rad", 1, [particles](std::span<double> out) {
                              const auto angle = on_host(particles.angle);
                              const auto reference = on_host(particles.angle_reference);
                              for (std::size_t i = 0; i < out.size(); ++i) out[i] = angle(i) - reference(i);
                            }});
  scalar(list.particles, "temperature_change", "K", particles.temperature_change);
  scalar(list.particles, "solid_fraction", "1", particles.solid_fraction);
  list.particles.push_back({"gone", "1", 1, [particles](std::span<double> out) {
                              const auto fraction = on_host(particles.solid_fraction);
                              for (std::size_t i = 0; i < out.size(); ++i) out[i] = is_gone(fraction(i)) ? 1 : 0;
                            }});
  vector(list.particles, "force", "N/m", particles.force);
  constexpr std::array stress_components{"stress_xx", "stress_yy", "stress_xy"};
  for (int c = 0; c < 3; ++c) {
    const std::string name = stress_components[static_cast<std::size_t>(c)];
    if (std::find(asked_for.begin(), asked_for.end(), name) == asked_for.end()) continue;
    list.particles.push_back({name, "Pa", 1, [particles, bonds, c](std::span<double> out) {
                                const auto stress = on_host(stress_of_triangles(Exec(), particles, bonds));
                                for (std::size_t i = 0; i < out.size(); ++i) out[i] = stress(i, c);
                              }});
  }
  scalar(list.bonds, "d_m", "1", bonds.d_m);
  scalar(list.bonds, "d_c", "1", bonds.d_c);
  scalar(list.bonds, "state", "1", bonds.state);
  vector(list.bonds, "stress", "Pa", bonds.stress);
}

RockShape shape_of_rock(const Assembly& assembly, const Bonds& bonds) {
  RockShape shape{assembly, {}};
  const auto pair = on_host(bonds.pair);
  const auto vertex = on_host(bonds.vertex);
  for (int b = 0; b < bonds.count; ++b) shape.bonds.push_back({{pair(b, 0), pair(b, 1)}, {vertex(b, 0), vertex(b, 1)}});
  return shape;
}

}  // namespace vug
