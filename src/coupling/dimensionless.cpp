#include "coupling/dimensionless.hpp"

#include "coupling/output_schedule.hpp"
#include "io/form.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug {

namespace {

/// Largest velocity that a side, an injection or an opening prescribes, m/s; of a flow rate, its mean over the side
/// without its injections, the injection or the outline of the shape.
double largest_prescribed_speed(const Scene& scene) {
  double largest = 0;
  const auto look = [&](const FlowBoundary& flow, double length) {
    if (flow.kind == FlowBoundaryKind::periodic) return;
    largest = std::max(largest, flow.peak_speed());
    if (length > 1e-6 * scene.lattice.spacing)  // injections may take all of a side
      largest = std::max(largest, std::abs(flow.peak_rate(scene.flow->density)) / length);
  };
  for (const Side side : all_sides) {
    double length = scene.lattice.length_of(side);
    for (const InjectionSection& injection : scene.injections)
      if (injection.side == side) length -= injection.width;
    look(scene.side(side).flow, length);
  }
  for (const InjectionSection& injection : scene.injections) look(injection.conditions.flow, injection.width);
  for (const OpeningSection& opening : scene.openings)
    look(opening.conditions.flow, outline_length(scene.geometry.shapes[opening.shape].form));
  return largest;
}

class Collector {
 public:
  explicit Collector(const Scene& scene) : scene_(scene) {
    const LatticeSection& lattice = scene.lattice;
    const bool given = scene.reaction && scene.reaction->length;
    length_ = given ? *scene.reaction->length : std::min(lattice.length_x, lattice.length_y);
    result_.scales =
        fmt::format("L = {:.4g} m, {}", length_, given ? "reaction.length" : "the shorter side of the lattice");
    if (scene.flow) speed_ = largest_prescribed_speed(scene);
    if (speed_ > 0) result_.scales += fmt::format("; U = {:.4g} m/s, the largest prescribed velocity", speed_);
    time_ = static_cast<double>(last_step(scene)) * lattice.time_step;
    if (scene.heat) result_.scales += fmt::format("; t = {:.4g} s, the end of the run", time_);
  }

  DimensionlessNumbers collected() {
    if (scene_.flow) add("Re", speed_ * length_, scene_.flow->viscosity, "U L / nu");
    if (scene_.heat) add_heat(*scene_.heat);
    if (scene_.solute)
      for (const Species& species : scene_.solute->species) add_species(species);
    if (result_.numbers.empty()) result_.scales.clear();
    return std::move(result_);
  }

 private:
  /// Adds a quotient; nothing where its numerator or denominator is 0.
  void add(const std::string& name, double numerator, double denominator, const char* definition) {
    if (numerator > 0 && denominator > 0) result_.numbers.push_back({name, numerator / denominator, definition});
  }
  void add_heat(const HeatSection& heat) {
    if (scene_.flow) add("Pr", scene_.flow->viscosity, heat.fluid_diffusivity, "nu / alpha_fluid");
    if (scene_.flow) add("Pe of heat", speed_ * length_, heat.fluid_diffusivity, "U L / alpha_fluid");
    add("Fo of the fluid", heat.fluid_diffusivity * time_, length_ * length_, "alpha_fluid t / L^2");
    add("Fo of the rock", heat.solid_diffusivity * time_, length_ * length_, "alpha_solid t / L^2");
  }
  void add_species(const Species& species) {
    const double D = species.diffusivity;
    if (scene_.flow) add("Sc of " + species.name, scene_.flow->viscosity, D, "nu / D");
    if (scene_.flow) add("Pe of " + species.name, speed_ * length_, D, "U L / D");
    if (!scene_.reaction) return;
    const ReactionSection& reaction = *scene_.reaction;
    if (reaction.reactant == species.name) add_reaction(species, reaction, 0);
    for (std::size_t k = 0; k < reaction.further.size(); ++k)
      if (reaction.further[k].reactant == species.name) add_reaction(species, reaction.further[k], k + 1);
  }
  /// `which`: place of the reactant among the rates of a mineral.
  void add_reaction(const Species& species, const RateLaw& of_rock, std::size_t which) {
    const auto da = [&](const std::string& where, const RateLaw& rate) {
      add("Da of " + species.name + where, rate.rate_constant * length_, species.diffusivity, "k_r^0 L / D");
    };
    da("", of_rock);
    for (const MineralSection& mineral : scene_.minerals) da(" on " + mineral.name, mineral.rates[which]);
  }

  const Scene& scene_;
  double length_ = 0, speed_ = 0, time_ = 0;  ///< m, m/s, s
  DimensionlessNumbers result_;
};

}  // namespace

DimensionlessNumbers dimensionless_numbers(const Scene& scene) {
  return scene.laboratory ? DimensionlessNumbers{} : Collector(scene).collected();
}

}  // namespace vug
