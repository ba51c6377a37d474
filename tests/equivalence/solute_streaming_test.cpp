// The sweep in place, from home and from turned, does what two lattices and the equations do node by node: through
// walls, given concentrations, outflow and births, after even and odd numbers of steps.
#include "../reference/reactive_box.hpp"
#include "support/advance.hpp"
#include "support/dress_one.hpp"
#include "support/host_copy.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace vug {
namespace {

using test::host_copy;

constexpr int nx = 45, ny = 19;
constexpr double inlet = 0.7;

/// The textbook form on a dense lattice: stream into a second lattice, then collide. Concentration given on the left,
/// outflow on the right, walls elsewhere.
template <class Set>
class PlainSolute {
 public:
  PlainSolute(const std::vector<char>& solid, const SoluteParameters& parameters, double C)
      : solid_(solid), p_(parameters), h_(std::size_t(Set::Q) * nx * ny, 0.0) {
    for (int n = 0; n < nx * ny; ++n) fill(n, C);
  }

  void step(const std::vector<std::array<double, 2>>& u, const std::vector<double>& e) {
    std::vector<double> next(h_.size(), 0.0);
    for (int n = 0; n < nx * ny; ++n) {
      if (solid_[n]) continue;
      std::array<double, Set::Q> g{};
      double C = 0, jx = 0, jy = 0;
      for (int q = 0; q < Set::Q; ++q) {
        g[q] = arriving(n, q);
        C += g[q];
        jx += Set::c(q, 0) * g[q];
        jy += Set::c(q, 1) * g[q];
      }
      const auto [ux, uy] = u[n];
      g[0] -= C * e[n] / (1 + e[n]);
      C /= 1 + e[n];
      for (int q = 0; q < Set::Q; ++q) {
        const double cu = Set::c(q, 0) * ux + Set::c(q, 1) * uy;
        const double second = Set::Q == 9 ? 4.5 * cu * cu - 1.5 * (ux * ux + uy * uy) : 0;
        const double cJ = Set::c(q, 0) * (jx - C * ux) + Set::c(q, 1) * (jy - C * uy);
        next[q * nx * ny + n] = g[q] - (g[q] - Set::w(q) * C * (1 + 3 * cu + second)) / p_.tau_h +
                                (1 / p_.tau_h - 1 / p_.tau_1) * 3 * Set::w(q) * cJ;
      }
    }
    h_ = next;
  }

  void open(int n) {
    double C = 0;
    int neighbours = 0;
    for (int q = 1; q < Set::Q; ++q)
      if (const int from = upstream(n, q); from >= 0 && !solid_[from]) {
        C += concentration(from);
        ++neighbours;
      }
    solid_[n] = 0;
    fill(n, C / neighbours);
  }

  double concentration(int n) const {
    double C = 0;
    for (int q = 0; q < Set::Q; ++q) C += h_[q * nx * ny + n];
    return C;
  }

 private:
  void fill(int n, double C) {
    for (int q = 0; q < Set::Q; ++q) h_[q * nx * ny + n] = solid_[n] ? 0 : Set::w(q) * C;
  }
  /// -1 beyond the left side, -2 beyond the right one. Beyond the others there is rock.
  static int upstream(int n, int q) {
    const int x = n % nx - Set::c(q, 0), y = n / nx - Set::c(q, 1);
    return x < 0 ? -1 : x >= nx ? -2 : y * nx + x;
  }
  double arriving(int n, int q) const {
    const int from = upstream(n, q);
    const double back = h_[Set::opposite(q) * nx * ny + n];
    if (from == -1) return 2 * Set::w(q) * inlet - back;
    if (from == -2) {  // less what it diffuses: no gradient beyond, half of what there is since the node before
      const int before = upstream(n, Set::opposite(q));
      const double rise = before >= 0 && !solid_[before] ? concentration(n) - concentration(before) : 0;
      return h_[q * nx * ny + n] - (p_.tau_1 - 1) * Set::w(q) * rise;
    }
    return solid_[from] ? back : h_[q * nx * ny + from];
  }

