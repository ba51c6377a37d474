#pragma once
// A run with what it reports of its state.
#include "coupling/events.hpp"
#include "coupling/simulation.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace vug::test {

/// Seven cells of fluid on three of rock, which acid dissolves.
inline const std::string slab_in_acid = R"(
[lattice]
size = [20e-6, 10e-6]
spacing = 1e-6
time_step = 1e-4
[time]
steps = 5000
[geometry]
type = "shapes"
[[geometry.shapes]]
type = "rectangle"
from = [0, 0]
to = [20e-6, 3e-6]
[solute]
[[solute.species]]
name = "H"
diffusivity = 1e-9
initial = 3000
[reaction]
reactant = "H"
rate_constant = 1e-4
molar_volume = 4e-5
[boundary.top]
solute = { type = "concentration", concentration = { H = 3000 } }
)";

/// A run with the events that it reports at its guards.
class Watched {
 public:
  explicit Watched(const std::string& text, const std::vector<std::string>& overrides = {})
      : scene_(parse_scene(text, "case.toml", overrides)), simulation_(scene_) {
    simulation_.begin();
    events_.emplace(simulation_, std::vector<std::string>{}, Events::runs_backwards(scene_));
  }
  /// New events after so many steps, with a guard every hundred.
  std::vector<std::string> steps(int count) {
    std::vector<std::string> news;
    for (int step = 1; step <= count; ++step) {
      simulation_.step();
      if (step % 100 != 0 && step != count) continue;
      simulation_.guard();
      for (const std::string& line : events_->look(simulation_))
        if (line.find("warning: ") != std::string::npos) news.push_back(line);
    }
    return news;
  }
  /// So many steps without a look at events.
  void pass(int count) {
    for (int step = 0; step < count; ++step) simulation_.step();
  }
  std::vector<std::string> row() { return events_->look_at_row(simulation_, simulation_.history()); }
  const Simulation& simulation() const { return simulation_; }
  double now(const std::string& column) const {
    for (const HistoryValue& value : simulation_.history())
      if (value.name == column) return value.value;
    return 0;
  }
  double most(const std::string& field, std::size_t nodes) const {
    for (const Field& given : simulation_.fields().lattice) {
      if (given.name != field) continue;
      std::vector<double> values(nodes);
      given.read(values);
      return *std::max_element(values.begin(), values.end());
    }
    return 0;
  }

 private:
  Scene scene_;
  Simulation simulation_;
  std::optional<Events> events_;
};

}  // namespace vug::test
