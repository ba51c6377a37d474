#include "coupling/rock_fields.hpp"

#include <span>
#include <string>
#include <utility>

namespace vug {

namespace {

template <class ViewType>
auto host_copy(const ViewType& view) {
  return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, view);
}

}  // namespace

void add_rock_fields(const Mechanics& rock, FieldList& list) {
  const Particles& particles = rock.particles();
  const Bonds& bonds = rock.bonds();
  const auto scalar = [](std::vector<Field>& group, std::string name, std::string unit, auto view) {
    group.push_back({std::move(name), std::move(unit), 1, [view](std::span<double> out) {
                       const auto host = host_copy(view);
                       for (std::size_t i = 0; i < out.size(); ++i) out[i] = static_cast<double>(host(i));
                     }});
  };
  const auto vector = [](std::vector<Field>& group, std::string name, std::string unit, auto view) {
    group.push_back({std::move(name), std::move(unit), 2, [view](std::span<double> out) {
                       const auto host = host_copy(view);
                       for (std::size_t i = 0; i < out.size(); ++i) out[i] = host(i / 2, i % 2);
                     }});
  };
  vector(list.particles, "displacement", "m", particles.u);
  scalar(list.particles, "rotation", "rad", particles.angle);
  scalar(list.particles, "temperature_change", "K", particles.temperature_change);
  scalar(list.particles, "solid_fraction", "1", particles.solid_fraction);
  vector(list.particles, "force", "N/m", particles.force);
  scalar(list.bonds, "d_m", "1", bonds.d_m);
  scalar(list.bonds, "d_c", "1", bonds.d_c);
  scalar(list.bonds, "state", "1", bonds.state);
  vector(list.bonds, "stress", "Pa", bonds.stress);
}

RockShape shape_of_rock(const Assembly& assembly, const Bonds& bonds) {
  RockShape shape{assembly, {}};
  const auto pair = host_copy(bonds.pair);
  const auto vertex = host_copy(bonds.vertex);
  for (int b = 0; b < bonds.count; ++b) shape.bonds.push_back({{pair(b, 0), pair(b, 1)}, {vertex(b, 0), vertex(b, 1)}});
  return shape;
}

}  // namespace vug
