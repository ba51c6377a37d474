#include "coupling/ways_out.hpp"

#include "base/require.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace vug {

namespace {

constexpr double balanced = 1e-3;  // possible net flow of velocities that are given to three digits

/// Volume that enters a piece of fluid per step, cells, and the same without regard to signs.
struct Inflow {
  double net = 0, gross = 0;
  void operator+=(const Inflow& more) {
    net += more.net;
    gross += more.gross;
  }
  bool is_balanced() const { return std::abs(net) <= balanced * gross; }
};

/// What a mouth has beside one piece of fluid.
struct Part {
  const Mouth* mouth;
  double length = 0;                 ///< cells
  std::array<double, 2> push{0, 0};  ///< as in Mouth, of all its nodes there
  double surface = 0;                ///< sum of the lengths of `push`

  /// At a time (s), where a velocity of 1 m/s is `scale` lattice units.
  Inflow at(double time, double scale) const {
    if (!mouth->moves()) {
      const double volume = mouth->inflow_at(time) * length;
      return {volume, std::abs(volume)};
    }
    const auto& velocity = mouth->conditions->flow.velocity;
    const double x = scale * velocity[0].at(time), y = scale * velocity[1].at(time);
    const double volume = push[0] * x + push[1] * y;
    constexpr double rounding = 1e-9;  // a surface all of which is in fluid takes in behind what it pushes out in front
    if (std::abs(volume) <= rounding * surface * std::hypot(x, y)) return {};
    return {volume, std::abs(volume)};
  }
};

/// A connected piece of fluid.
struct Piece {
  std::vector<Part> parts;
  bool yields = false;
  double nodes = 0;
};

std::vector<Piece> pieces_with_mouths(const std::vector<Mouth>& mouths, const std::vector<int>& piece) {
  std::vector<Piece> pieces(1 + *std::max_element(piece.begin(), piece.end()));
  for (const int p : piece)
    if (p >= 0) ++pieces[p].nodes;
  for (const Mouth& mouth : mouths) {
    std::map<int, Part> parts;
    for (std::size_t k = 0; k < mouth.nodes.size(); ++k) {
      const int p = piece[mouth.nodes[k]];
      Part& part = parts.try_emplace(p, Part{&mouth}).first->second;
      part.length += mouth.length[k];
      if (mouth.yields()) pieces[p].yields = true;
      if (!mouth.moves()) continue;
      for (int axis = 0; axis < 2; ++axis) part.push[axis] += mouth.push[k][axis];
      part.surface += std::hypot(mouth.push[k][0], mouth.push[k][1]);
    }
    if (mouth.inflow == 0 && !mouth.moves()) continue;
    for (const auto& [p, part] : parts) pieces[p].parts.push_back(part);
  }
  return pieces;
}

/// Times at which a flow may be largest, s, ascending: the points of its tables, and between them, where a ramp
/// multiplies a table.
std::vector<double> moments_of(const std::vector<Part>& parts) {
  std::vector<double> points{0};
  for (const Part& part : parts) {
    const FlowBoundary& flow = part.mouth->conditions->flow;
    if (flow.ramp_time > 0) points.push_back(flow.ramp_time);
    for (const TimeTable* table : {&flow.velocity[0], &flow.velocity[1], &flow.speed, flow.given_rate()})
      if (table) points.insert(points.end(), table->moments().begin(), table->moments().end());
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<double> all{points.front()};
  for (std::size_t k = 1; k < points.size(); ++k) {
    all.push_back((points[k - 1] + points[k]) / 2);
    all.push_back(points[k]);
  }
  return all;
}

/// The inflow of a part at its peak: of a moving surface, when it pumps most.
Inflow at_peak(const Part& part, double scale) {
  const double volume = part.mouth->inflow * part.length;
  if (!part.mouth->moves()) return {volume, std::abs(volume)};
  Inflow most;
  for (const double time : moments_of({part}))
    if (const Inflow now = part.at(time, scale); std::abs(now.net) >= std::abs(most.net)) most = now;
  return most;
}

/// Whether a piece without an outlet takes in more, or less, than it gives, at the peaks of its velocities.
std::string refusal_of(const Piece& piece, double scale) {
  Inflow all;
  const Mouth* by = nullptr;
  for (const Part& part : piece.parts) {
    const Inflow peak = at_peak(part, scale);
    all += peak;
    if (peak.net != 0) by = part.mouth;
  }
  if (all.is_balanced() || !by) return "";
  return fmt::format("{}.flow {} fluid {} a space that has no other opening{}", by->key,
                     all.net > 0 ? "presses" : "draws", all.net > 0 ? "into" : "out of",
                     by->moves() ? ": its moving surface is not all in that fluid" : "");
}

/// Remarks on a piece without an outlet whose velocities balance at their peaks, but not at all times.
std::string remark_of(const Piece& piece, const LatticeUnits& units) {
  const double scale = 1 / units.velocity();
  const std::vector<double> moments = moments_of(piece.parts);
  std::vector<Inflow> flows;
  double gross = 0, most = 0, volume = 0, largest = 0;
  for (const double time : moments) {
    Inflow now;
    for (const Part& part : piece.parts) now += part.at(time, scale);
    if (!flows.empty()) {
      const double steps = (time - moments[flows.size() - 1]) / units.time_step;
      volume += steps * (flows.back().net + now.net) / 2;
      largest = std::max(largest, std::abs(volume));
    }
    flows.push_back(now);
    gross = std::max(gross, now.gross);
    most = std::max(most, std::abs(now.net));
  }
  if (most <= balanced * gross) return "";
  const bool goes_on = std::abs(flows.back().net) > balanced * gross;
  return fmt::format(
      "{}.flow: the velocities in a space that has no other opening are in balance at their peaks, but "
      "not at all times: they change its pressure by up to {:.3g} Pa{}",
      piece.parts.front().mouth->key, largest / piece.nodes / 3 * units.pressure(),
      goes_on ? ", and go on to change it after the last point of their tables" : "");
}

}  // namespace

void look_for_ways_out(const Scene& scene, const std::vector<Mouth>& mouths, const std::vector<int>& piece,
                       const LatticeUnits& units, bool rock_opens, FlowPaths& found) {
  const double scale = 1 / units.velocity();
  for (const Piece& here : pieces_with_mouths(mouths, piece)) {
    for (const Part& part : here.parts) {
      const Inflow peak = at_peak(part, scale);
      if (here.yields && part.mouth->moves() && peak.net != 0)
        found.warnings.push_back(fmt::format(
            "{}.flow.velocity: the moving surface is not all in one fluid, and {} it "
            "up to {:.3g} m2/s",
            part.mouth->key, peak.net > 0 ? "presses into" : "draws out of", std::abs(peak.net) * units.diffusivity()));
    }
    if (here.yields || here.parts.empty()) continue;
    if (const std::string line = refusal_of(here, scale); !line.empty()) {
      if (!rock_opens) throw InputError(fmt::format("{}: {}", scene.path, line));
      found.warnings.push_back(line + " until rock opens");
      return;
    }
    if (const std::string line = remark_of(here, units); !line.empty()) found.warnings.push_back(line);
  }
}

}  // namespace vug
