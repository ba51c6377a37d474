// Error bars where walls are staircases: diffusion around discs in a square array, whose formation factors are known.
#include "coupling/grid_convergence.hpp"

#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>
#include <vector>

namespace vug {
namespace {

/// Formation factor of insulating cylinders in a square array that fill the share f of the plane (Perrins, McKenzie and
/// McPhedran 1979, Eq. 34).
double known_factor(double f) {
  const double f4 = std::pow(f, 4), f8 = f4 * f4;
  return 1 / (1 - 2 * f / (1 + f - 0.305827 * f4 / (1 - 1.402958 * f8) - 0.013362 * f8));
}

/// One cell of the array, n x n pixels.
struct Picture {
  int n;
  std::vector<bool> rock;
  bool at(int x, int y) const { return rock[(y + n) % n * n + (x + n) % n]; }
  double share() const {
    double sum = 0;
    for (const bool r : rock) sum += r;
    return sum / (n * n);
  }
};

Picture disc(int n, double share) {
  const double square = share * n * n / std::numbers::pi;
  Picture picture{n, {}};
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const double dx = x + 0.5 - n / 2.0, dy = y + 0.5 - n / 2.0;
      picture.rock.push_back(dx * dx + dy * dy < square);
    }
  return picture;
}

/// Squares of 2 x 2 pixels, rock where half of them or more are.
Picture coarsened(const Picture& fine) {
  Picture picture{fine.n / 2, {}};
  for (int y = 0; y < fine.n; y += 2)
    for (int x = 0; x < fine.n; x += 2)
      picture.rock.push_back(fine.at(x, y) + fine.at(x + 1, y) + fine.at(x, y + 1) + fine.at(x + 1, y + 1) >= 2);
  return picture;
}

/// That of a picture, with fluxes through faces between pores: what D2Q5 has once it is steady.
double formation_factor(const Picture& picture) {
  const int n = picture.n;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd source = Eigen::VectorXd::Zero(n * n);
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const int here = y * n + x;
      entries.emplace_back(here, here, 1e-9);  // rock, and the constant that is free
      if (picture.at(x, y)) continue;
      for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}}) {
        if (picture.at(x + dx, y + dy)) continue;
        const int there = (y + dy) % n * n + (x + dx) % n;
        for (const auto& [a, b, value] :
             {std::tuple{here, here, 1.0}, {there, there, 1.0}, {here, there, -1.0}, {there, here, -1.0}})
          entries.emplace_back(a, b, value);
        source[here] += dx;
        source[there] -= dx;
      }
    }
  Eigen::SparseMatrix<double> matrix(n * n, n * n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::VectorXd potential = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(source);
  double flux = 0;  // for a gradient of 1 along x
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x)
      if (!picture.at(x, y) && !picture.at(x + 1, y)) flux += 1 + potential[y * n + (x + 1) % n] - potential[y * n + x];
  return n * n / flux;
}

TEST(StaircaseBars, HoldTheErrorOfFormationFactorsWhereTheyShowAnOrder) {
  int lines = 0, missed = 0, missed_by_the_order_of_schemes = 0;
  for (const int n : {32, 64})
    for (double share = 0.1; share < 0.68; share += 0.0113) {
      const Picture fine = disc(n, share), coarse = coarsened(fine);
      const double factor = formation_factor(fine), twin = formation_factor(coarse);
      const double coarser = formation_factor(coarsened(coarse));
      const double error = std::abs(factor - known_factor(fine.share()));
      const ErrorBar bar = error_bar(factor, twin, coarser, 2, true);
      if (!bar.order) continue;
      ++lines;
      missed += error > bar.bar;
      missed_by_the_order_of_schemes += error > error_bar(factor, twin, coarser, 2).bar;
    }
  EXPECT_GT(lines, 30);
  EXPECT_LE(missed, 0.05 * lines) << "of " << lines;
  EXPECT_GT(missed_by_the_order_of_schemes, 0.25 * lines) << "the case is no test of it";
}

}  // namespace
}  // namespace vug
