#pragma once
// What the presets of a case stand for: the only place that says so. A key that the case gives wins over its preset.
// Why these choices: docs/accuracy.md measures them, docs/case-file.md ("Presets") explains them.
#include "io/scene.hpp"

namespace vug {

enum class Preset { fast, balanced, reference };

/// By its name in the case file.
inline Preset preset_of(const std::string& name) {
  return name == "fast" ? Preset::fast : name == "reference" ? Preset::reference : Preset::balanced;
}

/// How the lattice is computed.
inline AccuracySection accuracy_of(Preset preset) {
  AccuracySection accuracy;  // balanced
  if (preset == Preset::reference) {
    accuracy.preset = "reference";
    accuracy.update_interval = 1;
  }
  if (preset == Preset::fast) {
    accuracy.preset = "fast";
    accuracy.precision = Precision::single_precision;
    accuracy.heat_interval = 4;
    accuracy.solute_interval = 2;
  }
  return accuracy;
}

/// How the rock moves under a lattice. A laboratory test has no preset: its strengths were measured with the sub-steps
/// of MechanicsSection itself.
inline MechanicsSection mechanics_of(Preset preset) {
  MechanicsSection mechanics;  // reference
  if (preset != Preset::reference) mechanics.critical_fraction = 0.5;
  if (preset == Preset::fast) mechanics.parameters.mass_scaling = 16;
  return mechanics;
}

}  // namespace vug
