// Checks of supports and loads of the rock's sides.
#include "dem/runaway_speed.hpp"
#include "io/detail/case_checks.hpp"
#include "io/detail/platen_motion.hpp"

#include <fmt/format.h>

#include <string>

namespace vug {
namespace {

/// A frictionless platen moves nothing along itself, and no platen is faster than sound in rock.
void check_platen(const TomlDocument& document, const std::string& key, Side side, const TractionLoad& load) {
  const bool slides = load.support == Support::roller || load.support == Support::pin_roller;
  const int along = is_upright(side) ? 1 : 0;
  if (slides && load.velocity[along].peak() != 0)
    document.fail(key + ".velocity",
                  fmt::format("moves a roller along itself; its platen is frictionless: the {} component must be 0",
                              along == 0 ? "first" : "second"));
  if (const double speed = fastest(load); speed > runaway_speed)
    document.fail(key + ".velocity",
                  fmt::format("moves the rock at {:g} m/s; at most {:g} m/s, about the speed of sound in rock, is "
                              "possible",
                              speed, runaway_speed));
}

/// Parts must lie on their side.
void check_side(const TomlDocument& document, const Scene& scene, Side side) {
  const TractionBoundary& traction = scene.side(side).traction;
  const std::string key = fmt::format("boundary.{}.traction", name_of(side));
  const double length = scene.lattice.length_of(side);
  check_platen(document, key, side, traction.load);
  for (std::size_t p = 0; p < traction.parts.size(); ++p) {
    const std::string part = fmt::format("{}.parts.{}", key, p);
    if (traction.parts[p].to > length * (1 + 1e-9))
      document.fail(part + ".to", fmt::format("m lies beyond the end of the {} side, {:g} m", name_of(side), length));
    check_platen(document, part, side, traction.parts[p].load);
  }
}

}  // namespace

void check_traction(const TomlDocument& document, const Scene& scene) {
  for (const Side side : all_sides) check_side(document, scene, side);
}

}  // namespace vug
