// The pressure that a case writes out, in pascal, from side to side of a channel that a small difference drives.
#include "support/coupled_run.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace vug {
namespace {

using test::CoupledRun;

constexpr int length = 24, width = 6;
constexpr double applied = 1e-5, reference = 1e5;  // Pa; inertia adds its square

/// Water of tau = 0.764 between walls, the higher pressure on the side `in`: all of it, or an injection as wide as the
/// channel, set in rock that leaves the same channel in the middle of a lattice three times as wide.
std::string channel(const std::string& in, const std::string& out, bool hole, const std::string& collision) {
  const bool upright = in == "bottom" || in == "top";
  const int across = hole ? 3 * width : width, nx = upright ? across : length, ny = upright ? length : across;
  std::string text = fmt::format(
      "[lattice]\nsize = [{}e-4, {}e-4]\nspacing = 1e-4\ntime_step = 8.8e-4\n[time]\nsteps = 1000000\n"
      "[flow]\nviscosity = 1e-6\ndensity = 1000\ninitial_pressure = {:.17g}\ncollision = \"{}\"\n"
      "[boundary.{}]\nflow = {{ type = \"pressure\", pressure = {:.17g} }}\n",
      nx, ny, reference, collision, out, reference);
  const std::string given = fmt::format("flow = {{ type = \"pressure\", pressure = {:.17g} }}\n", reference + applied);
  if (!hole) return text + fmt::format("[boundary.{}]\n", in) + given;
  const auto wall = [&](double from, double to) {
    const double x0 = upright ? from : 0, x1 = upright ? to : length, y0 = upright ? 0 : from,
                 y1 = upright ? length : to;
    return fmt::format("[[geometry.shapes]]\ntype = \"rectangle\"\nfrom = [{}e-4, {}e-4]\nto = [{}e-4, {}e-4]\n", x0,
                       y0, x1, y1);
  };
  return text + "[geometry]\ntype = \"shapes\"\n" + wall(0, width) + wall(2 * width, 3 * width) +
         fmt::format("[boundary.injection]\nside = \"{}\"\ncentre = {}e-4\nwidth = {}e-4\n", in, 1.5 * width, width) +
         given;
}

TEST(PressureField, FallsEvenlyFromSideToSideAndKeepsItsDigitsAboveAtmosphere) {
  const std::array<std::pair<const char*, const char*>, 4> directions{
      {{"left", "right"}, {"right", "left"}, {"bottom", "top"}, {"top", "bottom"}}};
  constexpr const char* collisions[] = {"trt", "lallemand_luo", "bgk", "regularised"};
  for (const auto& [in, out] : directions)
    for (int k = 0; k < 4; ++k) {
      const bool hole = k > 1;
      CoupledRun run(channel(in, out, hole, collisions[k]));
      run.steps(12000);
      const std::vector<double> gauge = run.nodes("gauge_pressure"), absolute = run.nodes("pressure"),
                                rock = run.nodes("node_type");
      const Lattice& lattice = run.parts().geometry.lattice;
      for (int y = 0; y < lattice.ny; ++y)
        for (int x = 0; x < lattice.nx; ++x) {
          const int n = y * lattice.nx + x;
          const std::string side = in;
          const double from = (side == "left"     ? x
                               : side == "right"  ? lattice.nx - 1 - x
                               : side == "bottom" ? y
                                                  : lattice.ny - 1 - y) +
                              0.5;
          const double exact = rock[n] == 0 ? applied * (1 - from / length) : 0;
          // snapshots hold floats, in which the absolute pressure has steps of 0.008 Pa
          EXPECT_NEAR(static_cast<float>(gauge[n]), exact, 1e-6 * applied) << in << " " << collisions[k];
          EXPECT_NEAR(absolute[n], reference + exact, 1e-10);
        }
    }
}

}  // namespace
}  // namespace vug
