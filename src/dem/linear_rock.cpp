#include "dem/linear_rock.hpp"

#include <array>

namespace vug {

namespace {

constexpr double least_pivot = 1e-12;  // over the largest; smaller ones mean rigid motion that nothing holds

}  // namespace

LinearRock::LinearRock(const Particles& particles, const Bonds& bonds)
    : pair_(on_host(bonds.pair)),
      normal_(on_host(bonds.normal)),
      arm_(on_host(bonds.arm)),
      row_(at(particles.count, 0), -1) {
  const auto held = on_host(particles.held);
  for (int i = 0; i < particles.count; ++i)
    for (int c = 0; c < 3; ++c)
      if (!(held(i) & 1 << c)) row_[at(i, c)] = rows_++;
}

bool LinearRock::factorise(const OnHost<StiffnessField>& stiffness) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(pair_.extent_int(0)) * 144);
  for (int k = 0; k < pair_.extent_int(0); ++k)
    for (int s = 0; s < 2; ++s)
      for (int c = 0; c < 2; ++c) add_spring(entries, k, s, c, stiffness(k, s, c));
  Eigen::SparseMatrix<double> matrix(rows_, rows_);
  matrix.setFromTriplets(entries.begin(), entries.end());
  factors_.compute(matrix);
  if (factors_.info() != Eigen::Success) return false;
  const Eigen::VectorXd pivots = factors_.vectorD();
  return pivots.minCoeff() > least_pivot * pivots.maxCoeff();
}

void LinearRock::add_spring(std::vector<Eigen::Triplet<double>>& entries, int k, int s, int c, double stiffness) const {
  if (stiffness == 0) return;
  const Vec2 n{normal_(k, 0), normal_(k, 1)}, along = c == 0 ? n : Vec2{-n.y, n.x};
  std::array<int, 6> row;
  std::array<double, 6> g;
  for (int end = 0; end < 2; ++end) {
    const double sign = end == 0 ? -1 : 1;
    const Vec2 arm{arm_(k, s, end, 0), arm_(k, s, end, 1)};
    const std::array<double, 3> change{along.x, along.y, cross(arm, along)};
    for (int j = 0; j < 3; ++j) {
      row[at(end, j)] = this->row(pair_(k, end), j);
      g[at(end, j)] = sign * change[j];
    }
  }
  for (std::size_t a = 0; a < 6; ++a)
    for (std::size_t b = 0; b < 6; ++b)
      if (row[a] >= 0 && row[b] >= 0) entries.emplace_back(row[a], row[b], stiffness * g[a] * g[b]);
}

}  // namespace vug
