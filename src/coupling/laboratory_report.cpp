#include "coupling/laboratory_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug {

namespace {

Spread spread_over(const std::vector<LoadedSpecimen>& specimens, double PlatenResult::*number) {
  std::vector<double> values;
  for (const LoadedSpecimen& one : specimens) values.push_back(one.result.*number);
  return spread_of(values);
}

/// Line with the elastic constants; empty for a disc and for heated rock.
std::string elasticity(const std::vector<LoadedSpecimen>& specimens, Results& results) {
  const Spread modulus = spread_over(specimens, &PlatenResult::modulus);
  const Spread poisson = spread_over(specimens, &PlatenResult::poisson);
  if (modulus.mean == 0) return "";
  if (std::any_of(specimens.begin(), specimens.end(), [](const LoadedSpecimen& s) { return !s.result.gauged; }))
    return fmt::format(
        "{:<22}not told: no triangle at a gauge, at 20 or 80 % of the height or at a flank; smaller triangles tell "
        "it\n",
        "Young's modulus");
  if (!std::isfinite(modulus.mean) || !std::isfinite(poisson.mean))
    return fmt::format(
        "{:<22}not told: too few points of the curve between 20 and 50 % of its peak, or half of the peak before sound "
        "had crossed the specimen one and a half times; lower laboratory.sample_strain or laboratory.platen_speed\n",
        "Young's modulus");
  results.insert(results.end(), {{"modulus_Pa", modulus.mean}, {"poisson_1", poisson.mean}});
  return line_of("Young's modulus", modulus, 1e9, "GPa", 2) + line_of("Poisson's ratio", poisson, 1, "", 3);
}

std::string strength(const std::vector<LoadedSpecimen>& specimens, const char* advice, Results& results) {
  const Spread stress = spread_over(specimens, &PlatenResult::strength);
  const Spread strain = spread_over(specimens, &PlatenResult::peak_strain);
  const auto whole = std::count_if(specimens.begin(), specimens.end(),
                                   [](const LoadedSpecimen& s) { return !s.result.passed_a_peak(); });
  const std::string name = whole == 0 ? "strength" : "largest_stress";
  results.insert(
      results.end(),
      {{name + "_Pa", stress.mean}, {name + "_deviation_Pa", stress.deviation}, {"peak_strain_1", strain.mean}});
  const std::string text = line_of(whole == 0 ? "strength" : "largest stress", stress, 1e6, "MPa", 2) +
                           line_of("strain at the peak", strain, 0.01, "%", 3);
  if (whole == 0) return text;
  const std::string which =
      specimens.size() == 1 ? "the specimen" : fmt::format("{} of {} specimens", whole, specimens.size());
  return text + fmt::format("{} did not pass a peak: {}\n", which, advice);
}

}  // namespace

std::string line_of(const char* what, const Spread& s, double unit, const char* name, int digits) {
  const std::string spread = s.deviation > 0 ? fmt::format(" +- {:.{}f}", s.deviation / unit, digits) : "";
  return fmt::format("{:<22}{:.{}f}{} {}\n", what, s.mean / unit, digits, spread, name);
}

const std::vector<std::string> energy_columns{"work_J_per_m",     "elastic_energy_J_per_m", "kinetic_energy_J_per_m",
                                              "fracture_J_per_m", "friction_J_per_m",       "damping_J_per_m",
                                              "missing_J_per_m"};

std::vector<double> values_of(const Energies& e) {
  return {e.work, e.elastic, e.kinetic, e.fracture, e.friction, e.damping, e.imbalance()};
}

std::string report_of(const std::vector<LoadedSpecimen>& specimens, const char* advice, Results& results) {
  std::string text = elasticity(specimens, results) + strength(specimens, advice, results);
  const auto mean = [&](const auto& number) {
    double sum = 0;
    for (const LoadedSpecimen& one : specimens) sum += static_cast<double>(number(one));
    return sum / static_cast<double>(specimens.size());
  };
  const double in_tension = mean([](const LoadedSpecimen& s) { return s.result.bonds_at_end.failed_in_tension; });
  const double in_shear = mean([](const LoadedSpecimen& s) { return s.result.bonds_at_end.failed_in_shear; });
  const double failed = in_tension + in_shear;
  const double along_load = failed > 0 ? mean([](const LoadedSpecimen& s) { return s.along_load; }) / failed : 0;
  const double steps = mean([](const LoadedSpecimen& s) { return s.result.steps; });
  const double time_step = specimens.front().result.time_step;  // of all: only strengths differ
  text += fmt::format(
      "bonds failed          {:.6g} in tension, {:.6g} in shear at the peak; {:.6g} and {:.6g} at the end; {:.0f} % of "
      "them along the load\n"
      "time step             {:.3g} s, {:.0f} steps\n",
      mean([](const LoadedSpecimen& s) { return s.result.bonds_at_peak.failed_in_tension; }),
      mean([](const LoadedSpecimen& s) { return s.result.bonds_at_peak.failed_in_shear; }), in_tension, in_shear,
      100 * along_load, time_step, steps);
  results.insert(results.end(), {{"specimens_1", static_cast<double>(specimens.size())},
                                 {"time_step_s", time_step},
                                 {"steps_1", steps},
                                 {"failed_in_tension_1", in_tension},
                                 {"failed_in_shear_1", in_shear},
                                 {"failed_along_load_1", along_load}});
  return text;
}

std::string report_energies(const std::vector<LoadedSpecimen>& specimens, Results& results) {
  Energies e;
  for (double Energies::*part : {&Energies::kinetic, &Energies::elastic, &Energies::initial, &Energies::work,
                                 &Energies::fracture, &Energies::friction, &Energies::damping, &Energies::dissolved}) {
    for (const LoadedSpecimen& one : specimens) e.*part += one.result.energies.*part;
    e.*part /= static_cast<double>(specimens.size());
  }
  std::vector<double> energies = values_of(e);
  double& missing = energies.back();
  missing = specimens.front().result.energies.imbalance();
  for (const LoadedSpecimen& one : specimens)
    if (const double of_one = one.result.energies.imbalance(); std::abs(of_one) > std::abs(missing)) missing = of_one;
  for (std::size_t i = 0; i < energies.size(); ++i) results.emplace_back(energy_columns[i], energies[i]);
  return fmt::format(
      "energy at the end     {:.4g} J/m at the start and {:.4g} of work are {:.4g} elastic, {:.4g} kinetic, {:.4g} "
      "fracture, {:.4g} friction, {:.4g} damping; {:.2g} missing\n",
      e.initial, e.work, e.elastic, e.kinetic, e.fracture, e.friction, e.damping, missing);
}

}  // namespace vug
