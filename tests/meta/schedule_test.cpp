// The schedule of `vug check --schedule` is what steps do: every field has one writer, and no module changes what the
// tasks of another write.
#include "coupling/build_modules.hpp"
#include "coupling/simulation.hpp"
#include "support/minerals_of_small_rock.hpp"
#include "support/run_vug.hpp"
#include "support/states.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <set>

namespace vug {
namespace {

test::State state_of(const Parts& parts) {
  StateList list;
  for (const auto& module : parts.modules) module->state(list);
  return test::saved(list);
}

/// Of the names that tasks write, the longest that this one begins with; empty: none.
std::string written_as(const std::string& field, const std::vector<Task>& tasks) {
  std::string found;
  for (const Task& task : tasks)
    for (const std::string& name : task.writes)
      if (field.starts_with(name) && name.size() > found.size()) found = name;
  return found;
}

struct Choice {
  std::string name;  ///< of a case in tests/cases/coupled
  std::vector<std::string> overrides;

  Scene scene() const { return read_scene(VUG_SOURCE_DIR "/tests/cases/coupled/" + name + ".toml", overrides); }
};

void PrintTo(const Choice& choice, std::ostream* out) {
  *out << choice.name << " with " << choice.overrides.size() << " overrides";
}

Choice small_rock(std::vector<std::string> overrides) {
  for (const char* interval : {"heat_interval=2", "solute_interval=2", "exchange_interval=4", "update_interval=5"})
    overrides.push_back(std::string("accuracy.") + interval);
  return {"small_rock", overrides};
}

class ScheduleOf : public testing::TestWithParam<Choice> {};

TEST_P(ScheduleOf, GivesEveryFieldOneWriter) {
  const Simulation simulation(GetParam().scene());
  const std::vector<Task> tasks = simulation.schedule();
  std::vector<std::string> written;
  for (const Task& task : tasks) written.insert(written.end(), task.writes.begin(), task.writes.end());
  for (const std::string& name : written) EXPECT_EQ(std::count(written.begin(), written.end(), name), 1) << name;
  for (const auto& [field, bytes] : state_of(simulation.parts())) EXPECT_NE(written_as(field, tasks), "") << field;
}

TEST_P(ScheduleOf, HoldsForWhatStepsChange) {
  const Exec exec;
  const Scene scene = GetParam().scene();
  const auto parts = build_modules(exec, scene, {});
  std::vector<Task> tasks;
  for (const auto& module : parts->modules) module->tasks(tasks);
  for (const auto& module : parts->modules) module->begin(exec);
  std::set<std::string> seen;
  Clock clock{0, scene.lattice.time_step};
  for (; clock.step < 12; ++clock.step)
    for (const auto& module : parts->modules) {
      std::vector<Task> own;
      module->tasks(own);
      const test::State before = state_of(*parts);
      module->step(exec, clock);
      for (const auto& [field, bytes] : state_of(*parts)) {
        if (bytes == before.at(field)) continue;
        const std::string name = written_as(field, tasks);
        const auto has = [&](const std::vector<std::string>& names) {
          return std::any_of(names.begin(), names.end(), [&](const auto& n) { return field.starts_with(n); });
        };
        const bool ours = std::any_of(own.begin(), own.end(), [&](const Task& task) {
          return std::count(task.writes.begin(), task.writes.end(), name) > 0 || has(task.takes);
        });
        EXPECT_TRUE(ours) << module->name() << " changes " << field << " in step " << clock.step;
        seen.insert(name);
      }
    }
  if (GetParam().name != "small_rock") return;
  for (const char* name : {"flow", "flow/carrier0", "heat", "reaction/link_rate", "reaction/link_acid", "solute",
                           "reaction", "mechanics", "mechanics/force", "mechanics/temperature_change"})
    EXPECT_TRUE(seen.contains(name)) << name << " has not changed: the test sees nothing of it";
}

INSTANTIATE_TEST_SUITE_P(Choices, ScheduleOf,
                         testing::Values(small_rock({}), small_rock(test::minerals_of_small_rock()),
                                         small_rock({"reaction.wall=\"paper\"", "solute.velocity_set=\"d2q9\""}),
                                         Choice{"slow_grain", {}}));

TEST(Schedule, IsPrinted) {
  const test::Outcome outcome =
      test::run_vug("check " VUG_SOURCE_DIR "/tests/cases/coupled/small_rock.toml --schedule");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  for (const char* line : {"\ntask ", "\nflow: sides, streaming and collision", "\nrock: the fluid's force",
                           "; takes reaction/link_acid", "\nnew pores"})
    EXPECT_THAT(outcome.output, testing::HasSubstr(line));
}

}  // namespace
}  // namespace vug
