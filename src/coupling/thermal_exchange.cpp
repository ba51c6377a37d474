#include "coupling/thermal_exchange.hpp"

#include "coupling/cells.hpp"
#include "coupling/geometry.hpp"
#include "coupling/run_sum.hpp"

#include <algorithm>

namespace vug {

namespace {

/// The node (row by row without halo) that contains the centroid of each triangle.
std::vector<int> nodes_of_centroids(const Assembly& assembly, const Lattice& lattice, double spacing) {
  std::vector<int> nodes;
  for (const auto& triangle : assembly.triangles) {
    double centroid[2] = {0, 0};
    for (const int vertex : triangle)
      for (int axis = 0; axis < 2; ++axis) centroid[axis] += assembly.vertices[vertex][axis] / 3 / spacing;
    const int x = std::clamp(cell_of(centroid[0]), 0, lattice.nx - 1);
    nodes.push_back(std::clamp(cell_of(centroid[1]), 0, lattice.ny - 1) * lattice.nx + x);
  }
  return nodes;
}

/// For each node the nearest node outside all openings, by steps along rows and columns; -1 without such a node.
std::vector<int> nearest_outside(const std::vector<int>& opening, const Lattice& lattice) {
  std::vector<int> nearest(opening.size(), -1), reached;
  for (int n = 0; n < static_cast<int>(opening.size()); ++n)
    if (opening[n] < 0) reached.push_back(nearest[n] = n);
  for (std::size_t next = 0; next < reached.size(); ++next) {
    const int n = reached[next], x = n % lattice.nx, y = n / lattice.nx;
    for (int q = 1; q < D2Q5::Q; ++q) {
      if (!lattice.inside(x + D2Q5::c(q, 0), y + D2Q5::c(q, 1))) continue;
      const int beside = n + D2Q5::c(q, 1) * lattice.nx + D2Q5::c(q, 0);
      if (nearest[beside] >= 0) continue;
      nearest[beside] = nearest[n];
      reached.push_back(beside);
    }
  }
  return nearest;
}

}  // namespace

ThermalNodes thermal_nodes(const Scene& scene, const Rock& rock, const Lattice& lattice) {
  const NodeGroups& own = rock.nodes_of_particle;
  const auto offset = on_host(own.offset), first = on_host(own.first), length = on_host(own.length),
             nodes = on_host(own.nodes);
  ThermalNodes found{own, {}};
  const int particles = own.count();
  if (std::all_of(nodes.data(), nodes.data() + particles, [](int count) { return count > 0; })) return found;
  const std::vector<int> centroid = nodes_of_centroids(rock.assembly, lattice, scene.lattice.spacing);
  const std::vector<int> opening = opening_of_nodes(scene);
  const std::vector<int> nearest = nearest_outside(opening, lattice);
  std::vector<std::vector<int>> beneath(scene.openings.size());
  std::vector<int> new_offset{0}, new_first, new_length, new_nodes;
  for (int p = 0; p < particles; ++p) {
    for (int r = offset(p); r < offset(p + 1); ++r) {
      new_first.push_back(first(r));
      new_length.push_back(length(r));
    }
    new_nodes.push_back(nodes(p));
    if (nodes(p) == 0) {
      const int inside = opening.empty() ? -1 : opening[centroid[p]];
      if (inside >= 0) beneath[inside].push_back(p);
      const int node = opening.empty() ? centroid[p] : nearest[centroid[p]];
      if (node >= 0) {
        new_first.push_back(lattice.node(node % lattice.nx, node / lattice.nx));
        new_length.push_back(1);
        new_nodes.back() = 1;
      }
    }
    new_offset.push_back(static_cast<int>(new_first.size()));
  }
  found.of_particle = {to_device<IndexList>("vug::thermal_exchange::offset", new_offset),
                       to_device<IndexList>("vug::thermal_exchange::first", new_first),
                       to_device<IndexList>("vug::thermal_exchange::length", new_length),
                       to_device<IndexList>("vug::thermal_exchange::nodes", new_nodes)};
  for (const std::vector<int>& list : beneath)
    found.in_opening.push_back(to_device<IndexList>("vug::thermal_exchange::in_opening", list));
  return found;
}

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

struct StoreValue {
  IndexList particle;
  double value;
  ScalarField<double> change;
  KOKKOS_FUNCTION void operator()(int item) const { change(particle(item)) = value; }
};

void warm_particles_to(const Exec& exec, const IndexList& particles, double value, const ScalarField<double>& change) {
  for_each_node(exec, "vug::thermal_exchange::set", static_cast<int>(particles.extent(0)),
                StoreValue{particles, value, change});
}

VUG_COMPILE_FOR_NUMBERS(warm_particles)

}  // namespace vug