  std::vector<char> solid_;
  SoluteParameters p_;
  std::vector<double> h_;
};

template <class Set, class T>
void expect_plain_steps(double tolerance) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> small(-0.03, 0.03);
  std::vector<char> solid(nx * ny);
  std::vector<std::array<double, 2>> velocity(nx * ny);
  std::vector<double> defect(nx * ny);
  for (int n = 0; n < nx * ny; ++n) {
    solid[n] = n < nx || n >= nx * (ny - 1) || random() % 4 == 0;
    velocity[n] = {0.05 + small(random), small(random)};
    defect[n] = small(random);
  }
  const auto number = [](int x, int y) { return y * nx + x; };
  const auto opens_after = [&](int step) { return number(7 + 2 * step, 9); };
  for (int step = 1; step <= 9; ++step) {  // rock to be opened, fluid beside it
    solid[opens_after(step)] = 1;
    solid[opens_after(step) - 1] = 0;
  }
  const SoluteParameters parameters = solute_parameters(0.07);
  reference::ReactiveBox<Set, T> box(
      nx, ny, [&](int x, int y) { return solid[number(x, y)]; }, parameters, 0.2);
  PlainSolute<Set> plain(solid, parameters, 0.2);

  for (int step = 1; step <= 9; ++step) {
    const FluidNodes& nodes = box.nodes;
    const auto node = host_copy(nodes.node);
    const auto dense = [&](int i) { return number(nodes.lattice.x(node(i)), nodes.lattice.y(node(i))); };
    const VectorField<T> u("u", nodes.capacity);
    const ScalarField<T> e("e", nodes.capacity);
    const auto u_host = Kokkos::create_mirror_view(u);
    const auto e_host = Kokkos::create_mirror_view(e);
    for (int i = 0; i < nodes.count; ++i) {
      for (int axis = 0; axis < 2; ++axis) u_host(i, axis) = static_cast<T>(velocity[dense(i)][axis] / 2);
      e_host(i) = static_cast<T>(defect[dense(i)]);
    }
    Kokkos::deep_copy(u, u_host);
    Kokkos::deep_copy(e, e_host);
    const BoundaryLinks left = find_boundary_links(box.exec, nodes, Side::left, 0, ny - 1, Set::Q);
    const BoundaryLinks right = find_boundary_links(box.exec, nodes, Side::right, 0, ny - 1, Set::Q);
    dress_outflow<Set>(box.exec, nodes, right, parameters, box.acid, ScalarField<double>("gain", right.count));
    dress_concentration<Set>(box.exec, nodes, left, inlet, box.acid, ScalarField<double>("gain", left.count));
    // twice half the velocity: that of a solute that steps every second time
    advance_solute<Set>(box.exec, nodes, parameters, {u, 2}, e, box.acid,
                        ScalarField<double>("added", block_count(nodes.count)));
    plain.step(velocity, defect);
    const auto C = host_copy(box.acid.C);
    for (int i = 0; i < nodes.count; ++i)
      ASSERT_NEAR(C(i), plain.concentration(dense(i)), tolerance) << "step " << step << ", node " << dense(i);

    if (step % 3 != 0) continue;  // births after odd and even numbers of steps
    const int opened = opens_after(step), first = nodes.count;
    const auto type = host_copy(box.type);
    type(nodes.lattice.node(opened % nx, opened / nx)) = NodeType::fluid;
    Kokkos::deep_copy(box.type, type);
    ASSERT_EQ(append_births(box.exec, box.type, box.nodes), 1);
    fit_to_capacity(box.exec, box.nodes, Set::Q, first, box.acid.h, box.acid.C);
    initialise_births<Set>(box.exec, box.nodes, first, first + 1, BirthFill::mean, box.acid, box.created);
    plain.open(opened);
  }
}

TEST(SoluteInPlace, DoesWhatTwoLatticesDo) {
  expect_plain_steps<D2Q5, double>(1e-14);
  expect_plain_steps<D2Q9, double>(1e-14);
  expect_plain_steps<D2Q5, float>(1e-6);
  expect_plain_steps<D2Q9, float>(1e-6);
}

}  // namespace
}  // namespace vug
