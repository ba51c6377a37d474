#include "kernels/launch/launch.hpp"
#include "kernels/nodes/fluid_nodes.hpp"

namespace vug {

/// Finds the image of one link; reads the list only.
struct FindMirrorLink {
  DenseNeighbour around;
  bool staircase;
  BoundaryLinks links;
  IndexList node, index, mirror;
  Kokkos::View<const std::uint16_t*> solid_links, side_links;

  KOKKOS_FUNCTION void operator()(int link) const {
    mirror(link) = staircase || links.direction(link) < D2Q5::Q ? link : image_of_diagonal(link);
  }

 private:
  KOKKOS_FUNCTION bool leaves(int i, int q) const { return (side_links(i) >> q & 1U) != 0; }
  KOKKOS_FUNCTION bool is_fluid(int i, int q) const { return ((side_links(i) | solid_links(i)) >> q & 1U) == 0; }

  KOKKOS_FUNCTION int image_of_diagonal(int link) const {
    const int i = links.fluid(link), q = links.direction(link);
    const int along_x = D2Q9::c(q, 0) > 0 ? 1 : 3, along_y = D2Q9::c(q, 1) > 0 ? 2 : 4;
    const bool x_open = leaves(i, along_x) && links.find(link, i, along_x) >= 0;
    const bool y_open = leaves(i, along_y) && links.find(link, i, along_y) >= 0;
    if (x_open && y_open) return link;
    const int turned = 13 - q;  // its component along y reversed
    if (x_open && is_fluid(i, along_y)) return links.find(link, beside(i, along_y), turned);
    if (y_open && is_fluid(i, along_x)) return links.find(link, beside(i, along_x), D2Q9::opposite(turned));
    return is_fluid(i, along_x) && is_fluid(i, along_y) ? link : -1;
  }
  KOKKOS_FUNCTION int beside(int i, int q) const { return index(around.along(node(i), q)); }
};

/// Counts the steps of a surface: nodes with two straight links through it, at right angles and next to each other in
/// the list of their node.
struct CountSteps {
  IndexList fluid;
  Kokkos::View<const std::uint8_t*> direction;
  int count;
  KOKKOS_FUNCTION void operator()(int link, int& steps) const {
    if (direction(link) >= D2Q5::Q) return;
    for (int other = 0; other < count; ++other)
      if (fluid(other) == fluid(link) && direction(other) < D2Q5::Q && (direction(other) + direction(link)) % 2 == 1) {
        ++steps;
        return;
      }
  }
};

IndexList find_mirror_links(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links) {
  constexpr int corners_of_rectangle = 4, links_of_corner = 2;
  int steps = 0;
  Kokkos::parallel_reduce("vug::mirror_links::steps", Kokkos::RangePolicy<Exec>(exec, 0, links.count),
                          CountSteps{links.fluid, links.direction, links.count}, steps);
  const bool staircase = steps > corners_of_rectangle * links_of_corner;
  const IndexList mirror("vug::mirror_links::mirror", links.count);
  for_each_node(exec, "vug::mirror_links::find", links.count,
                FindMirrorLink{nodes.around(), staircase, links, nodes.node, nodes.index, mirror, nodes.solid_links,
                               nodes.side_links});
  return mirror;
}

}  // namespace vug
