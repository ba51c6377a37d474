// A state may be taken after any lattice step: what goes on from it has the bits of what never stopped, and what it was
// taken from is not disturbed.
#include "coupling/simulation.hpp"
#include "support/minerals_of_small_rock.hpp"
#include "support/rock_settings.hpp"
#include "support/run_vug.hpp"
#include "support/states.hpp"

#include <gtest/gtest.h>

#include <map>

namespace vug {
namespace {

constexpr std::int64_t last = 160;  // births at steps 55 and 135, cracks all the while
const std::vector<std::int64_t> stops{1, 17, 60, 64, 139, 151};

using test::State;
using test::state_of;

/// Everything that a run writes at this step.
std::map<std::string, std::vector<double>> results_of(const Simulation& simulation) {
  std::map<std::string, std::vector<double>> results;
  for (const HistoryValue& value : simulation.history()) results[value.name] = {value.value};
  const FieldList fields = simulation.fields();
  const auto add = [&](const std::vector<Field>& list, std::size_t items) {
    for (const Field& field : list) {
      std::vector<double>& values = results["field " + field.name];
      values.resize(items * static_cast<std::size_t>(field.components));
      field.read(values);
    }
  };
  const Parts& parts = simulation.parts();
  const Lattice& lattice = parts.geometry.lattice;
  add(fields.lattice, static_cast<std::size_t>(lattice.nx) * lattice.ny);
  add(fields.particles, parts.mechanics->particles().count);
  add(fields.bonds, parts.mechanics->bonds().count);
  return results;
}

void advance(Simulation& simulation, const Scene& scene, std::int64_t to) {
  while (simulation.clock().step < to) {
    simulation.step();
    if (simulation.clock().step % scene.accuracy.guard_interval == 0) simulation.guard();
  }
}

/// Names of what differs.
template <class Map>
std::string difference(const Map& a, const Map& b) {
  std::string names;
  for (const auto& [name, bytes] : a)
    if (!b.contains(name) || b.at(name) != bytes) names += name + "; ";
  return a.size() == b.size() ? names : names + "not the same names";
}

class RestartAnywhere : public testing::TestWithParam<std::vector<std::string>> {};

TEST_P(RestartAnywhere, GivesTheSameBits) {
  const Scene scene = read_scene(test::small_rock, GetParam());
  Simulation whole(scene), stopping(scene);
  whole.begin();
  stopping.begin();
  std::map<std::int64_t, State> saved;
  std::map<std::int64_t, std::map<std::string, std::vector<double>>> next;  // results one step after a stop
  for (const std::int64_t stop : stops) {
    advance(stopping, scene, stop);
    stopping.guard();
    saved[stop] = state_of(stopping);
    advance(whole, scene, stop + 1);
    next[stop] = results_of(whole);
  }
  advance(stopping, scene, last);
  advance(whole, scene, last);
  const State end = state_of(whole);
  const auto results = results_of(whole);
  EXPECT_EQ(difference(end, state_of(stopping)), "") << "disturbed by saving";
  for (const auto& [stop, state] : saved) {
    Simulation resumed(scene);
    test::restore(resumed, state);
    EXPECT_EQ(difference(state, state_of(resumed)), "") << "restored at step " << stop;
    advance(resumed, scene, stop + 1);
    EXPECT_EQ(difference(next[stop], results_of(resumed)), "") << "one step after step " << stop;
    advance(resumed, scene, last);
    EXPECT_EQ(difference(end, state_of(resumed)), "") << "resumed at step " << stop;
    EXPECT_EQ(difference(results, results_of(resumed)), "") << "resumed at step " << stop;
  }
}

using Set = std::vector<std::string>;
INSTANTIATE_TEST_SUITE_P(
    Choices, RestartAnywhere,
    testing::Values(
        Set{}, Set{"accuracy.precision=single"}, test::minerals_of_small_rock(),
        Set{"accuracy.flow_tolerance=0.5", "accuracy.guard_interval=10"},
        Set{"accuracy.exchange_interval=7", "accuracy.wall_interval=35", "accuracy.update_interval=20"},
        Set{"accuracy.solute_interval=3", "accuracy.heat_interval=2"},
        Set{"accuracy.precision=single", "accuracy.solute_interval=2", "accuracy.heat_interval=3", "output.flows=true"},
        Set{"accuracy.tolerance=0.1"},  // others from 128 on
        Set{"accuracy.tolerance=0.1", "accuracy.flow_tolerance=0.5", "accuracy.guard_interval=10"},
        Set{"reaction.wall=paper"}, Set{"solute.face_exchange=true"},
        Set{"accuracy.dissolution_factor=300", "accuracy.guard_interval=20"},
        // small triangles, so that there are groups of them, at rest until the cold fluid reaches them
        Set{"mechanics.rest_tolerance=1", "rock.element_size=2e-3", "mechanics.local_damping=0.8",
            "mechanics.bond.normal_strength=6e6"},
        Set{"boundary.top.traction.support=servo"},
        // weak rock that is thrown to the right and goes to pieces
        Set{"mechanics.fragments=let_go", "mechanics.bond.normal_strength=1e4", "mechanics.bond.cohesion=1e4",
            "mechanics.bond.fracture_energy_I=1e-2", "mechanics.bond.fracture_energy_II=1e-2",
            "mechanics.initial_velocity=[{ type = \"disc\", centre = [0.02, 0.014], radius = 0.005, velocity = "
            "[80, 60] }]"},
        Set{"boundary.injection.flow.pressure=[[0,1e5],[1e-4,15e6],[3.6e-4,20e6]]",
            "boundary.injection.heat.temperature=[[0,488.15],[2e-4,288.15]]",
            "boundary.injection.solute.concentration.L1=[[0,0],[1e-4,3000]]", "output.forces=true",
            "output.flows=true"},
        Set{"flow.gravity=[0,-9.81]", "flow.thermal_expansion=1e-3", "accuracy.heat_interval=3",
            "flow.viscosity_activation_energy=8000"},
        Set{"boundary.top.traction.normal_stress=[[0, 1e6], [5e-5, 9e6], [1e-4, 2e6]]",
            "boundary.right.traction={ support = \"roller\", velocity = [[0, 0, 0], [6e-5, -0.01, 0]] }"},
        Set{"damage.aperture=opening", "damage.residual_aperture=1e-4", "accuracy.flow_tolerance=0.5",
            "accuracy.guard_interval=10"},
        Set{test::several_materials, test::moving_part, test::gauges}));

}  // namespace
}  // namespace vug
