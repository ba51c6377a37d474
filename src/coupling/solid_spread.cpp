#include "coupling/solid_spread.hpp"

namespace vug {

namespace {

/// How far, in triangles, solid is handed on at once.
constexpr int most_rounds = 16;

}  // namespace

/// Per triangle: the volume of its opening nodes joins what waits.
struct TakeFreed {
  NodeGroups nodes;
  Kokkos::View<std::uint8_t*> opening;
  ScalarField<double> volume, waiting;
  KOKKOS_FUNCTION void operator()(int t) const {
    double freed = 0;
    nodes.for_each(t, [&](int n) {
      if (!opening(n)) return;
      freed += volume(n);
      volume(n) = 0;
      opening(n) = 0;
    });
    waiting(t) += freed;
  }
};

/// Per triangle: its solid nodes take what waits, as far as they have room. Counts the triangles where some is left.
struct TakeUp {
  NodeGroups nodes;
  Kokkos::View<const NodeType*> type;
  Kokkos::View<const double*> dissolved;
  ScalarField<double> volume, waiting;
  KOKKOS_FUNCTION void operator()(int t, int& left) const {
    if (waiting(t) == 0) return;
    double room = 0;
    nodes.for_each(t, [&](int n) {
      if (type(n) == NodeType::solid) room += room_for_solid(volume(n), dissolved(n));
    });
    const bool fits = waiting(t) <= room;
    left += !fits;
    if (room == 0) return;
    const double part = fits ? waiting(t) / room : 1.0;
    nodes.for_each(t, [&](int n) {
      if (type(n) == NodeType::solid) volume(n) += part * room_for_solid(volume(n), dissolved(n));
    });
    waiting(t) = fits ? 0 : waiting(t) - room;
  }
};

/// arriving(t) = what the triangles around t pass on to it; a triangle without neighbours keeps its own.
struct PassOn {
  TriangleNeighbours neighbours;
  Kokkos::View<const double*> waiting;
  ScalarField<double> arriving;
  KOKKOS_FORCEINLINE_FUNCTION int count(int t) const {
    return (neighbours(t, 0) >= 0) + (neighbours(t, 1) >= 0) + (neighbours(t, 2) >= 0);
  }
  KOKKOS_FUNCTION void operator()(int t) const {
    double sum = count(t) == 0 ? waiting(t) : 0.0;
    for (int k = 0; k < 3; ++k)
      if (const int other = neighbours(t, k); other >= 0) sum += waiting(other) / count(other);
    arriving(t) = sum;
  }
};

SolidSpread::SolidSpread(NodeGroups nodes_of_triangle, TriangleNeighbours neighbours)
    : nodes_(std::move(nodes_of_triangle)),
      neighbours_(std::move(neighbours)),
      waiting_("vug::solid_spread::waiting", nodes_.count()),
      arriving_("vug::solid_spread::arriving", nodes_.count()) {}

void SolidSpread::operator()(const Exec& exec, const Kokkos::View<NodeType*>& type,
                             const Kokkos::View<std::uint8_t*>& opening, const ScalarField<double>& volume,
                             const ScalarField<double>& dissolved) {
  const Kokkos::RangePolicy<Exec> triangles(exec, 0, nodes_.count());
  Kokkos::parallel_for("vug::solid_spread::take_freed", triangles, TakeFreed{nodes_, opening, volume, waiting_});
  for (int round = 0;; ++round) {
    int left = 0;
    Kokkos::parallel_reduce("vug::solid_spread::take_up", triangles, TakeUp{nodes_, type, dissolved, volume, waiting_},
                            left);
    if (left == 0 || round == most_rounds) return;
    Kokkos::parallel_for("vug::solid_spread::pass_on", triangles, PassOn{neighbours_, waiting_, arriving_});
    Kokkos::deep_copy(exec, waiting_, arriving_);
  }
}

}  // namespace vug
