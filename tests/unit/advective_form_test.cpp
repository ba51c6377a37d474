// What the advective form of a scalar's equation creates.
#include "kernels/scalar/advective_form.hpp"

#include "support/flow_setup.hpp"
#include "support/host_copy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace vug {
namespace {

using test::draw;

/// The defect of twelve nodes with velocities of some 0.02 in a closed domain, of `steps` steps of the flow.
template <class Set, class T>
std::vector<T> defect_of_closed_domain(int steps = 1) {
  const Lattice lattice(4, 4);
  const FluidNodes nodes = make_fluid_nodes(Exec{}, lattice, draw(lattice, {"....", ".##.", "..#.", "...."}));
  VectorField<T> u("u", nodes.capacity);
  test::edit(u, [&](const auto& host) {
    for (int i = 0; i < nodes.count; ++i) {
      host(i, 0) = T(0.01 * (i % 5) - 0.02);
      host(i, 1) = T(0.015 * (i % 3) - 0.01);
    }
  });
  ScalarField<T> e("e", nodes.capacity);
  advective_defect<Set>(Exec{}, nodes, Displacement<T>(u, steps), e);
  const auto host = test::host_copy(e);
  return {host.data(), host.data() + nodes.count};
}

/// Not only to the digits that numbers near one have.
template <class Set, class T>
void expect_no_sum() {
  const std::vector<T> e = defect_of_closed_domain<Set, T>();
  const double sum = std::accumulate(e.begin(), e.end(), 0.0), eps = std::numeric_limits<T>::epsilon();
  EXPECT_LT(std::abs(sum), 0.1 * eps) << "in units of the last digit of one: " << sum / eps;
  EXPECT_GT(*std::max_element(e.begin(), e.end()), 1e-3);
}

TEST(AdvectiveDefect, SumsToZeroOverAClosedDomain) {
  expect_no_sum<D2Q5, double>();
  expect_no_sum<D2Q5, float>();
  expect_no_sum<D2Q9, double>();
  expect_no_sum<D2Q9, float>();
}

TEST(AdvectiveDefect, IsThriceThatOfOneStepWhereAScalarTakesThree) {
  const std::vector<double> once = defect_of_closed_domain<D2Q5, double>(),
                            thrice = defect_of_closed_domain<D2Q5, double>(3);
  for (std::size_t i = 0; i < once.size(); ++i) EXPECT_NEAR(thrice[i], 3 * once[i], 1e-15);
}

}  // namespace
}  // namespace vug
