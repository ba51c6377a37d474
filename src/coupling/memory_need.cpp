#include "coupling/memory_need.hpp"

#include "io/triangle_count.hpp"
#include "kernels/nodes/fluid_nodes.hpp"

namespace vug {

namespace {

constexpr double bytes_per_triangle = 500;  // of the triangle, its bonds and the search for its neighbours, at least

double number_of(const Scene& scene) {
  return scene.accuracy.precision == Precision::single_precision ? sizeof(float) : sizeof(double);
}

double directions(ScalarVelocitySet set) {
  return set == ScalarVelocitySet::d2q9 ? 9 : 5;
}

}  // namespace

double bytes_of_lattice(const Scene& scene) {
  const double nodes = static_cast<double>(scene.lattice.nx) * scene.lattice.ny, number = number_of(scene);
  double per_node = sizeof(NodeType);
  if (scene.flow || scene.solute) per_node += sizeof(int);    // fluid index
  if (rock_dissolves(scene)) per_node += 2 * sizeof(double);  // volume, dissolved
  if (!scene.minerals.empty()) per_node += 1;                 // number
  if (!scene.minerals.empty() && scene.reaction)              // what each reactant has taken
    per_node += sizeof(double) * (1 + static_cast<double>(scene.reaction->further.size()));
  const double watched = scene.accuracy.chooses_intervals() ? 1 : 0;  // of each scalar, at the last look
  if (scene.heat) per_node += number * (directions(scene.heat->velocity_set) + watched);  // populations
  const double area = scene.lattice.length_x * scene.lattice.length_y;
  return per_node * nodes + (scene.rock ? bytes_of_triangles(*scene.rock, area) : 0);
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

}  // namespace vug
