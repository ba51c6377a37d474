#pragma once
// A case with a [laboratory], for tests of what it asks of the press and of what comes out.
#include "coupling/specimen.hpp"

#include <string>
#include <vector>

namespace vug::test {

/// Strong rock, 15 mm wide and 30 mm high.
inline Scene laboratory(const std::string& test, const std::vector<std::string>& overrides = {}) {
  return parse_scene("[laboratory]\nsize = [0.015, 0.03]\ntest = \"" + test +
                         "\"\n[rock]\nelement_size = 2.5e-3\n[mechanics]\nyoung_modulus = \"30 GPa\"\n"
                         "thermal_expansion = 8e-6\n[mechanics.bond]\nnormal_strength = 1e12\ncohesion = 1e12\n",
                     "a.toml", overrides);
}

inline PlatenTest platens_of(const Scene& scene) {
  return platen_test(scene, build_specimen(scene));
}

}  // namespace vug::test
