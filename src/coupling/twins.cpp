// The runs with which a case is compared for its error bars.
#include "base/require.hpp"
#include "coupling/error_bars.hpp"
#include "coupling/output_schedule.hpp"
#include "io/override_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace vug {

namespace {

bool is_whole(double number) {
  return std::fmod(number + 1e-9, 1.0) < 1e-6;
}

/// The scene on a lattice `ratio` times coarser, a picture with squares of pixels `ratio` times as wide. Throws
/// InputError where that does not fit.
Scene coarser(const Scene& scene, double ratio) {
  std::vector<std::string> change{fmt::format("lattice.spacing={:.17g}", ratio * scene.lattice.spacing),
                                  fmt::format("lattice.time_step={:.17g}", ratio * ratio * scene.lattice.time_step)};
  if (scene.time.steps) change.push_back(fmt::format("time.steps={}", steps_over(*scene.time.steps, ratio)));
  if (scene.output.interval_steps) {
    const double interval = static_cast<double>(*scene.output.interval_steps) / (ratio * ratio);
    change.push_back(fmt::format("output.interval_steps={}", std::max(1LL, std::llround(interval))));
  }
  if (scene.geometry.kind == GeometryKind::image) {
    const double pixels = ratio * scene.geometry.image.coarsen;
    if (!is_whole(pixels)) throw InputError(fmt::format("{}: no cell is {:g} pixels wide", scene.path, pixels));
    change.push_back(fmt::format("geometry.coarsen={}", std::lround(pixels)));
  }
  Scene coarse = override_scene(scene, change);
  // Rows at the same times: between those of fewer ones a bar would hold the curvature of the history. Not an override:
  // it may follow from the end of the run, which may be moved.
  const double step = coarse.lattice.time_step, rows = std::max(row_interval(scene), step);
  const double end = coarse.time.steps ? static_cast<double>(*coarse.time.steps) * step : *coarse.time.end;
  if (rows <= end) coarse.output.history_interval = rows;
  return coarse;
}

/// The ratio from 5/4 to 3 nearest to 2 that leaves whole numbers of cells, and of pixels of a picture along the edge
/// of a cell, preferably with its square too. 0: none.
double ratio_of_twins(const Scene& scene) {
  const LatticeSection& lattice = scene.lattice;
  const int pixels = scene.geometry.kind == GeometryKind::image ? scene.geometry.image.coarsen : 0;
  const int common = std::gcd(lattice.nx, lattice.ny);
  double best = 0, least = std::numeric_limits<double>::max();
  for (int part = 1; part < common; ++part) {
    const double ratio = static_cast<double>(common) / part;
    if (ratio < 1.25 || ratio > 3 || !is_whole(ratio * pixels)) continue;
    const double squared = ratio * ratio;
    const bool twice = is_whole(lattice.nx / squared) && is_whole(lattice.ny / squared) && is_whole(squared * pixels);
    const double badness = std::abs(std::log2(ratio) - 1) + (twice ? 0 : 1);
    if (badness < least) {
      least = badness;
      best = ratio;
    }
  }
  return best;
}

Twins coarser_twins(const Scene& scene) {
  Twins found{ratio_of_twins(scene), {}};
  if (found.ratio == 0)
    throw InputError(fmt::format(
        "{}: an error bar needs a coarser lattice of the same size, and {} x {} nodes have none{}; "
        "give both directions a common divisor, 8 or so",
        scene.path, scene.lattice.nx, scene.lattice.ny,
        scene.geometry.kind == GeometryKind::image ? " whose cells are whole squares of pixels (geometry.coarsen)"
                                                   : ""));
  found.twins.push_back({"error_bars/coarse", coarser(scene, found.ratio)});
  try {
    found.twins.push_back({"error_bars/coarser", coarser(scene, found.ratio * found.ratio)});
  } catch (const InputError&) {
    // one coarser lattice has to do
  }
  return found;
}

Twins finer_twins(const Scene& scene) {
  const AccuracySection& accuracy = scene.accuracy;
  std::vector<std::string> change;
  const auto halve = [&](const char* key, int interval) {
    if (interval > 1) change.push_back(fmt::format("accuracy.{}={}", key, interval / 2));
  };
  if (accuracy.chooses_intervals())  // this halves all of them
    return {
        0,
        {{"error_bars/finer", override_scene(scene, {fmt::format("accuracy.tolerance={:.17g}", accuracy.tolerance / 2),
                                                     "accuracy.precision=\"double\""})}}};
  halve("update_interval", accuracy.update_interval);
  halve("wall_interval", accuracy.wall_interval);
  halve("heat_interval", accuracy.heat_interval);
  halve("solute_interval", accuracy.solute_interval);
  halve("exchange_interval", accuracy.exchange_interval);
  if (change.empty())
    throw InputError(scene.path + ": has no interval of [accuracy] that could be halved for an error bar");
  if (accuracy.precision != Precision::double_precision) change.push_back("accuracy.precision=\"double\"");
  return {0, {{"error_bars/finer", override_scene(scene, change)}}};
}

}  // namespace

std::int64_t steps_over(std::int64_t steps, double ratio) {
  const double exact = static_cast<double>(steps) / (ratio * ratio);
  return std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(exact * (1 - 1e-12))));
}

Twins find_twins(const Scene& scene) {
  return scene.rock ? finer_twins(scene) : coarser_twins(scene);
}

}  // namespace vug
