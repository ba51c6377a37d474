// The straight pieces of an outflow, along each of which its pressure varies.
#include "kernels/flow/open_boundary.hpp"
#include "kernels/flow/outflow.hpp"

#include <algorithm>
#include <vector>

namespace vug {

/// Finds for each straight link (face) of an outflow the faces beside it, for each diagonal link the face of its node
/// unless that has two, and counts the faces. Where joined sides close the row, the last face has no next one.
struct FindPieces {
  BoundaryLinks links;
  Upstream upstream;
  IndexList next, previous, face;

  KOKKOS_FUNCTION void operator()(int link, int& faces) const {
    const int q = links.direction(link), i = links.fluid(link);
    next(link) = previous(link) = face(link) = -1;
    if (q < D2Q5::Q) {
      const int above = beside(link, upwards(q)), below = beside(link, D2Q9::opposite(upwards(q)));
      if (above > link) next(link) = above;
      if (below < link) previous(link) = below;
      face(link) = link;
      ++faces;
      return;
    }
    const int along_x = D2Q9::c(q, 0) > 0 ? 1 : 3, along_y = D2Q9::c(q, 1) > 0 ? 2 : 4;
    const int of_x = links.find(link, i, along_x), of_y = links.find(link, i, along_y);
    if (of_x < 0 || of_y < 0) face(link) = of_x < 0 ? of_y : of_x;  // with both no axis comes first
  }

 private:
  KOKKOS_FORCEINLINE_FUNCTION int beside(int link, int towards) const {
    const int neighbour = upstream(D2Q9::opposite(towards), links.fluid(link));
    return neighbour < 0 ? -1 : links.find(link, neighbour, links.direction(link));
  }
};

namespace {

/// Lists the pieces of an outflow, from the faces beside each face.
void list_pieces(const IndexList& next_face, const IndexList& previous_face, OutflowState& state) {
  const auto next = on_host(next_face), previous = on_host(previous_face), face = on_host(state.face);
  std::vector<int> order, piece{0};
  state.longest = 0;
  for (int link = 0; link < static_cast<int>(face.extent(0)); ++link) {
    if (face(link) != link || previous(link) >= 0) continue;
    for (int f = link; f >= 0; f = next(f)) order.push_back(f);
    piece.push_back(static_cast<int>(order.size()));
    state.longest = std::max(state.longest, piece.back() - piece[piece.size() - 2]);
  }
  state.pieces = static_cast<int>(piece.size()) - 1;
  state.order = to_device<IndexList>("vug::open_boundary::order", order);
  state.piece = to_device<IndexList>("vug::open_boundary::piece", piece);
}

}  // namespace

void fit_to_links(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links, OutflowState& state) {
  state.speed = ScalarField<double>("vug::open_boundary::speed", block_count(links.count));
  Kokkos::resize(exec, state.level, 2);
  state.along = ScalarField<double>("vug::open_boundary::along", links.count);
  state.room = ScalarField<double>("vug::open_boundary::room", 3 * links.count);
  IndexList next, previous;
  for (IndexList* list : {&next, &previous, &state.face}) *list = IndexList("vug::open_boundary::pieces", links.count);
  int faces = 0;
  Kokkos::parallel_reduce("vug::open_boundary::faces", Kokkos::RangePolicy<Exec>(exec, 0, links.count),
                          FindPieces{links, Upstream(nodes), next, previous, state.face}, faces);
  state.faces = faces;
  list_pieces(next, previous, state);
}

}  // namespace vug
