#include "coupling/memory_need.hpp"

#include "host/device_memory.hpp"
#include "io/triangle_count.hpp"
#include "kernels/heat/heat_bands.hpp"
#include "kernels/nodes/fluid_nodes.hpp"

#include <fmt/format.h>

namespace vug {

namespace {

constexpr double bytes_per_triangle = 500;  // at least: the triangle, its bonds and the search for its neighbours

double number_of(const Scene& scene) {
  return scene.accuracy.precision == Precision::single_precision ? sizeof(float) : sizeof(double);
}

double directions(ScalarVelocitySet set) {
  return set == ScalarVelocitySet::d2q9 ? 9 : 5;
}

/// Throws MemoryError unless there are `fields` bytes for kernels and `of_host` bytes for data that only the host uses.
void require_room_for(double fields, double of_host, const std::string& what) {
  if constexpr (shares_host_memory) {
    require_memory(fields + of_host, what);
  } else {
    require_memory(of_host, what);
    require_room<Exec::memory_space>(fields, what);
  }
}

}  // namespace

double bytes_of_lattice(const Scene& scene) {
  const double nodes = static_cast<double>(scene.lattice.nx) * scene.lattice.ny, number = number_of(scene);
  double per_node = sizeof(NodeType);
  if (scene.flow || scene.solute) per_node += sizeof(int);  // fluid index
  if (scene.reaction) per_node += 2 * sizeof(double);       // volume, dissolved
  if (!scene.minerals.empty()) per_node += 1;               // number
  if (!scene.minerals.empty() && scene.reaction)            // what each reactant has taken
    per_node += sizeof(double) * (1 + static_cast<double>(scene.reaction->further.size()));
  const double watched = scene.accuracy.chooses_intervals() ? 1 : 0;  // of each scalar, at the last look
  if (scene.heat) per_node += number * (directions(scene.heat->velocity_set) * heat_lattices + watched);  // populations
  return per_node * nodes;
}

double bytes_of_triangles(const RockSection& rock, double area) {
  return rock.mesh ? 0 : bytes_per_triangle * triangles_in(area, rock.element_size);
}

double bytes_of_fluid(const Scene& scene, double count) {
  const double number = number_of(scene);
  double per_node = 0;
  if (scene.flow || scene.solute) per_node += 4 + 9 * 4 + 3 * 2;  // node, sources, masks of links
  if (scene.flow) per_node += number * (9 + 2);                   // populations, velocity
  if (scene.solute)
    per_node += number * static_cast<double>(scene.solute->species.size()) *
                (directions(scene.solute->velocity_set) + 1 +  // populations, concentration
                 (scene.accuracy.chooses_intervals() ? 1 : 0));
  return per_node * count;
}

void require_memory_of_lattice(const Scene& scene) {
  const LatticeSection& lattice = scene.lattice;
  const double triangles = scene.rock ? bytes_of_triangles(*scene.rock, lattice.length_x * lattice.length_y) : 0;
  require_room_for(bytes_of_lattice(scene), triangles,
                   fmt::format("{}: a lattice of {} x {} nodes", scene.path, lattice.nx, lattice.ny));
}

void require_memory_of_fluid(const Scene& scene, std::int64_t count) {
  require_room_for(bytes_of_fluid(scene, static_cast<double>(count)), 0,
                   fmt::format("{}: the fluid in {} nodes", scene.path, count));
}

}  // namespace vug
