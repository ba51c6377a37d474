#pragma once
// A case in lattice units (spacing 1 m, step 1 s, density 1) run from its text, and its fields.
#include "coupling/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace vug::test {

/// [lattice] and [time] of nx x ny cells.
inline std::string unit_lattice(int nx, int ny) {
  return fmt::format("[lattice]\nsize = [{}, {}]\nspacing = 1\ntime_step = 1\n[time]\nsteps = 1000000\n", nx, ny);
}

inline std::string rectangle(double x0, double y0, double x1, double y1, const std::string& more = "") {
  return fmt::format("[[geometry.shapes]]\ntype = \"rectangle\"\nfrom = [{}, {}]\nto = [{}, {}]\n{}\n", x0, y0, x1, y1,
                     more);
}

inline std::string disc(double x, double y, double radius, const std::string& more = "") {
  return fmt::format("[[geometry.shapes]]\ntype = \"disc\"\ncentre = [{:.17g}, {:.17g}]\nradius = {:.17g}\n{}\n", x, y,
                     radius, more);
}

class CaseRun {
 public:
  explicit CaseRun(const Scene& scene) : scene_(scene), simulation(scene_) { simulation.begin(); }
  explicit CaseRun(const std::string& text) : CaseRun(parse_scene(text, "case.toml")) {}

  void run(int steps) {
    for (int step = 0; step < steps; ++step) simulation.step();
    simulation.guard();
  }
  /// Row by row; components together.
  std::vector<double> field(const std::string& name) const {
    for (const Field& field : simulation.fields().lattice) {
      if (field.name != name) continue;
      std::vector<double> values(static_cast<std::size_t>(field.components) * nx() * ny());
      field.read(values);
      return values;
    }
    throw std::out_of_range(name);
  }
  /// A gain of a balance so far.
  double gain(const std::string& quantity, const std::string& name) const {
    for (const Balance& balance : simulation.ledger().balances)
      for (const Balance::Term& term : balance.gains)
        if (balance.quantity == quantity && term.name == name) return term.value;
    throw std::out_of_range(quantity + " " + name);
  }
  double worst_balance() const {
    double worst = 0;
    for (const Balance& balance : simulation.ledger().balances)
      worst = std::max(worst, std::abs(balance.relative_error()));
    return worst;
  }
  int nx() const { return scene_.lattice.nx; }
  int ny() const { return scene_.lattice.ny; }

 private:
  Scene scene_;

 public:
  Simulation simulation;
};

}  // namespace vug::test
