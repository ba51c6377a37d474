#include "kernels/momentum_exchange.hpp"

#include "kernels/dense_neighbour.hpp"
#include "kernels/launch.hpp"
#include "kernels/offsets.hpp"
#include "kernels/prefetch.hpp"

namespace vug {

/// Counts (fill = false, into first(g + 1)) or lists the fluid links of a group's nodes.
struct ListWallLinks {
  DenseNeighbour lattice;
  IndexList index, offset, node;
  VectorField<double> centre;
  double spacing;
  WallLinks links;
  bool fill;

  KOKKOS_FUNCTION void store(int at, int g, int solid, int fluid, int q) const {
    const double x = lattice.lattice.x(solid) + 0.5 - centre(g, 0) / spacing;
    const double y = lattice.lattice.y(solid) + 0.5 - centre(g, 1) / spacing;
    links.link(at) = 8 * fluid + q - 1;
    links.arm(at) = x * D2Q9::c(q, 1) - y * D2Q9::c(q, 0);
  }

  KOKKOS_FUNCTION void operator()(int g) const {
    int at = fill ? links.first(g) : 0;
    for (int k = offset(g); k < offset(g + 1); ++k)
      for (int q = 1; q < D2Q9::Q; ++q) {
        const int fluid = lattice.fluid_along(index, node(k), D2Q9::opposite(q));
        if (fluid < 0) continue;
        if (fill) store(at, g, node(k), fluid, q);
        ++at;
      }
    if (!fill) links.first(g + 1) = at;
  }
};

void find_wall_links(const Exec& exec, const FluidNodes& nodes, const IndexList& offset, const IndexList& node,
                     const VectorField<double>& centre, double spacing, WallLinks& links) {
  const int groups = static_cast<int>(offset.extent(0)) - 1;
  if (links.groups() != groups) links.first = IndexList("vug::momentum_exchange::first", offset.extent(0));
  const DenseNeighbour lattice(nodes);
  for_each_node(exec, "vug::momentum_exchange::count", groups,
                ListWallLinks{lattice, nodes.index, offset, node, centre, spacing, links, false});
  const int count = accumulate_counts(exec, "vug::momentum_exchange::places", links.first);
  if (static_cast<int>(links.link.extent(0)) < count) {
    links.link = IndexList("vug::momentum_exchange::link", count + count / 2);
    links.arm = ScalarField<double>("vug::momentum_exchange::arm", count + count / 2);
  }
  for_each_node(exec, "vug::momentum_exchange::list", groups,
                ListWallLinks{lattice, nodes.index, offset, node, centre, spacing, links, true});
}

/// Momentum of links and its moment; its own sum in a reduction.
struct Wrench {
  double x = 0, y = 0, torque = 0;
  KOKKOS_FORCEINLINE_FUNCTION Wrench& operator+=(const Wrench& other) {
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

/// One group: its links in their order on a host, by a team on a GPU.
template <class T>
struct ExchangeMomentum {
  using Team = typename Kokkos::TeamPolicy<Exec>::member_type;
  Kokkos::View<const int*> first, link;
  Kokkos::View<const double*> arm;
  Kokkos::View<const T*> f;
  int capacity, size;
  double force_scale, torque_scale;
  VectorField<double> force;
  ScalarField<double> torque;

  KOKKOS_FORCEINLINE_FUNCTION Wrench of_link(int k) const {
    const int q = (link(k) & 7) + 1, i = link(k) >> 3;
    const double twice = 2 * static_cast<double>(f(q * capacity + i));
    return {twice * D2Q9::c(q, 0), twice * D2Q9::c(q, 1), twice * arm(k)};
  }
  KOKKOS_FORCEINLINE_FUNCTION void store(int g, const Wrench& sum) const {
    force(g, 0) = force_scale * sum.x;
    force(g, 1) = force_scale * sum.y;
    torque(g) = torque_scale * sum.torque;
  }
  /// The populations of a particle's links lie in no order that a processor foresees.
  KOKKOS_FORCEINLINE_FUNCTION void announce(int k) const {
    constexpr int ahead = 64;
    const int later = link(k + ahead < size ? k + ahead : size - 1);
    prefetch(&f(((later & 7) + 1) * capacity + (later >> 3)));
  }
  KOKKOS_FUNCTION void operator()(int g) const {
    Wrench sum;
    for (int k = first(g); k < first(g + 1); ++k) {
      announce(k);
      sum += of_link(k);
    }
    store(g, sum);
  }
  KOKKOS_FUNCTION void operator()(const Team& team) const {
    const int g = team.league_rank();
    Wrench sum;
    Kokkos::parallel_reduce(
        Kokkos::TeamThreadRange(team, first(g), first(g + 1)), [&](int k, Wrench& s) { s += of_link(k); },
        Kokkos::Sum<Wrench>(sum));
    Kokkos::single(Kokkos::PerTeam(team), [&] { store(g, sum); });
  }
};

template <class T>
void exchange_momentum(const Exec& exec, const FlowFields<T>& fields, int capacity, const WallLinks& links,
                       double force_scale, double torque_scale, const VectorField<double>& force,
                       const ScalarField<double>& torque) {
  if (links.groups() <= 0) return;
  const ExchangeMomentum<T> exchange{
      links.first, links.link,   links.arm, fields.f, capacity, static_cast<int>(links.link.extent(0)),
      force_scale, torque_scale, force,     torque};
  if constexpr (runs_on_host)
    Kokkos::parallel_for("vug::momentum_exchange::gather", Kokkos::RangePolicy<Exec>(exec, 0, links.groups()),
                         exchange);
  else
    Kokkos::parallel_for("vug::momentum_exchange::gather", Kokkos::TeamPolicy<Exec>(exec, links.groups(), 32),
                         exchange);
}

template void exchange_momentum(const Exec&, const FlowFields<float>&, int, const WallLinks&, double, double,
                                const VectorField<double>&, const ScalarField<double>&);
template void exchange_momentum(const Exec&, const FlowFields<double>&, int, const WallLinks&, double, double,
                                const VectorField<double>&, const ScalarField<double>&);

}  // namespace vug
