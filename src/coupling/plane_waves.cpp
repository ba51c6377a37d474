#include "coupling/plane_waves.hpp"

#include "kernels/flow/two_relaxation_times.hpp"
#include "kernels/heat/heat_kernels.hpp"
#include "kernels/solute/solute_sweep.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vug {

namespace {

template <class Set>
using Populations = double[Set::Q];

template <class Set>
using Matrix = Eigen::Matrix<std::complex<double>, Set::Q, Set::Q>;

/// Jacobian of collide(g) at the populations `rest`, by central differences, which are exact for quadratic laws.
template <class Set, class Collide>
Eigen::Matrix<double, Set::Q, Set::Q> jacobian(const Populations<Set>& rest, const Collide& collide) {
  constexpr double shift = 0x1p-7;
  Eigen::Matrix<double, Set::Q, Set::Q> result;
  for (int p = 0; p < Set::Q; ++p) {
    Populations<Set> up, down;
    std::copy(rest, rest + Set::Q, up);
    std::copy(rest, rest + Set::Q, down);
    up[p] += shift;
    down[p] -= shift;
    collide(up);
    collide(down);
    for (int q = 0; q < Set::Q; ++q) result(q, p) = (up[q] - down[q]) / (2 * shift);
  }
  return result;
}

template <class Set>
std::vector<std::complex<double>> waves(const Eigen::Matrix<double, Set::Q, Set::Q>& collision, const Vector2& k) {
  Matrix<Set> step = collision.template cast<std::complex<double>>();
  for (int q = 0; q < Set::Q; ++q) step.row(q) *= std::polar(1.0, -(k[0] * Set::c(q, 0) + k[1] * Set::c(q, 1)));
  const Eigen::ComplexEigenSolver<Matrix<Set>> solver(step, false);
  return {solver.eigenvalues().begin(), solver.eigenvalues().end()};
}

/// Largest growth of a wave at a speed. collision_at(u): the Jacobian at that velocity. A wave and its negative are
/// conjugate, so that one of the two is enough.
template <class Set, class CollisionAt>
double growth(double speed, const CollisionAt& collision_at) {
  constexpr int box = 24;
  double largest = 0;
  for (const double degrees : {0.0, 22.5, 45.0}) {
    const double angle = degrees * std::numbers::pi / 180;
    const auto collision = collision_at(Vector2{speed * std::cos(angle), speed * std::sin(angle)});
    for (int x = 0; x <= box / 2; ++x)
      for (int y = 1 - box / 2; y <= box / 2; ++y)
        for (const auto& value :
             waves<Set>(collision, {2 * std::numbers::pi * x / box, 2 * std::numbers::pi * y / box}))
          largest = std::max(largest, std::abs(value));
  }
  return largest;
}

auto flow_collision(Collision collision, double tau, const Vector2& u) {
  Populations<D2Q9> rest;
  for (int q = 0; q < D2Q9::Q; ++q) rest[q] = equilibrium(q, 0.0, u[0], u[1]);
  const RelaxationRates rates = relaxation_rates(collision, tau);
  const auto by = [&](const auto& law) {
    return jacobian<D2Q9>(rest, [&](Populations<D2Q9>& f) { law(f, macroscopic(f), NoForce<double>{}); });
  };
  if (collision == Collision::lallemand_luo) return by(MultipleRelaxationTimes<double>(rates));
  if (collision == Collision::regularised) return by(Regularised<double>(rates));
  return by(TwoRelaxationTimes<double>(rates));
}

template <class Set>
auto solute_collision(const SoluteParameters& p, const Vector2& u) {
  return jacobian<Set>({}, [&](Populations<Set>& g) {
    double c = 0, flux[2] = {};
    for (int q = 0; q < Set::Q; ++q) {
      c += g[q];
      for (const int axis : {0, 1}) flux[axis] += Set::c(q, axis) * g[q];
    }
    SoluteCollision<double, Set>(p).template relax<true>(0, g, c, u[0], u[1], flux[0] - c * u[0], flux[1] - c * u[1]);
  });
}

template <class Set>
auto heat_collision(double diffusivity, const Vector2& u) {
  const auto rates = heat_rates<double>({diffusivity, diffusivity, 1});
  return jacobian<Set>({}, [&](Populations<Set>& g) {
    Populations<Set> arrived;
    std::copy(g, g + Set::Q, arrived);
    conduct_node<double, Set>(g, arrived, rates.fluid, {}, 0, [](int, double, double) { return 0.0; });
    double temperature = 0;
    for (const double part : g) temperature += part;
    const Convection<double, Set> law{rates.fluid};
    for (int q = 1; q < Set::Q; ++q) {
      const double change = Set::w(q) * law.change(0.0, law.carried(q, temperature, u[0], u[1]));
      g[q] += change;
      g[0] -= change;
    }
  });
}

}  // namespace

std::vector<std::complex<double>> flow_waves(Collision collision, double tau, const Vector2& u, const Vector2& k) {
  return waves<D2Q9>(flow_collision(collision, tau, u), k);
}

template <class Set>
std::vector<std::complex<double>> solute_waves(const SoluteParameters& parameters, const Vector2& u, const Vector2& k) {
  return waves<Set>(solute_collision<Set>(parameters, u), k);
}

template <class Set>
std::vector<std::complex<double>> heat_waves(double diffusivity, const Vector2& u, const Vector2& k) {
  return waves<Set>(heat_collision<Set>(diffusivity, u), k);
}

double flow_wave_growth(Collision collision, double tau, double speed) {
  return growth<D2Q9>(speed, [&](const Vector2& u) { return flow_collision(collision, tau, u); });
}

template <class Set>
double solute_wave_growth(const SoluteParameters& parameters, double speed) {
  return growth<Set>(speed, [&](const Vector2& u) { return solute_collision<Set>(parameters, u); });
}

template <class Set>
double heat_wave_growth(double diffusivity, double speed) {
  return growth<Set>(speed, [&](const Vector2& u) { return heat_collision<Set>(diffusivity, u); });
}

#define VUG_INSTANTIATE(Set)                                                                            \
  template std::vector<std::complex<double>> solute_waves<Set>(const SoluteParameters&, const Vector2&, \
                                                               const Vector2&);                         \
  template std::vector<std::complex<double>> heat_waves<Set>(double, const Vector2&, const Vector2&);   \
  template double solute_wave_growth<Set>(const SoluteParameters&, double);                             \
  template double heat_wave_growth<Set>(double, double)
VUG_INSTANTIATE(D2Q5);
VUG_INSTANTIATE(D2Q9);
#undef VUG_INSTANTIATE

}  // namespace vug
