// The pressure along an outflow by a team per piece, as on a GPU, against that by a thread, as on a host.
#include "kernels/flow/outflow_pressure.hpp"
#include "kernels/launch/launch_lists.hpp"
#include "kernels/nodes/opening.hpp"
#include "support/flow_setup.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace vug {

template <class Body>
struct EveryPiece {
  using Entry = FlowCondition;
  Body body;  ///< without its links
  static int count(const FlowCondition& c) { return c.pieces; }
  template <class Run>
  KOKKOS_FUNCTION void operator()(const FlowCondition& c, const Run& run) const {
    Body whole = body;
    whole.at.links = c;
    run(whole);
  }
};

/// A team per piece, of any size that there can be.
struct TeamPerPiece {
  using Team = typename Kokkos::TeamPolicy<Exec>::member_type;
  PressureAlong<double> body;
  KOKKOS_FUNCTION void operator()(const Team& team) const { body(team, team.league_rank()); }
};

namespace {

using Values = std::vector<double>;

/// Velocities made up, and the pressures along an outflow that follow from them.
class PiecesOfAnOutflow {
 public:
  PiecesOfAnOutflow(const test::Flow<double>& flow, const BoundaryLinks& links) : exec_(flow.exec), links_(links) {
    const auto u = Kokkos::create_mirror_view(flow.fields.u);
    for (int i = 0; i < flow.nodes.count; ++i) {
      u(i, 0) = 0.05 + 0.02 * std::sin(0.3 + 1.7 * i);
      u(i, 1) = 0.05 + 0.03 * std::sin(0.9 + 0.6 * i);
    }
    Kokkos::deep_copy(flow.fields.u, u);
    fit_to_links(exec_, flow.nodes, links, state_);
    condition_ = outflow_condition(links_, {}, state_, flow.gain);
    at_ = AlongPiece<double>{condition_, flow.fields.u, Upstream(flow.nodes)};
  }
  int longest() const { return state_.longest; }
  int pieces() const { return state_.pieces; }
  Values by_threads() {
    for_each_of_lists(exec_, "by_threads", all(), EveryPiece<PressureAlong<double>>{{*at_}});
    return taken();
  }
  Values by_teams() {
    for_each_team_of_lists(exec_, "by_teams", all(), threads_per_sum, EveryPiece<PressureAlong<double>>{{*at_}});
    return taken();
  }
  /// Empty where there can be no such team.
  Values by_teams_of(int threads) {
    const TeamPerPiece body{{*at_}};
    const int most = Kokkos::TeamPolicy<Exec>(exec_, pieces(), 1).team_size_max(body, Kokkos::ParallelForTag{});
    if (threads > most) return {};
    Kokkos::parallel_for("by_teams_of", Kokkos::TeamPolicy<Exec>(exec_, pieces(), threads), body);
    return taken();
  }

 private:
  std::span<const FlowCondition> all() const { return {&condition_, 1}; }
  Values taken() {
    const auto host = test::host_copy(state_.along);
    Kokkos::deep_copy(exec_, state_.along, 0.0);
    exec_.fence();
    return {host.data(), host.data() + host.extent(0)};
  }

  Exec exec_;
  BoundaryLinks links_;
  OutflowState state_;
  FlowCondition condition_;
  std::optional<AlongPiece<double>> at_;
};

/// Largest difference over the largest value.
double difference(const Values& a, const Values& b) {
  double most = 0, size = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    most = std::max(most, std::abs(a[i] - b[i]));
    size = std::max(size, std::abs(a[i]));
  }
  EXPECT_GT(size, 1e-5);
  return most / size;
}

void expect_same_bits_of_any_team(PiecesOfAnOutflow& outflow) {
  const Values expected = outflow.by_teams();
  for (const int threads : {1, 2, 3, 4, 32, 96, 128, 256})
    if (const Values values = outflow.by_teams_of(threads); !values.empty()) {
      EXPECT_EQ(values, expected) << threads;
    }
}

TEST(PressureAlongAnOutflow, HasTheBitsOfAThreadWhereItsPiecesAreShort) {
  for (const int faces : {1, 2, 31, 256}) {
    const test::Flow<double> flow(9, faces, {false, false});
    PiecesOfAnOutflow outflow(flow, flow.side(Side::right));
    EXPECT_EQ(outflow.longest(), faces);
    const Values expected = outflow.by_threads();
    EXPECT_EQ(outflow.by_teams(), expected) << faces;
    if (faces > 1) {
      EXPECT_GT(difference(expected, Values(expected.size())), 0.5);
    }
    expect_same_bits_of_any_team(outflow);
  }
}

TEST(PressureAlongAnOutflow, IsThatOfAThreadWherePiecesAreLongOrMeetTheirEnds) {
  for (const auto& [faces, joined] : {std::pair{257, false}, {1400, false}, {40, true}, {1400, true}}) {
    const test::Flow<double> flow(9, faces, {false, joined});
    PiecesOfAnOutflow outflow(flow, flow.side(Side::right));
    EXPECT_EQ(outflow.longest(), faces);
    EXPECT_LT(difference(outflow.by_threads(), outflow.by_teams()), 1e-12) << faces << " " << joined;
    expect_same_bits_of_any_team(outflow);
  }
}

TEST(PressureAlongAnOutflow, HasTheBitsOfAThreadAroundAnOpening) {
  const Lattice lattice(60, 60);
  const Kokkos::View<NodeType*> type("type", lattice.size());
  const auto host = Kokkos::create_mirror_view(type);
  Kokkos::deep_copy(host, NodeType::fluid);
  std::vector<int> inside;
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 60; ++x)
      if (std::hypot(x - 30, y - 29) < 12) {
        host(lattice.node(x, y)) = NodeType::opening;
        inside.push_back(lattice.node(x, y));
      }
  Kokkos::deep_copy(type, host);
  const test::Flow<double> flow(lattice, type, {false, false});
  const Opening opening = make_opening(lattice, inside, [](const auto&, const auto& out) { return out; });
  PiecesOfAnOutflow outflow(flow, find_opening_links(flow.exec, flow.nodes, opening, D2Q9::Q));
  EXPECT_GT(outflow.pieces(), 32);
  EXPECT_GT(outflow.longest(), 4);
  EXPECT_EQ(outflow.by_teams(), outflow.by_threads());
  expect_same_bits_of_any_team(outflow);
}

}  // namespace
}  // namespace vug
