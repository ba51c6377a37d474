#include "ranks/partition.hpp"

#include <algorithm>

namespace vug {

Partition::Partition(const std::vector<double>& weight_of_row, int parts) {
  const int rows = static_cast<int>(weight_of_row.size());
  std::vector<double> sum(rows + 1, 0.0);
  for (int y = 0; y < rows; ++y) sum[y + 1] = sum[y] + weight_of_row[y];
  first_.assign(parts + 1, 0);
  first_[parts] = rows;
  cut(sum, 0, parts);
  part_of_.resize(rows);
  double heaviest = 0;
  for (int p = 0; p < parts; ++p) {
    std::fill(part_of_.begin() + first(p), part_of_.begin() + last(p), p);
    heaviest = std::max(heaviest, sum[last(p)] - sum[first(p)]);
  }
  if (sum[rows] > 0) imbalance_ = heaviest * parts / sum[rows];
}

void Partition::cut(const std::vector<double>& sum, int part, int parts) {
  if (parts < 2) return;
  const int lower = parts / 2, begin = first_[part], end = first_[part + parts];
  const double wanted = sum[begin] + (sum[end] - sum[begin]) * lower / parts;
  const auto above = std::lower_bound(sum.begin() + begin, sum.begin() + end, wanted);
  int row = static_cast<int>(above - sum.begin());
  if (row > begin && wanted - sum[row - 1] <= sum[row] - wanted) --row;
  first_[part + lower] = row;
  cut(sum, part, lower);
  cut(sum, part + lower, parts - lower);
}

}  // namespace vug
