#include "coupling/solid_spread.hpp"

namespace vug {

namespace {

/// How far solid is moved at most, in triangles.
constexpr int most_rounds = 16;

}  // namespace

/// Whether a node belongs to the solid that is moved together: all solid, or one mineral.
struct AllSolid {
  KOKKOS_FORCEINLINE_FUNCTION bool holds(int) const { return true; }
};
struct OneMineral {
  Kokkos::View<const std::uint8_t*> mineral;
  int wanted;
  KOKKOS_FORCEINLINE_FUNCTION bool holds(int n) const { return mineral(n) == wanted; }
};

/// For each triangle: adds the volume of its opening nodes to what waits.
template <class Part>
struct TakeFreed {
  Part part;
  NodeGroups nodes;
  Kokkos::View<std::uint8_t*> opening;
  ScalarField<double> volume, waiting;
  KOKKOS_FUNCTION void operator()(int t) const {
    double freed = 0;
    nodes.for_each(t, [&](int n) {
      if (!opening(n) || !part.holds(n)) return;
      freed += volume(n);
      volume(n) = 0;
      opening(n) = 0;
    });
    waiting(t) += freed;
  }
};

/// For each triangle: its solid nodes take what waits, as far as they have room. Counts the triangles where some is
/// left.
template <class Part>
struct TakeUp {
  Part taken;
  NodeGroups nodes;
  Kokkos::View<const NodeType*> type;
  Kokkos::View<const double*> dissolved;
  ScalarField<double> volume, waiting;
  KOKKOS_FUNCTION void operator()(int t, int& left) const {
    if (waiting(t) == 0) return;
    double room = 0;
    nodes.for_each(t, [&](int n) {
      if (type(n) == NodeType::solid && taken.holds(n)) room += room_for_solid(volume(n), dissolved(n));
    });
    const bool fits = waiting(t) <= room;
    left += !fits;
    if (room == 0) return;
    const double part = fits ? waiting(t) / room : 1.0;
    nodes.for_each(t, [&](int n) {
      if (type(n) == NodeType::solid && taken.holds(n)) volume(n) += part * room_for_solid(volume(n), dissolved(n));
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

SolidSpread::SolidSpread(NodeGroups nodes_of_triangle, TriangleNeighbours neighbours, MineralNodes minerals)
    : nodes_(std::move(nodes_of_triangle)),
      neighbours_(std::move(neighbours)),
      mineral_(std::move(minerals.of_node)),
      arriving_("vug::solid_spread::arriving", nodes_.count()) {
  const int parts = mineral_.extent(0) > 0 ? minerals.count : 1;
  for (int m = 0; m < parts; ++m) waiting_.emplace_back("vug::solid_spread::waiting", nodes_.count());
}

template <class Part>
void SolidSpread::spread(const Exec& exec, const Part& part, const Kokkos::View<NodeType*>& type,
                         const Kokkos::View<std::uint8_t*>& opening, const ScalarField<double>& volume,
                         const ScalarField<double>& dissolved, const ScalarField<double>& waiting) {
  const Kokkos::RangePolicy<Exec> triangles(exec, 0, nodes_.count());
  Kokkos::parallel_for("vug::solid_spread::take_freed", triangles,
                       TakeFreed<Part>{part, nodes_, opening, volume, waiting});
  for (int round = 0;; ++round) {
    int left = 0;
    Kokkos::parallel_reduce("vug::solid_spread::take_up", triangles,
                            TakeUp<Part>{part, nodes_, type, dissolved, volume, waiting}, left);
    if (left == 0 || round == most_rounds) return;
    Kokkos::parallel_for("vug::solid_spread::pass_on", triangles, PassOn{neighbours_, waiting, arriving_});
    Kokkos::deep_copy(exec, waiting, arriving_);
  }
}

void SolidSpread::operator()(const Exec& exec, const Kokkos::View<NodeType*>& type,
                             const Kokkos::View<std::uint8_t*>& opening, const ScalarField<double>& volume,
                             const ScalarField<double>& dissolved) {
  if (mineral_.extent(0) == 0) return among_all(exec, type, opening, volume, dissolved);
  for (std::size_t m = 0; m < waiting_.size(); ++m)
    spread(exec, OneMineral{mineral_, static_cast<int>(m)}, type, opening, volume, dissolved, waiting_[m]);
}

void SolidSpread::among_all(const Exec& exec, const Kokkos::View<NodeType*>& type,
                            const Kokkos::View<std::uint8_t*>& opening, const ScalarField<double>& volume,
                            const ScalarField<double>& dissolved) {
  spread(exec, AllSolid{}, type, opening, volume, dissolved, waiting_[0]);
}

}  // namespace vug
