// The lid-driven cavity: steady recirculation against published extremes of its centre lines.
#include "support/dress_one.hpp"
#include "support/flow_setup.hpp"
#include "support/host_copy.hpp"
#include "support/record.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace vug {
namespace {

using test::Flow;
using test::record;

struct Extremes {
  double u_min, v_max, v_min;  ///< of u along x = 1/2 and of v along y = 1/2, over the speed of the lid
};

// Spectral and Richardson-extrapolated values of Botella and Peyret, Comput. Fluids 27 (1998) 421, and of Marchi, Suero
// and Araki, J. Braz. Soc. Mech. Sci. Eng. 31 (2009) 186.
constexpr Extremes converged_100{-0.2140424, 0.1795728, -0.2538030};
constexpr Extremes converged_1000{-0.3885698, 0.3769447, -0.5270771};
// The table of Ghia, Ghia and Shin, J. Comput. Phys. 48 (1982) 387, on 129 x 129 nodes, is 1.5 to 3.4 % short of these:
// what converges cannot agree with it to 1 %, only to its own error.
constexpr Extremes ghia_100{-0.21090, 0.17527, -0.24533};
constexpr Extremes ghia_1000{-0.38289, 0.37095, -0.51550};

/// Extreme of value(k), k = 0..n-1, of the given sign, on the parabola through the largest and its neighbours.
template <class Value>
double extreme(int n, double sign, const Value& value) {
  int best = 1;
  for (int k = 1; k < n - 1; ++k)
    if (sign * value(k) > sign * value(best)) best = k;
  const double left = value(best - 1), centre = value(best), right = value(best + 1);
  return centre - (left - right) * (left - right) / (8 * (left - 2 * centre + right));
}

/// The steady cavity of n x n nodes after `turnovers` times n/U.
Extremes cavity(int n, double reynolds, double speed, double turnovers) {
  Flow<double> flow(n, n, {false, false}, Collision::trt, 0.5 + 3 * speed * n / reynolds);
  const BoundaryLinks lid = flow.side(Side::top);
  const int steps = static_cast<int>(turnovers * n / speed);
  for (int t = 0; t < steps; ++t) {
    dress_velocity(flow.exec, flow.nodes, lid, {speed, 0}, flow.fields, flow.gain);
    flow.sweep();
  }
  const auto u = test::host_copy(flow.fields.u);
  const auto on_centre_line = [&](int along, int axis) {  // n is even: the line runs between two rows of nodes
    const auto index = [&](int across) { return axis == 0 ? along * n + across : across * n + along; };
    return (u(index(n / 2 - 1), axis) + u(index(n / 2), axis)) / (2 * speed);
  };
  for (int k = 0; k < n; k += n / 64) {
    const double at = (k + 0.5) / n;
    record("flow_cavity_profile",
           {{"reynolds", reynolds}, {"n", n}, {"at", at}, {"u", on_centre_line(k, 0)}, {"v", on_centre_line(k, 1)}});
  }
  return {extreme(n, -1, [&](int y) { return on_centre_line(y, 0); }),
          extreme(n, +1, [&](int x) { return on_centre_line(x, 1); }),
          extreme(n, -1, [&](int x) { return on_centre_line(x, 1); })};
}

void record_extremes(int n, double reynolds, const Extremes& found, const Extremes& converged, const Extremes& ghia) {
  const auto row = [&](const char* name, double measured, double exact, double table) {
    record("flow_cavity", {{"reynolds", reynolds},
                           {"n", n},
                           {"name", name},
                           {"measured", measured},
                           {"converged", exact},
                           {"ghia", table}});
  };
  row("u_min", found.u_min, converged.u_min, ghia.u_min);
  row("v_max", found.v_max, converged.v_max, ghia.v_max);
  row("v_min", found.v_min, converged.v_min, ghia.v_min);
}

void expect_within(const Extremes& found, const Extremes& reference, double tolerance) {
  EXPECT_NEAR(found.u_min / reference.u_min, 1, tolerance);
  EXPECT_NEAR(found.v_max / reference.v_max, 1, tolerance);
  EXPECT_NEAR(found.v_min / reference.v_min, 1, tolerance);
}

TEST(LidCavity, Reynolds100) {
  const Extremes found = cavity(64, 100, 0.1, 20);
  record_extremes(64, 100, found, converged_100, ghia_100);
  expect_within(found, converged_100, 0.005);  // (1/64)^2 times a coefficient of order 10; measured 0.2 to 0.3 %
  expect_within(found, ghia_100, 0.035);       // the table's own error
}

TEST(LidCavityLong, Reynolds100OnTheTablesGrid) {
  const Extremes found = cavity(128, 100, 0.1, 20);
  record_extremes(128, 100, found, converged_100, ghia_100);
  expect_within(found, converged_100, 0.002);
  expect_within(found, ghia_100, 0.035);
}

TEST(LidCavity, Reynolds1000) {
  const Extremes found = cavity(128, 1000, 0.2, 120);
  record_extremes(128, 1000, found, converged_1000, ghia_1000);
  expect_within(found, converged_1000, 0.008);  // measured 0.4 to 0.5 %
  expect_within(found, ghia_1000, 0.025);
}

}  // namespace
}  // namespace vug
