#pragma once
// A reacting pixel domain for tests: everything of the solute side wired together as a run wires it.
#include "kernels/launch/launch.hpp"
#include "kernels/reaction/dissolution.hpp"
#include "kernels/reaction/reactive_wall_kernel.hpp"
#include "kernels/reaction/surface_normal.hpp"
#include "kernels/solute/solute.hpp"
#include "support/advance.hpp"
#include "support/dress_one.hpp"
#include "support/host_copy.hpp"

#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace vug::reference {

/// The same rate constant k everywhere.
inline ArrheniusRate<UniformTemperature> uniform_rate(double k) {
  return {k, 0, 298, {298}};
}

/// One or two species, one reactive solid, concentrations given on some sides.
template <class Set, class T>
struct ReactiveBox {
  struct GivenSide {
    BoundaryLinks links;
    std::vector<double> C_b;  ///< (link)
    ScalarField<double> gain, product_gain;
  };

  Exec exec;
  Lattice lattice;
  Kokkos::View<NodeType*> type;
  ScalarField<double> V, dissolved, consumed, lost, created;
  FluidNodes nodes;
  Surface surface;
  VectorField<double> normal;
  ReactiveLinks<T> links;
  SoluteParameters parameters;
  SoluteFields<T> acid, product;
  bool has_product = false, use_normals = false;
  bool given_product = false;  ///< the product is held at 0 where the acid is given
  ReactiveWall wall;
  std::int64_t steps = 0;  ///< done by step()
  double k = 0;
  double links_for = -1;  ///< the k that links.conductance is for
  std::vector<GivenSide> given;
  long double gained_before = 0;  ///< see drain()

  ReactiveBox(int nx, int ny, const std::function<bool(int, int)>& solid, SoluteParameters p, double C0 = 0,
              std::array<bool, 2> periodic = {false, false})
      : lattice(nx, ny),
        type("type", lattice.size()),
        V("V", lattice.size()),
        dissolved("dissolved", lattice.size()),
        consumed("consumed", block_count(lattice.size())),
        lost("lost", block_count(lattice.size())),
        created("created", block_count(lattice.size())),
        parameters(p) {
    const auto type_host = Kokkos::create_mirror_view(type);
    const auto V_host = Kokkos::create_mirror_view(V);
    Kokkos::deep_copy(type_host, NodeType::solid);
    for (int y = 0; y < ny; ++y)
      for (int x = 0; x < nx; ++x) {
        type_host(lattice.node(x, y)) = solid(x, y) ? NodeType::solid : NodeType::fluid;
        V_host(lattice.node(x, y)) = solid(x, y) ? 1 : 0;
      }
    Kokkos::deep_copy(type, type_host);
    Kokkos::deep_copy(V, V_host);
    nodes = make_fluid_nodes(exec, lattice, type, periodic);
    find_surface(exec, nodes, type, surface);
    acid = make_solute_fields<Set, T>(exec, nodes, C0);
  }

  void add_product(double C0 = 0) {
    product = make_solute_fields<Set, T>(exec, nodes, C0);
    has_product = true;
  }

  /// Concentration C(coordinate along the side) half way beyond `side`.
  void give_concentration(Side side, const std::function<double(int)>& C) {
    GivenSide g{find_boundary_links(exec, nodes, side, 0, side_length(lattice, side) - 1, Set::Q), {}, {}, {}};
    g.gain = ScalarField<double>("gain", g.links.count);
    g.product_gain = ScalarField<double>("product_gain", g.links.count);
    const auto fluid = test::host_copy(g.links.fluid);
    const auto node = test::host_copy(nodes.node);
    for (int l = 0; l < g.links.count; ++l)
      g.C_b.push_back(C(is_upright(side) ? lattice.y(node(fluid(l))) : lattice.x(node(fluid(l)))));
    given.push_back(g);
  }

  void renew_normals() {
    if (use_normals) find_normals(exec, nodes, surface, V, dissolved, normal);
    links_for = -1;
  }

