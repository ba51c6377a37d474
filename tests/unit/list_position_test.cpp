// A node has the same bits at any place in the list of fluid nodes, in the vector part of a loop or in its remainder:
// so lists may be cut, moved and grown without a trace.
#include "kernels/flow/flow.hpp"
#include "kernels/scalar/advective_form.hpp"
#include "kernels/solute/solute.hpp"
#include "support/advance.hpp"
#include "support/flow_setup.hpp"
#include "support/host_copy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

namespace vug {
namespace {

using test::host_copy;

/// A flow and a solute that it carries, over a list whose nodes stand `shift` places further on than row by row.
template <class T>
struct Shifted {
  static constexpr int nx = 45, ny = 31, steps = 7;
  test::Flow<T> flow;
  SoluteFields<T> solute;
  ScalarField<T> defect;

  Shifted(int shift, Collision collision)
      : flow(Lattice(nx, ny), test::shape(Lattice(nx, ny), [](int x, int y) { return (x * x + 3 * y) % 5 == 0; }),
             {true, true}, collision, 0.62) {
    if (shift > 0) rotate(shift);
    flow.set([](int x, int y) {
      return Macroscopic<double>{0.01 * std::sin(x + 0.3 * y), 0.02 * std::cos(0.7 * x), 0.015 * std::sin(1.3 * y)};
    });
    flow.step.body_force = {T(1e-4), T(-3e-5)};
    if (collision == Collision::bgk) warm();
    solute = make_solute_fields<D2Q9, T>(flow.exec, flow.nodes, 1.0);
    defect = ScalarField<T>("defect", flow.nodes.capacity);
    const ScalarField<double> correction("correction", block_count(flow.nodes.capacity));
    for (int t = 0; t < steps; ++t) {
      advective_defect<D2Q9>(flow.exec, flow.nodes, flow.fields.u, defect);
      flow.sweep();
      advance_solute<D2Q9>(flow.exec, flow.nodes, solute_parameters(0.013), flow.fields.u, defect, solute, correction);
    }
  }

  /// (dense node) velocity and concentration.
  std::vector<T> values() const {
    const auto node = host_copy(flow.nodes.node);
    const auto u = host_copy(flow.fields.u);
    const auto C = host_copy(solute.C);
    std::vector<T> all(3 * flow.lattice.size(), T(0));
    for (int i = 0; i < flow.nodes.count; ++i) {
      all[3 * node(i)] = u(i, 0);
      all[3 * node(i) + 1] = u(i, 1);
      all[3 * node(i) + 2] = C(i);
    }
    return all;
  }

 private:
  /// A temperature, which drives the flow and sets its viscosity, and a limit of the speed that some nodes reach.
  void warm() {
    flow.step.theta = ScalarField<T>("theta", flow.nodes.capacity);
    flow.step.spread = ScalarField<T>("spread", flow.nodes.capacity);
    flow.step.buoyancy = {T(2e-4), T(7e-5)};
    flow.step.speed_limit = T(0.02);
    const auto node = host_copy(flow.nodes.node);
    const auto theta = Kokkos::create_mirror_view(flow.step.theta),
               spread = Kokkos::create_mirror_view(flow.step.spread);
    for (int i = 0; i < flow.nodes.count; ++i) {
      theta(i) = T(std::sin(0.37 * node(i)));
      spread(i) = T(0.1 + 0.05 * std::cos(0.11 * node(i)));
    }
    Kokkos::deep_copy(flow.step.theta, theta);
    Kokkos::deep_copy(flow.step.spread, spread);
  }
  void rotate(int shift) {
    const auto node = host_copy(flow.nodes.node);
    std::vector<int> order(node.data(), node.data() + flow.nodes.count);
    std::rotate(order.begin(), order.end() - shift, order.end());
    IndexList list("list", order.size());
    const auto host = Kokkos::create_mirror_view(list);
    std::copy(order.begin(), order.end(), host.data());
    Kokkos::deep_copy(list, host);
    set_fluid_nodes(flow.exec, list, flow.nodes.capacity, flow.nodes);
  }
};

template <class T>
class ListPosition : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(ListPosition, Precisions);

TYPED_TEST(ListPosition, ChangesNoBitsOfFlowAndSolute) {
  for (const Collision collision : {Collision::trt, Collision::lallemand_luo, Collision::regularised, Collision::bgk}) {
    const std::vector<TypeParam> before = Shifted<TypeParam>(0, collision).values();
    EXPECT_GT(*std::max_element(before.begin(), before.end()), 1.0) << "nothing has moved";
    for (const int shift : {1, 3, 8, 13, 501}) {
      const std::vector<TypeParam> after = Shifted<TypeParam>(shift, collision).values();
      ASSERT_EQ(before.size(), after.size());
      EXPECT_EQ(std::memcmp(before.data(), after.data(), before.size() * sizeof(TypeParam)), 0) << "shift " << shift;
    }
  }
}

}  // namespace
}  // namespace vug
