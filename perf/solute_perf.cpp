// The solute kernels and the reactive wall: velocity sets, precisions, geometries.
#include "kernels/reaction/reactive_wall_kernel.hpp"
#include "kernels/reaction/surface_normal.hpp"
#include "kernels/scalar/advective_form.hpp"
#include "measure.hpp"
#include "rock_geometry.hpp"
#include "support/advance.hpp"

namespace vug::perf {
namespace {

/// Two solutes at rest in a uniform flow over a geometry.
template <class T, class Set>
struct SoluteSetting {
  Exec exec;
  Lattice lattice = timed_lattice();
  Kokkos::View<NodeType*> type;
  FluidNodes nodes;
  SoluteFields<T> acid, product;
  VectorField<T> u;
  ScalarField<T> e;
  SoluteParameters parameters = solute_parameters(0.02);

  explicit SoluteSetting(const Geometry& geometry)
      : type(node_types(geometry, lattice)),
        nodes(make_fluid_nodes(exec, lattice, type)),
        acid(make_solute_fields<Set, T>(exec, nodes, 0.5)),
        product(make_solute_fields<Set, T>(exec, nodes, 0.1)),
        u("u", nodes.capacity),
        e("e", nodes.capacity) {
    Kokkos::deep_copy(u, T(0.001));
    advective_defect<Set>(exec, nodes, u, e);
  }
};

/// Populations read and written, indices in every second step, concentration written.
template <class T, class Set>
constexpr double sweep_bytes = (2 * Set::Q + 1) * sizeof(T) + index_bytes(Set::Q - 1) / 2;

template <class T, class Set>
void diffuse(benchmark::State& state, const Geometry* geometry) {
  SoluteSetting<T, Set> s(*geometry);
  measure<T, Set::Q>(state, s.nodes.count, sweep_bytes<T, Set>,
                     [&] { advance_solute<Set>(s.exec, s.nodes, s.parameters, s.acid); });
}

template <class T, class Set>
void advect(benchmark::State& state, const Geometry* geometry) {
  SoluteSetting<T, Set> s(*geometry);
  measure<T, Set::Q>(state, s.nodes.count, sweep_bytes<T, Set> + 2 * sizeof(T),
                     [&] { advance_solute<Set>(s.exec, s.nodes, s.parameters, s.u, s.acid); });
}

template <class T, class Set>
void advect_in_advective_form(benchmark::State& state, const Geometry* geometry) {
  SoluteSetting<T, Set> s(*geometry);
  const ScalarField<double> correction("correction", block_count(s.nodes.count));
  measure<T, Set::Q>(state, s.nodes.count, sweep_bytes<T, Set> + 3 * sizeof(T),
                     [&] { advance_solute<Set>(s.exec, s.nodes, s.parameters, s.u, s.e, s.acid, correction); });
}

/// Velocity read, defect written, indices and three sets of link bits.
template <class T, class Set>
void find_defect(benchmark::State& state, const Geometry* geometry) {
  SoluteSetting<T, Set> s(*geometry);
  measure<T, 2>(state, s.nodes.count, 3 * sizeof(T) + index_bytes(Set::Q - 1) + 3 * sizeof(std::uint16_t),
                [&] { advective_defect<Set>(s.exec, s.nodes, s.u, s.e); });
}

struct SolidVolume {
  Kokkos::View<const NodeType*> type;
  ScalarField<double> V;
  KOKKOS_FUNCTION void operator()(int n) const { V(n) = type(n) == NodeType::solid; }
};

/// At the middle of a link.
struct FaceTemperature {
  ScalarField<double> T;
  KOKKOS_FORCEINLINE_FUNCTION void announce(int, int) const {}
  KOKKOS_FUNCTION double operator()(int solid, int fluid) const { return 0.5 * (T(solid) + T(fluid)); }
};

/// A reacting wall with both solutes.
template <class T, class Set>
struct WallSetting : SoluteSetting<T, Set> {
  using Base = SoluteSetting<T, Set>;
  using Base::exec, Base::lattice, Base::nodes;
  ScalarField<double> V{"V", lattice.size()}, temperature{"T", lattice.size()};
  Surface surface;
  VectorField<double> normal;
  ReactiveWall wall;
  ReactiveLinks<T> links;
  ArrheniusRate<FaceTemperature> rate{1e-9, 7553, 273.15, {temperature}};
  ReactionLedger ledger{.V = V,
                        .dissolved = ScalarField<double>("dissolved", lattice.size()),
                        .consumed = ScalarField<double>("consumed", block_count(lattice.size())),
                        .released = {},
                        .acid = {}};