  /// Reaction at the walls with the rate constant k, booked at once.
  void react() {
    if (k != links_for) {
      find_reactive_links<Set>(exec, nodes, surface, wall.law, links);
      set_conductances<Set>(exec, nodes, surface, wall, uniform_rate(k), normal, links);
      links_for = k;
    }
    react_at_wall<Set>(exec, nodes, wall, links, acid, has_product ? &product : nullptr);
    book_turnover(exec, surface, wall, links, ReactionLedger{V, dissolved, consumed, {}, {}});
  }

  void step() {
    acid.rounding = product.rounding = rounding_of_step<T>(++steps);
    for (const GivenSide& g : given) dress_concentration<Set>(exec, nodes, g.links, g.C_b, acid, g.gain);
    if (given_product)
      for (const GivenSide& g : given) dress_concentration<Set>(exec, nodes, g.links, 0.0, product, g.product_gain);
    if (k > 0) react();
    advance_solute<Set>(exec, nodes, parameters, acid);
    if (has_product) advance_solute<Set>(exec, nodes, parameters, product);
  }

  /// Turns dissolved pixels into fluid; returns how many. Call between steps. Not with sides of given concentration
  /// that the newborn nodes touch.
  int births(BirthFill fill) {
    if (mark_dissolved(exec, nodes, surface, type, V, lost) == 0) return 0;
    const int first = nodes.count;
    const int births = append_births(exec, type, nodes);
    fit_to_capacity(exec, nodes, Set::Q, first, acid.h, acid.C);
    if (has_product) fit_to_capacity(exec, nodes, Set::Q, first, product.h, product.C);
    initialise_births<Set>(exec, nodes, first, nodes.count, fill, acid, created);
    if (has_product) initialise_births<Set>(exec, nodes, first, nodes.count, fill, product, created);
    find_surface(exec, nodes, type, surface);
    renew_normals();
    return births;
  }

  /// Empties the ledgers of the sides into a sum of more digits. A ledger that takes a million small and nearly equal
  /// amounts rounds them all the same way, by up to half a digit of the sum each; emptied now and then it stays exact.
  void drain() {
    for (const GivenSide& g : given) {
      gained_before += sum_in_order(g.gain);
      Kokkos::deep_copy(g.gain, 0.0);
    }
  }

  double total(const SoluteFields<T>& species) const {
    const ScalarField<double> sums("sums", block_count(nodes.count));
    add_solute<Set>(exec, nodes, species, sums);
    exec.fence();
    return sum_in_order(sums);
  }
  double acid_total() const { return total(acid); }
  double product_total() const { return total(product); }
  double solid_total() const { return sum_in_order(V); }
  double gained() const {
    long double sum = gained_before;
    for (const GivenSide& g : given) sum += sum_in_order(g.gain);
    return static_cast<double>(sum);
  }

  /// Concentration of the last sweep at lattice node (x, y) of a dense host array [y * nx + x]; 0 in solid.
  std::vector<double> concentration(const SoluteFields<T>& s) const {
    std::vector<double> dense(static_cast<std::size_t>(lattice.nx) * lattice.ny, 0);
    const auto C = test::host_copy(s.C);
    const auto node = test::host_copy(nodes.node);
    for (int i = 0; i < nodes.count; ++i) dense[lattice.y(node(i)) * lattice.nx + lattice.x(node(i))] = double(C(i));
    return dense;
  }
};

/// Concentrations between 0 and 1 at random, at rest.
template <class Set, class T>
void set_random(ReactiveBox<Set, T>& box) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  test::edit(box.acid.h, [&](const auto& h) {
    for (int i = 0; i < box.nodes.count; ++i) {
      const double C = uniform(random);
      for (int q = 0; q < Set::Q; ++q) h(q * box.nodes.capacity + i) = static_cast<T>(Set::w(q) * C);
    }
  });
}

}  // namespace vug::reference
