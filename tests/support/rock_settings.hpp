#pragma once
// Settings for tests/cases/coupled/small_rock.toml: rock of two materials, loads on parts of sides that change, gauges.
#include <string>

namespace vug::test {

inline const std::string several_materials =
    "mechanics.material=[{ type = \"rectangle\", from = [0.012, 0], to = [0.02, 0.014], young_modulus = 5e10, "
    "poisson_ratio = 0.2, thermal_expansion = 1e-5, bond = { cohesion = 4e6 } }]";
inline const std::string moving_part =
    "boundary.top.traction.parts=[{ from = 0.004, to = 0.012, normal_stress = [[0, 2e6], [8e-5, 12e6], [3e-4, 1e6]] }, "
    "{ from = 0.014, to = 0.02, support = \"pin\", velocity = [[0, 0, 0], [1e-4, 0, -0.02]] }]";
inline const std::string gauges =
    "output.gauges=[{ name = \"a\", type = \"reaction\", side = \"left\" }, "
    "{ name = \"b\", type = \"displacement\", at = [0.015, 0.01] }, "
    "{ name = \"c\", type = \"stress\", shape = { type = \"disc\", centre = [0.014, 0.006], radius = 0.004 } }, "
    "{ name = \"d\", type = \"crack_tip\", from = [0.002, 0.007], direction = [1, 0] }]";

}  // namespace vug::test
