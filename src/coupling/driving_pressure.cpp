#include "coupling/driving_pressure.hpp"

#include <cmath>

namespace vug {

namespace {

/// Lattice units; that of an outflow follows the fluid, and is taken as the one at the start.
double pressure_at(const FlowBoundary& flow, double time, const LatticeUnits& units) {
  if (flow.kind != FlowBoundaryKind::pressure) return 0;
  return flow.risen(time) * units.lattice_pressure(flow.pressure.at(time));
}

void add_moments(const FlowBoundary& flow, std::vector<double>& moments) {
  moments.insert(moments.end(), flow.pressure.moments().begin(), flow.pressure.moments().end());
  if (flow.ramp_time > 0) moments.push_back(flow.ramp_time);
}

/// The values of the parabola through (0, first), (1/2, middle), (1, last) on [0, 1].
Span span_of_parabola(double first, double middle, double last) {
  Span span{std::min(first, last), std::max(first, last)};
  const double slope = 4 * middle - 3 * first - last, bend = 2 * (first - 2 * middle + last);
  const double top = bend != 0 ? -slope / (2 * bend) : 0;
  if (top <= 0 || top >= 1) return span;
  const double there = first + top * (slope + top * bend);
  return span.with({there, there});
}

}  // namespace

Span difference_over_time(const FlowBoundary& a, const FlowBoundary& b, const LatticeUnits& units) {
  std::vector<double> moments{0};
  for (const FlowBoundary* flow : {&a, &b}) add_moments(*flow, moments);
  std::sort(moments.begin(), moments.end());
  double largest = 0;
  const auto difference = [&](double time) {
    const double here = pressure_at(a, time, units), there = pressure_at(b, time, units);
    largest = std::max({largest, std::abs(here), std::abs(there)});
    return here - there;
  };
  double before = difference(moments.front());
  Span span{before, before};
  for (std::size_t k = 1; k < moments.size(); ++k) {
    if (moments[k] == moments[k - 1]) continue;
    const double middle = difference((moments[k - 1] + moments[k]) / 2), now = difference(moments[k]);
    span = span.with(span_of_parabola(before, middle, now));
    before = now;
  }
  constexpr double rounding = 1e-12;
  return {std::abs(span.low) > rounding * largest ? span.low : 0,
          std::abs(span.high) > rounding * largest ? span.high : 0};
}

}  // namespace vug
