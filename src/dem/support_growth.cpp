#include "dem/support_growth.hpp"

#include "kernels/launch/launch.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace vug {

namespace {

using Depths = std::array<double, 2>;

struct GrowAtSupports {
  SupportGrowth growth;
  double expansion;
  Particles p;
  KOKKOS_FUNCTION void operator()(int k) const {
    const int i = growth.particle(k);
    const double strain = expansion * (p.warming(i) - growth.warming(k));
    for (int axis = 0; axis < 2; ++axis) p.u(i, axis) += strain * growth.depth(k, axis);
    growth.warming(k) = p.warming(i);
  }
};

/// Places (m, along the normal) of the centroids that a side holds along its normal, by particle.
std::map<int, double> held_along_normal(const std::vector<AxesOfSides>& held, int side, const Particles& particles) {
  const auto x0 = on_host(particles.x0);
  const int normal = side % 2;
  std::map<int, double> places;
  for (int i = 0; i < particles.count; ++i)
    if ((held[i][side] & 1 << normal) != 0) places[i] = x0(i, normal);
  return places;
}

double mean(const std::map<int, double>& places) {
  double sum = 0;
  for (const auto& [particle, place] : places) sum += place;
  return sum / static_cast<double>(places.size());
}

}  // namespace

SupportGrowth find_support_growth(const Assembly& assembly, const std::vector<BoundaryEdge>& boundary,
                                  const Loads& loads, const Particles& particles, double expansion) {
  SupportGrowth growth;
  if (expansion == 0) return growth;
  const std::vector<AxesOfSides> held =
      axes_held(pieces_of_boundary(assembly, boundary, loads, particles), loads, particles.count);
  std::map<int, Depths> depths;
  for (int side = 0; side < 4; ++side) {
    const std::map<int, double> places = held_along_normal(held, side, particles);
    for (const auto& [particle, place] : places) depths[particle][side % 2] = place - mean(places);
  }
  growth.particle = IndexList("vug::dem::grown_particle", depths.size());
  growth.depth = VectorField<double>("vug::dem::grown_depth", depths.size());
  growth.warming = ScalarField<double>("vug::dem::grown_warming", depths.size());
  const HostWriter particle(growth.particle);
  const HostWriter depth(growth.depth);
  int k = 0;
  for (const auto& [i, of_axes] : depths) {
    particle(k) = i;
    for (int axis = 0; axis < 2; ++axis) depth(k, axis) = of_axes[axis];
    ++k;
  }
  return growth;
}

void grow_at_supports(const Exec& exec, const SupportGrowth& growth, double expansion, const Particles& particles) {
  const int count = static_cast<int>(growth.particle.extent(0));
  if (count == 0) return;
  for_each_node(exec, "vug::dem::grow_at_supports", count, GrowAtSupports{growth, expansion, particles});
}

}  // namespace vug
