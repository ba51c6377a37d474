// A module is there only when the case has its table, and a step stays on the device: counted by Kokkos itself.
#include "coupling/simulation.hpp"
#include "support/minerals_of_small_rock.hpp"
#include "support/overheard.hpp"
#include "support/run_vug.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <set>

namespace vug {
namespace {

/// Labels of everything that Kokkos launched, allocated or copied while one exists.
class Watch {
 public:
  Watch() {
    watching_ = this;
    using namespace Kokkos::Tools::Experimental;
    set_begin_parallel_for_callback(launched);
    set_begin_parallel_reduce_callback(launched);
    set_begin_parallel_scan_callback(launched);
    set_allocate_data_callback([](Kokkos::Profiling::SpaceHandle, const char* label, const void*, std::uint64_t size) {
      if (size > 0) watching_->allocations.insert(label);
    });
    set_begin_deep_copy_callback([](Kokkos::Profiling::SpaceHandle there, const char* to, const void* target,
                                    Kokkos::Profiling::SpaceHandle here, const char* from, const void* source,
                                    std::uint64_t size) {
      watching_->copies.insert(std::string(from) + " -> " + to);
      watching_->overheard_.copied(there, to, target, here, from, source, size);
    });
  }

  /// Whether any kernel or allocation carries this part in its label.
  bool saw(const std::string& part) const {
    for (const auto* labels : {&kernels, &allocations})
      for (const std::string& label : *labels)
        if (label.find(part) != std::string::npos) return true;
    return false;
  }

  std::multiset<std::string> kernels, allocations, copies;

