#include "io/rock_generator.hpp"

#include "base/require.hpp"
#include "base/splitmix64.hpp"
#include "io/detail/rock_mesher.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace vug {

namespace {

using detail::Outline;
using detail::Point;
using detail::RockMesher;

constexpr int attempts = 8;

/// How the mesher of a rock is made: of a rectangle, or of a disc.
using MakeMesher = std::function<RockMesher(const RockSection&)>;

std::uint64_t stream(const RockSection& rock, int attempt) {
  return CounterRandom{rock.seed * attempts + attempt}.next();
}

/// The shapes whose outline is within a distance of a place, the nearest first.
std::vector<std::string> shapes_near(const Outline& outline, Point place, double reach) {
  std::map<std::string, double> nearest;
  for (const auto& edge : outline.edges) {
    const double d = detail::distance(detail::Line{outline.points[edge.a], outline.points[edge.b]}, place);
    if (d > reach) continue;
    const auto known = nearest.try_emplace(outline.shapes[edge.shape], d).first;
    known->second = std::min(known->second, d);
  }
  std::vector<std::string> shapes;
  for (const auto& [shape, d] : nearest) shapes.push_back(shape);
  std::stable_sort(shapes.begin(), shapes.end(),
                   [&](const auto& a, const auto& b) { return nearest.at(a) < nearest.at(b); });
  return shapes;
}

/// Which smaller elements would do: the largest of those tried that give a mesh, or the smallest one that gives none.
/// To try them takes up to three times as long as the attempts before; rock of many triangles is left alone.
std::string smaller_elements(const MakeMesher& make, Point length, RockSection rock) {
  constexpr double most_triangles = 2e5;
  const double now = rock.element_size;
  std::string advice = fmt::format("lower rock.element_size (now {:g} m)", now);
  for (const double factor : {0.7, 0.5, 0.35}) {
    const std::string smaller = fmt::format("{:.2g}", factor * now);  // as the message has it
    rock.element_size = std::stod(smaller);
    if (length[0] * length[1] > most_triangles * 0.43 * rock.element_size * rock.element_size) break;
    const RockMesher mesher = make(rock);
    for (int attempt = 0; attempt < 2; ++attempt)
      if (std::holds_alternative<Assembly>(mesher.attempt(stream(rock, attempt))))
        return fmt::format("lower rock.element_size (now {:g} m) to {} m", now, smaller);
    advice = fmt::format("lower rock.element_size (now {:g} m) below {} m", now, smaller);
  }
  return advice;
}

/// What to change at a place, beside the shapes that are there.
std::string advice(const std::vector<std::string>& shapes, const RockSection& rock, std::string smaller) {
  if (rock.grading > 1) smaller += fmt::format(" or rock.grading (now {:g})", rock.grading);
  if (shapes.empty()) return ", away from all shapes; change rock.seed, or " + smaller;
  if (shapes.size() == 1)
    return fmt::format(", at {}; make its narrow parts and sharp corners wider, or {}", shapes[0], smaller);
  return fmt::format(", between {}; move them apart, let them cross or meet at a wider angle, or {}",
                     fmt::join(shapes, " and "), smaller);
}

/// One line: what is wrong where, which shapes are there, and what to change.
InputError refusal(const MakeMesher& make, const RockMesher& mesher, const RockSection& rock, const Flaw& flaw) {
  const std::string why = fmt::format("rock: no usable mesh after {} attempts: {}", attempts, flaw.what);
  if (!flaw.at) return InputError(why + "; make the holes smaller");
  const Point at = *flaw.at;
  return InputError(fmt::format(
      "{} at x = {:.4g} m, y = {:.4g} m{}", why, at[0], at[1],
      advice(shapes_near(mesher.outline, at, 2 * mesher.size(at)), rock, smaller_elements(make, mesher.length, rock))));
}

Assembly triangulate(const MakeMesher& make, const RockSection& rock) {
  const RockMesher mesher = make(rock);
  Flaw flaw;
  for (int number = 0; number < attempts; ++number) {
    auto made = mesher.attempt(stream(rock, number));
    if (auto* assembly = std::get_if<Assembly>(&made)) return std::move(*assembly);
    flaw = std::get<Flaw>(std::move(made));
  }
  throw refusal(make, mesher, rock, flaw);
}

}  // namespace

Assembly generate_rock(double length_x, double length_y, const RockSection& rock) {
  if (!(rock.element_size > 0) || !(rock.grading >= 1))
    throw InputError("rock: element_size must be positive and grading at least 1");
  if (!(rock.element_size < 0.5 * std::min(length_x, length_y)))
    throw InputError(
        fmt::format("rock.element_size = {:g} m is not less than half the rock's shorter side", rock.element_size));
  return triangulate([&](const RockSection& any) { return RockMesher(Point{length_x, length_y}, any); }, rock);
}

Assembly generate_disc(double diameter, double flat_width, const RockSection& rock) {
  if (!(rock.element_size > 0) || !(rock.element_size <= diameter / 5))
    throw InputError(fmt::format(
        "rock.element_size = {:g} m must be positive and at most a fifth of the disc's diameter", rock.element_size));
  return triangulate(
      [&](const RockSection& any) {
        return RockMesher(detail::disc_outline(diameter, flat_width, any.element_size), any);
      },
      rock);
}

}  // namespace vug