  explicit WallSetting(const Geometry& geometry) : Base(geometry) {
    for_each_node(exec, "vug::perf::volume", lattice.size(), SolidVolume{this->type, V});
    Kokkos::deep_copy(temperature, 350.0);
    find_surface(exec, nodes, this->type, surface);
    wall.molar_volume = 1e-6;
    wall.inverse_equilibrium = 1e-3;
    find_normals(exec, nodes, surface, V, ledger.dissolved, normal);
    find_reactive_links<Set>(exec, nodes, surface, wall.law, links);
    conduct();
  }
  void conduct() { set_conductances<Set>(exec, nodes, surface, wall, rate, normal, links); }
  double nodes_per_link() const { return static_cast<double>(surface.count) / links.count; }
};

/// Of each link two populations both ways, slot, conductance, turnover both ways. Copied are two streams as long.
template <class T, class Set>
void react(benchmark::State& state, const Geometry* geometry) {
  WallSetting<T, Set> s(*geometry);
  measure<T, 2>(state, s.links.count, 5 * sizeof(T) + sizeof(int) + 2 * sizeof(double),
                [&] { react_at_wall<Set>(s.exec, s.nodes, s.wall, s.links, s.acid, &s.product); });
}

/// As a run with both does it: two sweeps in advective form and the reaction behind them in one pass.
template <class T, class Set>
void sweep_and_react(benchmark::State& state, const Geometry* geometry) {
  WallSetting<T, Set> s(*geometry);
  const int blocks = block_count(s.nodes.count);
  const SoluteCarrier<T> carrier{s.u, s.e};
  const SteppingSolute<T> acid{s.parameters, s.acid, ScalarField<double>("correction", blocks)};
  const SteppingSolute<T> product{s.parameters, s.product, ScalarField<double>("correction", blocks)};
  const double links_per_node = static_cast<double>(s.links.count) / s.nodes.count;
  measure<T, 2 * Set::Q>(
      state, s.nodes.count,
      2 * (sweep_bytes<T, Set> + 3 * sizeof(T)) + links_per_node * (sizeof(T) + sizeof(int) + 2 * sizeof(double)),
      [&] { advance_reacting_solutes<Set>(s.exec, s.nodes, carrier, s.wall, s.links, acid, &product); });
}

/// Of each link slot, root, both temperatures, conductance; of each surface node its number and normal.
template <class T, class Set>
void conductances(benchmark::State& state, const Geometry* geometry) {
  WallSetting<T, Set> s(*geometry);
  const double bytes = sizeof(T) + 2 * sizeof(int) + 2 * sizeof(double) + s.nodes_per_link() * (sizeof(int) + 16);
  measure<T, 2>(state, s.links.count, bytes, [&] { s.conduct(); });
}

/// Of each link the turnover both ways; of each surface node its number and two volumes both ways.
template <class T, class Set>
void book(benchmark::State& state, const Geometry* geometry) {
  WallSetting<T, Set> s(*geometry);
  measure<T, 2>(state, s.links.count, 2 * sizeof(double) + s.nodes_per_link() * (sizeof(int) + 32),
                [&] { book_turnover(s.exec, s.surface, s.wall, s.links, s.ledger); });
}

/// Updates are surface nodes: the volume of eight neighbours that no other has read, the number, the normal.
template <class T, class Set>
void normals(benchmark::State& state, const Geometry* geometry) {
  WallSetting<T, Set> s(*geometry);
  measure<double, 2>(state, s.surface.count, sizeof(int) + 10 * sizeof(double),
                     [&] { find_normals(s.exec, s.nodes, s.surface, s.V, s.ledger.dissolved, s.normal); });
}

template <class T, class Set>
void add_set(const std::string& suffix) {
  for (const Geometry& geometry : geometries) {
    const std::string end = suffix + geometry.name;
    add("solute/diffuse" + end, diffuse<T, Set>, &geometry);
    add("solute/advect" + end, advect<T, Set>, &geometry);
    add("solute/advective_form" + end, advect_in_advective_form<T, Set>, &geometry);
    add("solute/defect" + end, find_defect<T, Set>, &geometry);
    if (geometry.share_of_edges == 0) continue;  // no walls
    add("wall/react" + end, react<T, Set>, &geometry);
    add("solute/two_reacting" + end, sweep_and_react<T, Set>, &geometry);
    add("wall/conductances" + end, conductances<T, Set>, &geometry);
    add("wall/book" + end, book<T, Set>, &geometry);
    if (std::is_same_v<T, double> && Set::Q == D2Q5::Q) add("wall/normals" + end, normals<T, Set>, &geometry);
  }
}

[[maybe_unused]] const bool registered = [] {
  add_set<double, D2Q5>("_D2Q5/double/");
  add_set<float, D2Q5>("_D2Q5/float/");
  add_set<double, D2Q9>("_D2Q9/double/");
  add_set<float, D2Q9>("_D2Q9/float/");
  return true;
}();

}  // namespace
}  // namespace vug::perf
