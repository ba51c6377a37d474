#pragma once
// A case in memory: run it, read what it offers.
#include "coupling/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace vug::test {

/// Runs a case given as text.
class CoupledRun {
 public:
  explicit CoupledRun(const Scene& scene) : scene_(scene), simulation_(scene_) { simulation_.begin(); }
  explicit CoupledRun(const std::string& text, const std::vector<std::string>& overrides = {})
      : CoupledRun(parse_scene(text, "case.toml", overrides)) {}
  void steps(int count) {
    for (int step = 0; step < count; ++step) simulation_.step();
    simulation_.guard();
  }
  /// A field over the nodes, row by row.
  std::vector<double> nodes(const std::string& name) const {
    return read(simulation_.fields().lattice, name, static_cast<std::size_t>(scene_.lattice.nx) * scene_.lattice.ny);
  }
  /// A number of history.csv.
  double now(const std::string& name) const {
    for (const HistoryValue& value : simulation_.history())
      if (value.name == name) return value.value;
    throw std::invalid_argument("no column " + name);
  }
  /// A gain of a balance so far.
  double gain(const std::string& quantity, const std::string& name) const {
    for (const Balance& balance : simulation_.ledger().balances)
      for (const Balance::Term& term : balance.gains)
        if (balance.quantity == quantity && term.name == name) return term.value;
    throw std::invalid_argument("no gain " + name + " of " + quantity);
  }
  /// Largest relative error of any balance.
  double worst_balance() const {
    double worst = 0;
    for (const Balance& balance : simulation_.ledger().balances)
      worst = std::max(worst, std::abs(balance.relative_error()));
    return worst;
  }
  const Scene& scene() const { return scene_; }
  const Parts& parts() const { return simulation_.parts(); }
  const Mechanics& rock() const { return *simulation_.parts().mechanics; }

 private:
  static std::vector<double> read(const std::vector<Field>& fields, const std::string& name, std::size_t items) {
    for (const Field& field : fields) {
      if (field.name != name) continue;
      std::vector<double> values(items * static_cast<std::size_t>(field.components));
      field.read(values);
      return values;
    }
    throw std::invalid_argument("no field " + name);
  }

  Scene scene_;
  Simulation simulation_;
};

}  // namespace vug::test
