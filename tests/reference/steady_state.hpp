#pragma once
// Steady states of linear lattice schemes in a fraction of the steps: reduced-rank extrapolation of snapshots. A step
// is an affine map, so any combination of states with weights that sum to one is a legitimate new start; what counts is
// the change per step at the end, which the caller checks.
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace vug::reference {

using State = std::vector<double>;

inline double dot(const State& a, const State& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

inline void add(State& a, double factor, const State& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += factor * b[i];
}

/// Extrapolates from snapshots taken every so many steps, in order of time: with changes u_j and second differences
/// w_j, x_0 + sum xi_j u_j where xi minimises |u_0 + sum xi_j w_j| (Gram-Schmidt).
inline State extrapolate(const std::vector<State>& snapshots) {
  std::vector<State> change, second;
  for (std::size_t j = 0; j + 1 < snapshots.size(); ++j) {
    change.push_back(snapshots[j + 1]);
    add(change[j], -1, snapshots[j]);
  }
  for (std::size_t j = 0; j + 1 < change.size(); ++j) {
    second.push_back(change[j + 1]);
    add(second[j], -1, change[j]);
  }
  const std::size_t k = second.size();
  std::vector<State> basis = second;
  std::vector<std::vector<double>> r(k, std::vector<double>(k, 0));
  std::vector<double> xi(k, 0), rhs(k, 0);
  State residual = change[0];
  std::size_t rank = 0;
  for (; rank < k; ++rank) {
    const double before = std::sqrt(dot(basis[rank], basis[rank]));
    for (int sweep = 0; sweep < 2; ++sweep)
      for (std::size_t j = 0; j < rank; ++j) {
        const double c = dot(basis[j], basis[rank]);
        r[j][rank] += c;
        add(basis[rank], -c, basis[j]);
      }
    r[rank][rank] = std::sqrt(dot(basis[rank], basis[rank]));
    if (r[rank][rank] <= 1e-10 * before || before == 0) break;
    for (double& b : basis[rank]) b /= r[rank][rank];
    rhs[rank] = -dot(basis[rank], residual);
    add(residual, rhs[rank], basis[rank]);
  }
  for (std::size_t i = rank; i-- > 0;) {
    xi[i] = rhs[i];
    for (std::size_t j = i + 1; j < rank; ++j) xi[i] -= r[i][j] * xi[j];
    xi[i] /= r[i][i];
  }
  State result = snapshots[0];
  for (std::size_t j = 0; j < rank; ++j) add(result, xi[j], change[j]);
  return result;
}

inline double largest_difference(const State& a, const State& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

/// Brings `state` to rest. `advance(state, steps)` advances it in place. Stops when the largest change over `interval`
/// steps is below `tolerance`; returns the last such change.
inline double find_steady_state(State& state, const std::function<void(State&, int)>& advance, int interval,
                                double tolerance, int most_cycles = 40) {
  constexpr int snapshots = 8;
  double change = 0;
  for (int cycle = 0; cycle < most_cycles; ++cycle) {
    std::vector<State> kept;
    for (int k = 0; k < snapshots; ++k) {
      const State before = state;
      advance(state, interval);
      kept.push_back(state);
      change = largest_difference(before, state);
      if (change < tolerance) return change;
    }
    state = extrapolate(kept);
  }
  return change;
}

}  // namespace vug::reference
