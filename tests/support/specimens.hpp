#pragma once
// Specimens and records of the laboratory's tests.
#include "dem/laboratory.hpp"
#include "dem/toughness.hpp"
#include "dem_support.hpp"
#include "io/rock_generator.hpp"
#include "support/record.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace vug::test {

/// Internal cohesion of profile `calibrated`, Pa.
inline constexpr double calibrated_cohesion = 58e6;

inline RockSection elements(double size, std::uint64_t seed = 1) {
  RockSection rock;
  rock.element_size = size;
  rock.seed = seed;
  return rock;
}

/// The paper's specimen, 10 cm x 5 cm.
inline Assembly specimen(double size, std::uint64_t seed = 1) {
  return generate_rock(0.05, 0.1, elements(size, seed));
}

/// Table 1 with the fracture energies as those of the rock, as a case has them that does not say otherwise.
inline MechanicsParameters table_one(double path_ratio = generated_path_ratio) {
  MechanicsParameters p;
  p.bond = bonds_of_rock(p.bond, path_ratio);
  return p;
}

inline MechanicsParameters rock_of(double cohesion, std::uint64_t seed = 1, double path_ratio = generated_path_ratio) {
  MechanicsParameters p = table_one(path_ratio);
  p.bond.cohesion = cohesion;
  p.bond.seed = seed;
  return p;
}

inline MechanicsParameters unbreakable() {
  MechanicsParameters p;
  p.bond.normal_strength = p.bond.cohesion = 1e15;
  return p;
}

/// At most 150 points of a stress-strain curve.
inline void record_curve(const char* name, double parameter, const PlatenResult& r) {
  for (std::size_t i = 0; i < r.strain.size(); i += std::max<std::size_t>(1, r.strain.size() / 150))
    record(name, {{"parameter", parameter}, {"strain", r.strain[i]}, {"stress", r.stress[i]}});
}

/// The edges of the bonds that have failed.
inline void record_cracks(const char* name, const Assembly& assembly, const Bonds& bonds) {
  const auto state = host_copy(bonds.state);
  const auto vertex = host_copy(bonds.vertex);
  for (int k = 0; k < bonds.count; ++k) {
    if (!has_failed(state(k))) continue;
    const auto &p = assembly.vertices[vertex(k, 0)], &q = assembly.vertices[vertex(k, 1)];
    record(name, {{"x0", p[0]},
                  {"y0", p[1]},
                  {"x1", q[0]},
                  {"y1", q[1]},
                  {"shear", static_cast<int>(state(k) == BondState::failed_in_shear)}});
  }
}

}  // namespace vug::test
