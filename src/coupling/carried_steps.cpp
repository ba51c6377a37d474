#include "coupling/carried_steps.hpp"

#include "coupling/heat_module.hpp"
#include "coupling/solute_module.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug {

namespace {

std::string complaint_of(const CarriedStep& step) {
  return fmt::format("warning: accuracy.{} is too long for the speed of the fluid", step.key);
}

std::string advice_for(const CarriedStep& step, double speed) {
  const int longest = step.longest_at(speed);
  if (longest == 0) return "lower lattice.time_step";
  return fmt::format("set it to {} at most, or lower lattice.time_step", longest);
}

}  // namespace

int CarriedStep::longest_at(double speed) const {
  constexpr double rounding = 1e-9;
  return way(speed) <= longest_way ? interval : static_cast<int>(std::floor(longest_way / speed * (1 + rounding)));
}

std::vector<CarriedStep> carried_steps(const Scene& scene) {
  std::vector<CarriedStep> steps;
  const AccuracySection& accuracy = scene.accuracy;
  if (!scene.flow || accuracy.chooses_intervals()) return steps;
  if (scene.heat) steps.push_back({"heat_interval", accuracy.heat_interval, longest_way});
  if (scene.solute) steps.push_back({"solute_interval", accuracy.solute_interval, longest_way_of_solutes});
  return steps;
}

CarriedSteps::CarriedSteps(const Scene& scene, const std::vector<std::string>& earlier) : steps_(carried_steps(scene)) {
  std::erase_if(steps_, [&](const CarriedStep& step) {
    return std::any_of(earlier.begin(), earlier.end(),
                       [&](const std::string& line) { return line.find(complaint_of(step)) != std::string::npos; });
  });
}

std::vector<std::string> CarriedSteps::look_at_row(const Clock& clock, const std::vector<HistoryValue>& row) {
  std::vector<std::string> news;
  const auto mach = std::find_if(row.begin(), row.end(), [](const auto& v) { return v.name == "largest_mach_1"; });
  if (mach == row.end()) return news;
  const double speed = mach->value / std::sqrt(3.0);
  std::erase_if(steps_, [&](const CarriedStep& step) {
    if (!(step.way(speed) > step.longest_way)) return false;
    news.push_back(fmt::format("step {}, {:.4g} s: {}: {} lattice steps carry it {:.3g} cells, {:g} at most hold; {}",
                               clock.step, clock.time(), complaint_of(step), step.interval, step.way(speed),
                               step.longest_way, advice_for(step, speed)));
    return true;
  });
  return news;
}

}  // namespace vug
