#include "coupling/particle_load.hpp"

#include "kernels/launch.hpp"
#include "kernels/offsets.hpp"

namespace vug {

struct MarkPlaces {
  IndexList surface, place;
  KOKKOS_FUNCTION void operator()(int s) const { place(surface(s)) = s; }
};

/// Counts (filled = false) or lists the surface nodes among the nodes of each particle, in node order.
struct ListWetNodes {
  Groups nodes;
  IndexList place;
  Groups wet;
  bool fill;
  KOKKOS_FUNCTION void operator()(int p) const {
    int at = fill ? wet.offset(p) : 0;
    for (int k = nodes.offset(p); k < nodes.offset(p + 1); ++k) {
      if (place(nodes.item(k)) < 0) continue;
      if (fill) wet.item(at) = nodes.item(k);
      ++at;
    }
    if (!fill) wet.offset(p + 1) = at;
  }
};

ParticleLoad::ParticleLoad(const Lattice& lattice, double spacing, const Groups& nodes_of_particle,
                           const VectorField<double>& centroid)
    : spacing_(spacing),
      nodes_of_particle_(nodes_of_particle),
      centroid_(centroid),
      place_("vug::particle_load::place", lattice.size()),
      wet_{IndexList("vug::particle_load::offset", nodes_of_particle.offset.extent(0)),
           IndexList("vug::particle_load::item", 0)} {}

void ParticleLoad::rebuild(const Exec& exec, const FluidNodes& fluid, const Surface& surface) {
  const int particles = nodes_of_particle_.count();
  Kokkos::deep_copy(exec, place_, -1);
  for_each_node(exec, "vug::particle_load::mark", surface.count, MarkPlaces{surface.node, place_});
  if (static_cast<int>(wet_.item.extent(0)) < surface.count)
    wet_.item = IndexList("vug::particle_load::item", surface.count + surface.count / 2);
  for_each_node(exec, "vug::particle_load::count", particles, ListWetNodes{nodes_of_particle_, place_, wet_, false});
  accumulate_counts(exec, "vug::particle_load::offsets", wet_.offset);
  for_each_node(exec, "vug::particle_load::list", particles, ListWetNodes{nodes_of_particle_, place_, wet_, true});
  find_wall_links(exec, fluid, wet_.offset, wet_.item, centroid_, spacing_, links_);
}

}  // namespace vug
