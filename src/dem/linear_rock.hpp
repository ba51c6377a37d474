#pragma once
// The rock as a linear system, for the search of static equilibrium.
#include "dem/bonds.hpp"

#include <Eigen/SparseCholesky>

#include <vector>

namespace vug {

/// (bond, point, normal or tangential) stiffness, N/m.
using StiffnessField = Kokkos::View<double* [2][2], Kokkos::LayoutLeft>;

/// The rock as a linear system in the free displacements and rotations of its particles, with the bonds as springs at
/// their two points.
class LinearRock {
 public:
  LinearRock(const Particles& particles, const Bonds& bonds);

  int rows() const { return rows_; }
  /// Row of component c (x, y, rotation) of particle i; -1 where it is held.
  int row(int i, int c) const { return row_[at(i, c)]; }

  /// Factorises the matrix of these stiffnesses; false when some motion meets no resistance.
  bool factorise(const OnHost<StiffnessField>& stiffness);

  /// Displacements and rotations that the forces and torques `force` (row) cause.
  Eigen::VectorXd solve(const Eigen::VectorXd& force) const { return factors_.solve(force); }

 private:
  /// Index of component c of the i-th of several particles or ends.
  static std::size_t at(int i, int c) { return 3 * static_cast<std::size_t>(i) + static_cast<std::size_t>(c); }
  /// Adds k g g^T, where g is the change of the opening along n (c = 0) or t (c = 1) by the motion of the two ends.
  void add_spring(std::vector<Eigen::Triplet<double>>& entries, int k, int s, int c, double stiffness) const;

  OnHost<decltype(Bonds::pair)> pair_;
  OnHost<VectorField<double>> normal_;
  OnHost<decltype(Bonds::arm)> arm_;
  std::vector<int> row_;
  int rows_ = 0;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors_;
};

}  // namespace vug
