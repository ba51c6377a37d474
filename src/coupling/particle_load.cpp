#include "coupling/particle_load.hpp"

#include "coupling/group_sum.hpp"
#include "kernels/launch.hpp"

namespace vug {

/// A force and its torque.
struct Wrench {
  double x = 0, y = 0, torque = 0;
  KOKKOS_FUNCTION Wrench& operator+=(const Wrench& other) {
    x += other.x;
    y += other.y;
    torque += other.torque;
    return *this;
  }
};

}  // namespace vug

template <>
struct Kokkos::reduction_identity<vug::Wrench> {
  KOKKOS_FORCEINLINE_FUNCTION static vug::Wrench sum() { return {}; }
};

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
      const int s = place(nodes.item(k));
      if (s < 0) continue;
      if (fill) wet.item(at) = s;
      ++at;
    }
    if (!fill) wet.offset(p + 1) = at;
  }
};

struct Accumulate {
  IndexList offset;
  KOKKOS_FUNCTION void operator()(int p, int& sum, bool last) const {
    sum += offset(p);
    if (last) offset(p) = sum;
  }
};

WetSurface::WetSurface(const Lattice& lattice, const Groups& nodes_of_particle)
    : nodes_of_particle_(nodes_of_particle),
      place_("vug::particle_load::place", lattice.size()),
      groups_{IndexList("vug::particle_load::offset", nodes_of_particle.offset.extent(0)),
              IndexList("vug::particle_load::item", 0)} {}

void WetSurface::rebuild(const Exec& exec, const Surface& surface) {
  const int particles = nodes_of_particle_.count();
  Kokkos::deep_copy(exec, place_, -1);
  for_each_node(exec, "vug::particle_load::mark", surface.count, MarkPlaces{surface.node, place_});
  if (static_cast<int>(groups_.item.extent(0)) < surface.count)
    groups_.item = IndexList("vug::particle_load::item", surface.count + surface.count / 2);
  for_each_node(exec, "vug::particle_load::count", particles, ListWetNodes{nodes_of_particle_, place_, groups_, false});
  Kokkos::parallel_scan("vug::particle_load::offsets", Kokkos::RangePolicy<Exec>(exec, 0, particles + 1),
                        Accumulate{groups_.offset});
  for_each_node(exec, "vug::particle_load::list", particles, ListWetNodes{nodes_of_particle_, place_, groups_, true});
}

/// Force of one surface node, with its torque about the centroid of its particle.
struct NodeWrench {
  Lattice lattice;
  double spacing, scale;
  IndexList node;
  VectorField<double> force, centroid;
  KOKKOS_FUNCTION Wrench operator()(int s, int particle) const {
    const double fx = scale * force(s, 0), fy = scale * force(s, 1);
    const double rx = (lattice.x(node(s)) + 0.5) * spacing - centroid(particle, 0);
    const double ry = (lattice.y(node(s)) + 0.5) * spacing - centroid(particle, 1);
    return {fx, fy, rx * fy - ry * fx};
  }
};

struct StoreWrench {
  VectorField<double> force;
  ScalarField<double> torque;
  KOKKOS_FUNCTION void operator()(int particle, const Wrench& w) const {
    force(particle, 0) = w.x;
    force(particle, 1) = w.y;
    torque(particle) = w.torque;
  }
};

void load_particles(const Exec& exec, const Lattice& lattice, double spacing, double scale, const Surface& surface,
                    const WetSurface& wet, const VectorField<double>& node_force, const VectorField<double>& centroid,
                    const VectorField<double>& force, const ScalarField<double>& torque) {
  sum_groups<Wrench>(exec, "vug::particle_load::gather", wet.of_particle(),
                     NodeWrench{lattice, spacing, scale, surface.node, node_force, centroid},
                     StoreWrench{force, torque});
}

}  // namespace vug
