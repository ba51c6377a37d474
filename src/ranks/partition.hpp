#pragma once
// Which rows of the lattice each rank computes.
#include <vector>

namespace vug {

/// Divides the rows into parts of nearly the same weight; part p has the consecutive rows [first[p], first[p + 1]).
class Partition {
 public:
  Partition() = default;
  /// By bisection: the parts are halved, and the rows are cut where their weights come nearest to the same proportion.
  /// Sums of the weights must be exact (whole numbers), so that the result is the same on every rank. A part may be
  /// empty.
  Partition(const std::vector<double>& weight_of_row, int parts);

  int parts() const { return static_cast<int>(first_.size()) - 1; }
  int first(int part) const { return first_[part]; }
  int last(int part) const { return first_[part + 1]; }
  int part_of(int row) const { return part_of_[row]; }
  /// The heaviest part over the mean.
  double imbalance() const { return imbalance_; }

 private:
  void cut(const std::vector<double>& sum, int part, int parts);

  std::vector<int> first_{0, 0}, part_of_;
  double imbalance_ = 1;
};

}  // namespace vug