 private:
  static void launched(const char* label, std::uint32_t device, std::uint64_t* id) {
    watching_->kernels.insert(label);
    watching_->overheard_.launched(label, device, id);
  }
  test::Overheard overheard_;
  inline static Watch* watching_ = nullptr;
};

/// The small rock without some of its tables.
Scene scene_without(const std::set<std::string>& tables) {
  Scene scene = parse_scene(test::contents(test::small_rock), "small_rock.toml");
  if (tables.count("flow")) scene.flow.reset();
  if (tables.count("heat")) scene.heat.reset();
  if (tables.count("solute")) scene.solute.reset();
  if (tables.count("reaction")) scene.reaction.reset();
  if (tables.count("mechanics")) scene.mechanics.reset();
  if (tables.count("damage")) scene.damage.reset();
  return scene;
}

/// Builds and steps a scene under watch.
void live(const Scene& scene) {
  Simulation simulation(scene);
  simulation.begin();
  for (int step = 0; step < 20; ++step) simulation.step();
}

struct Absence {
  std::set<std::string> tables;
  std::vector<std::string> labels;  ///< parts of labels that must not appear
};

void PrintTo(const Absence& absence, std::ostream* out) {
  *out << "without";
  for (const std::string& table : absence.tables) *out << ' ' << table;
}

class AbsentModule : public testing::TestWithParam<Absence> {};

TEST_P(AbsentModule, AllocatesNothingAndLaunchesNothing) {
  const Watch watch;
  live(scene_without(GetParam().tables));
  for (const std::string& label : GetParam().labels) EXPECT_FALSE(watch.saw(label)) << label;
}

INSTANTIATE_TEST_SUITE_P(
    Tables, AbsentModule,
    testing::Values(
        Absence{{"heat"}, {"vug::heat", "vug::thermal_exchange"}},
        Absence{{"mechanics", "damage"},
                {"vug::dem", "vug::mechanics", "vug::momentum_exchange", "vug::wet_nodes", "vug::pathways"}},
        Absence{{"solute", "reaction"},
                {"vug::solute", "vug::reaction", "vug::reactive_wall", "vug::dissolution", "vug::chemical_damage",
                 "vug::surface_normal"}},
        Absence{{"reaction"}, {"vug::reaction", "vug::reactive_wall", "vug::dissolution", "vug::chemical_damage"}},
        Absence{{"flow", "damage"},
                {"vug::flow", "vug::open_boundary", "vug::momentum_exchange", "vug::advective_form"}},
        Absence{{"damage"}, {"vug::pathways"}}));

TEST(AbsentOpenings, AllocateNothingAndLaunchNothing) {
  const Watch watch;
  live(scene_without({}));
  for (const char* label : {"vug::opening", "vug::heat::fill_opening"}) EXPECT_FALSE(watch.saw(label)) << label;
}

TEST(AbsentKeys, AllocateNothingAndLaunchNothing) {
  const Watch watch;
  live(scene_without({}));
  for (const char* label :
       {"vug::thermal_flow", "vug::flow::spread", "vug::heat::fluid_theta", "vug::surfaces", "vug::link_populations",
        "vug::velocity_profile", "vug::dem::timed", "vug::dem::gauge", "vug::rock_gauges", "vug::dem::mean_stress",
        "vug::dem::triangle_stress", "vug::dem::relative_expansion"})
    EXPECT_FALSE(watch.saw(label)) << label;
}

TEST(AbsentDissolution, OfRockThatOnlyReactsAllocatesNothingAndBooksNoSolid) {
  const Watch watch;
  Simulation simulation(parse_scene(test::contents(test::small_rock), "small_rock.toml", {"reaction.molar_volume=0"}));
  simulation.begin();
  for (int step = 0; step < 20; ++step) simulation.step();
  EXPECT_FALSE(watch.saw("vug::chemical_damage"));
  for (const Balance& balance : simulation.ledger().balances) EXPECT_NE(balance.quantity, "solid_volume");
  for (const HistoryValue& value : simulation.history()) EXPECT_NE(value.name, "triangles_dissolved_1");
}

TEST(AbsentMinerals, AllocateNothingAndLaunchNothing) {
  const Watch watch;
  live(scene_without({}));
  for (const char* label : {"mineral", "vug::heat::matter", "vug::heat::capacity"})
    EXPECT_FALSE(watch.saw(label)) << label;
}

TEST(PresentMinerals, AreSeenByTheSameWatchAndStayOnTheDevice) {
  std::optional<Watch> setup(std::in_place);
  Simulation simulation(
      parse_scene(test::contents(test::small_rock), "small_rock.toml", test::minerals_of_small_rock()));
  for (const char* label : {"vug::minerals::of_node", "vug::reactive_wall::mineral"})
    EXPECT_TRUE(setup->saw(label)) << label;
  setup.reset();
  simulation.begin();
  for (int step = 0; step < 10; ++step) simulation.step();
  const Watch watch;
  for (int step = 0; step < 9; ++step) simulation.step();  // up to the next update of the pores
  EXPECT_TRUE(watch.allocations.empty()) << *watch.allocations.begin();
  EXPECT_TRUE(watch.copies.empty()) << *watch.copies.begin();
}

TEST(PresentKeys, AreSeenByTheSameWatchAndStayOnTheDevice) {
  Simulation simulation(
      parse_scene(test::contents(test::small_rock), "small_rock.toml",
                  {"flow.gravity=[0,-9.81]", "flow.thermal_expansion=1e-3", "flow.viscosity_activation_energy=8000",
                   "output.forces=true", "output.flows=true", "boundary.injection.flow.pressure=[[0,1e5],[1e-4,20e6]]",
                   "boundary.injection.heat.temperature=[[0,400],[1e-4,288]]"}));
  simulation.begin();
  for (int step = 0; step < 10; ++step) simulation.step();
  const Watch watch;
  for (int step = 0; step < 9; ++step) simulation.step();  // up to the next update of the pores
  EXPECT_TRUE(watch.saw("vug::thermal_flow::temperatures"));
  EXPECT_TRUE(watch.saw("vug::thermal_flow::viscosities"));
  EXPECT_FALSE(watch.saw("vug::link_populations")) << "of a row of the history only";
  EXPECT_TRUE(watch.allocations.empty()) << *watch.allocations.begin();
  EXPECT_TRUE(watch.copies.empty()) << *watch.copies.begin();
}

TEST(PresentOpenings, AreSeenByTheSameWatchAndStayOnTheDevice) {
  std::optional<Watch> setup(std::in_place);
  Simulation simulation(read_scene(VUG_SOURCE_DIR "/tests/cases/coupled/well.toml"));
  EXPECT_TRUE(setup->saw("vug::opening"));
  setup.reset();
  simulation.begin();
  for (int step = 0; step < 5; ++step) simulation.step();
  const Watch watch;
  for (int step = 0; step < 4; ++step) simulation.step();  // up to the next update of the pores
  EXPECT_TRUE(watch.saw("vug::heat::fill_opening"));
  EXPECT_TRUE(watch.allocations.empty()) << *watch.allocations.begin();
  EXPECT_TRUE(watch.copies.empty()) << *watch.copies.begin();
}

TEST(PresentModules, AreSeenByTheSameWatch) {
  const Watch watch;
  live(scene_without({}));
  for (const char* label : {"vug::heat", "vug::dem", "vug::solute", "vug::reactive_wall", "vug::flow", "vug::pathways",
                            "vug::momentum_exchange", "vug::chemical_damage", "vug::advective_form"})
    EXPECT_TRUE(watch.saw(label)) << label;
}

TEST(LatticeStep, LaunchesOnlyNamedKernelsAndCopiesAndAllocatesNothing) {
  Simulation simulation(scene_without({}));
  simulation.begin();
  for (int step = 0; step < 10; ++step) simulation.step();
  const Watch watch;
  for (int step = 0; step < 9; ++step) simulation.step();  // up to the next update of the pores
  EXPECT_GT(watch.kernels.size(), 50u);
  for (const std::string& label : watch.kernels) EXPECT_EQ(label.rfind("vug::", 0), 0u) << label;
  EXPECT_TRUE(watch.allocations.empty()) << *watch.allocations.begin();
  EXPECT_TRUE(watch.copies.empty()) << *watch.copies.begin();
}

}  // namespace
}  // namespace vug
