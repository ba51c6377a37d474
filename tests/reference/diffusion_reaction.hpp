#pragma once
// The exact field of the paper's first validation (Eq. 28): diffusion in a rectangle L x H with a given concentration
// at x = 0, a first-order reaction at y = H and no flux through the other two sides.
#include <cmath>
#include <numbers>
#include <vector>

namespace vug::reference {

/// Roots beta_n H of z tan z = Da, n = 0..count-1; the n-th lies in (n pi, (n + 1/2) pi).
inline std::vector<double> robin_roots(double Da, int count) {
  std::vector<double> roots(count);
  for (int n = 0; n < count; ++n) {
    double low = n * std::numbers::pi, high = low + std::numbers::pi / 2;
    // z sin z - Da cos z has no pole and one sign change in the interval
    const double sign = n % 2 == 0 ? 1 : -1;
    for (int k = 0; k < 200 && high - low > 1e-16 * high; ++k) {
      const double z = 0.5 * (low + high);
      (sign * (z * std::sin(z) - Da * std::cos(z)) < 0 ? low : high) = z;
    }
    roots[n] = 0.5 * (low + high);
  }
  return roots;
}

/// Psi of Eq. 28 on the tensor product of points xs, ys; psi[j * xs.size() + i]. Near the corner (0, H), where the data
/// jump, the series needs some 3000 terms.
inline std::vector<double> diffusion_reaction_psi(const std::vector<double>& xs, const std::vector<double>& ys,
                                                  double L, double H, double Da, int terms = 4000) {
  std::vector<double> psi(xs.size() * ys.size(), 0);
  std::vector<double> along_x(xs.size());
  const std::vector<double> roots = robin_roots(Da, terms);
  for (int n = terms - 1; n >= 0; --n) {
    const double z = roots[n], beta = z / H;
    const double norm2 = 0.5 * H * (1 + std::sin(2 * z) / (2 * z));
    const double amplitude = std::sin(z) / (norm2 * beta);
    // cosh(beta (x - L))/cosh(beta L) without overflow
    for (std::size_t i = 0; i < xs.size(); ++i)
      along_x[i] =
          amplitude * (std::exp(-beta * xs[i]) + std::exp(-beta * (2 * L - xs[i]))) / (1 + std::exp(-2 * beta * L));
    for (std::size_t j = 0; j < ys.size(); ++j) {
      const double across = std::cos(beta * ys[j]);
      for (std::size_t i = 0; i < xs.size(); ++i) psi[j * xs.size() + i] += across * along_x[i];
    }
  }
  return psi;
}

/// What the reaction takes between x = 0 and x = to, over D C_in: the integral of -dPsi/dy at y = H.
inline double diffusion_reaction_wall_flux(double to, double L, double H, double Da, int terms = 4000) {
  double flux = 0;
  const std::vector<double> roots = robin_roots(Da, terms);
  for (int n = terms - 1; n >= 0; --n) {
    const double z = roots[n], beta = z / H;
    const double norm2 = 0.5 * H * (1 + std::sin(2 * z) / (2 * z));
    // integral of cosh(beta (x - L)) / cosh(beta L) over [0, to], times beta
    const double length = (std::sinh(beta * L) - std::sinh(beta * (L - to))) / std::cosh(beta * L);
    const double tail = (1 - std::exp(-2 * beta * L) - std::exp(-beta * to) + std::exp(-beta * (2 * L - to))) /
                        (1 + std::exp(-2 * beta * L));
    flux += std::sin(z) * std::sin(z) / (norm2 * beta) * (beta * L < 300 ? length : tail);
  }
  return flux;
}

}  // namespace vug::reference
