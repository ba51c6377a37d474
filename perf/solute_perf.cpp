// The solute kernels and the reactive wall: velocity sets, precisions, geometries.
#include "kernels/advective_form.hpp"
#include "kernels/reactive_wall_kernel.hpp"
#include "kernels/solute.hpp"
#include "kernels/surface_normal.hpp"
#include "measure.hpp"
#include "rock_geometry.hpp"

namespace vug::perf {
namespace {

/// Two solutes at rest in a uniform flow over a geometry.
template <class T, class Set>
struct SoluteSetting {
  Exec exec;
  Lattice lattice{2000, 1400};
  Kokkos::View<NodeType*> type;
  FluidNodes nodes;
  SoluteFields<T> acid, product;
  VectorField<T> u;
  ScalarField<T> e;
  SoluteParameters parameters = solute_parameters(0.02);

  explicit SoluteSetting(const Geometry& geometry)
      : type(node_types(geometry, lattice)),
        nodes(make_fluid_nodes(exec, lattice, type)),
        acid(make_solute_fields<T, Set>(exec, nodes, 0.5)),
        product(make_solute_fields<T, Set>(exec, nodes, 0.1)),
        u("u", nodes.capacity),
        e("e", nodes.capacity) {
    Kokkos::deep_copy(u, T(0.001));
    advective_defect<Set>(exec, nodes, u, e);
  }
};

/// Populations read and written, indices, concentration written.
template <class T, class Set>
constexpr double sweep_bytes = (2 * Set::Q + 1) * sizeof(T) + index_bytes(Set::Q - 1);

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
  measure<T, 2>(state, s.nodes.count, 3 * sizeof(T) + 4 * (Set::Q - 1) + 3 * sizeof(std::uint16_t),
                [&] { advective_defect<Set>(s.exec, s.nodes, s.u, s.e); });
}

/// Links between fluid and solid of the velocity set.
template <class Set>
struct CountWallLinks {
  Kokkos::View<const std::uint16_t*> solid_links;
  KOKKOS_FUNCTION void operator()(int i, int& links) const {
    for (int q = 1; q < Set::Q; ++q) links += solid_links(i) >> q & 1;
  }
};

template <class Set>
int wall_links(const FluidNodes& nodes) {
  int links = 0;
  Kokkos::parallel_reduce("vug::perf::wall_links", nodes.count, CountWallLinks<Set>{nodes.solid_links}, links);
  return links;
}

struct SolidVolume {
  Kokkos::View<const NodeType*> type;
  ScalarField<double> V;
  KOKKOS_FUNCTION void operator()(int n) const { V(n) = type(n) == NodeType::solid; }
};

/// At the middle of a link.
struct FaceTemperature {
  ScalarField<double> T;
  KOKKOS_FUNCTION double operator()(int solid, int fluid) const { return 0.5 * (T(solid) + T(fluid)); }
};

enum class RateLaw { uniform, arrhenius, stored };

/// Updates are wall links: two populations read and written, an index and the node of the fluid; and per node of the
/// surface its number, normal, volume and what has dissolved of it. Copied are two streams over as many links.
template <class T, class Set>
void react(benchmark::State& state, const Geometry* geometry, RateLaw law) {
  SoluteSetting<T, Set> s(*geometry);
  const ScalarField<double> V("V", s.lattice.size());
  for_each_node(s.exec, "vug::perf::volume", s.lattice.size(), SolidVolume{s.type, V});
  Surface surface;
  find_surface(s.exec, s.nodes, s.type, surface);
  VectorField<double> normal;
  find_normals(s.exec, s.nodes, surface, V, normal);
  ReactiveWall wall;
  wall.molar_volume = 1e-6;
  wall.inverse_equilibrium = 1e-3;
  const ReactionLedger ledger{V,
                              ScalarField<double>("dissolved", s.lattice.size()),
                              ScalarField<double>("consumed", block_count(s.lattice.size())),
                              {}};
  const ScalarField<double> temperature("T", s.lattice.size()), k("k", s.lattice.size());
  Kokkos::deep_copy(temperature, 350.0);
  const ArrheniusRate<FaceTemperature> hot{1e-9, 7553, 273.15, {temperature}};
  store_rates(s.exec, s.nodes, surface, hot, k);
  const int links = wall_links<Set>(s.nodes);
  const double bytes =
      4 * sizeof(T) + 2 * sizeof(int) + static_cast<double>(surface.count) / links * (sizeof(int) + 6 * sizeof(double));
  const auto with = [&](const auto& rate) {
    measure<T, 2>(state, links, bytes, [&] {
      react_at_wall<Set>(s.exec, s.nodes, surface, wall, rate, normal, s.acid, &s.product, ledger);
    });
  };
  if (law == RateLaw::stored)
    with(StoredRate{k});
  else if (law == RateLaw::arrhenius)
    with(hot);
  else
    with(UniformRate{1e-9});
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
    add("wall/uniform_rate" + end, react<T, Set>, &geometry, RateLaw::uniform);
    add("wall/arrhenius_rate" + end, react<T, Set>, &geometry, RateLaw::arrhenius);
    add("wall/stored_rate" + end, react<T, Set>, &geometry, RateLaw::stored);
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
