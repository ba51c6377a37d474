#pragma once
// What the presets of a case stand for, defined only here. A key that the case gives has precedence over its preset.
// docs/accuracy.md has the measurements behind these choices, docs/case-file.md ("Presets") explains them.
#include "io/scene.hpp"

namespace vug {

/// `careful` is what a case without a preset gets: the defaults of the sections themselves.
enum class Preset { fast, balanced, careful, reference };

/// How the lattice is computed.
inline AccuracySection accuracy_of(Preset preset) {
  AccuracySection accuracy;
  switch (preset) {
    case Preset::fast:
      accuracy.preset = "fast";
      accuracy.precision = Precision::single_precision;
      accuracy.update_interval = 20;
      accuracy.wall_interval = 100;
      accuracy.heat_interval = 4;
      accuracy.solute_interval = 2;
      accuracy.exchange_interval = 4;
      break;
    case Preset::balanced:
      accuracy.preset = "balanced";
      accuracy.update_interval = 20;
      accuracy.wall_interval = 100;
      accuracy.heat_interval = 2;
      accuracy.solute_interval = 2;
      accuracy.exchange_interval = 4;
      break;
    case Preset::careful:
      break;
    case Preset::reference:
      accuracy.preset = "reference";
      accuracy.update_interval = 1;
      accuracy.wall_interval = 1;
      break;
  }
  return accuracy;
}

/// How the rock moves.
inline MechanicsSection mechanics_of(Preset preset) {
  MechanicsSection mechanics;
  if (preset == Preset::fast || preset == Preset::balanced) mechanics.critical_fraction = 0.5;
  if (preset == Preset::balanced) mechanics.parameters.rest_tolerance = 5e-3;
  if (preset == Preset::fast) {
    mechanics.parameters.mass_scaling = 4;
    mechanics.parameters.rest_tolerance = 1e-2;
  }
  return mechanics;
}

/// The preset that suits a tolerance in everything but the intervals, with an error well below it (docs/accuracy.md):
/// how the rock moves, and the precision: in `single` a flow that hardly changes any more is rounded short of its end.
inline Preset preset_of(double tolerance) {
  return tolerance >= 2e-4 ? Preset::fast : tolerance >= 5e-5 ? Preset::balanced : Preset::careful;
}
inline Precision precision_of(double tolerance) {
  return tolerance >= 5e-3 ? Precision::single_precision : Precision::double_precision;
}

/// Sets the longest intervals that a run may choose.
inline void set_longest_intervals(AccuracySection& accuracy) {
  accuracy.heat_interval = accuracy.solute_interval = accuracy.exchange_interval = 16;
  accuracy.update_interval = 128;
  accuracy.wall_interval = 512;
}

/// The preset of this name in the case file.
inline Preset preset_of(const std::string& name) {
  for (const Preset preset : {Preset::fast, Preset::balanced, Preset::reference})
    if (name == accuracy_of(preset).preset) return preset;
  return Preset::careful;
}

}  // namespace vug
