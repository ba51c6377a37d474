#include "coupling/interval_chooser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace vug {

Intervals longest_intervals(const AccuracySection& accuracy) {
  const auto power = [](int interval, int most) {
    return static_cast<int>(std::bit_floor(static_cast<unsigned>(std::min(interval, most))));
  };
  constexpr int look = IntervalChooser::look_interval;
  // walls are renewed at no fixed step; all other intervals must end at a look
  return {power(accuracy.heat_interval, look), power(accuracy.solute_interval, look),
          power(accuracy.wall_interval, std::numeric_limits<int>::max()), power(accuracy.exchange_interval, look),
          power(accuracy.update_interval, look)};
}

IntervalChooser::IntervalChooser(const Scene& scene, const Intervals& most, const Intervals& safe)
    : given_(scene), most_(most), safe_(safe) {
  const double share = scene.accuracy.tolerance;
  const bool heat = scene.heat.has_value(), rock = scene.mechanics.has_value(), walls = scene.reaction.has_value();
  const auto at_walls = [](const Changes& c) { return std::max({c.heat, c.solute, c.solid}); };
  rules_ = {{"heat", &Intervals::heat, heat, 4 * share, [](const Changes& c) { return c.heat; }},
            {"solute", &Intervals::solute, scene.solute.has_value(), share, [](const Changes& c) { return c.solute; }},
            {"wall", &Intervals::wall, walls, std::sqrt(share), at_walls},
            {"exchange", &Intervals::exchange, rock && scene.flow, 4 * share, [](const Changes& c) { return c.force; }},
            {"update", &Intervals::update, walls || rock, 8 * share, at_walls}};
  std::erase_if(rules_, [](const Rule& rule) { return !rule.there; });
}

bool IntervalChooser::choose(Changes changes, const Intervals& stable, const Clock& clock) {
  given_.raise(changes, clock, look_interval);
  const Intervals& bound = wary_looks_ > 0 ? safe_ : stable;
  wary_looks_ = std::max(0, wary_looks_ - 1);
  const double since_start = 1 / static_cast<double>(clock.step + 1);
  Intervals next = now_;
  for (const Rule& rule : rules_) {
    const double change = std::max(rule.change(changes) / look_interval, since_start);
    next.*rule.interval = next_interval(now_.*rule.interval, bound.*rule.interval, change, rule.allowed);
  }
  return go_on_with(next, clock);
}

bool IntervalChooser::shorten(const Clock& clock) {
  if (wary_looks_ == 0 || !clock.every(now_.heat) || !clock.every(now_.solute)) return false;
  Intervals next = now_;
  next.heat = std::min(now_.heat, safe_.heat);
  next.solute = std::min(now_.solute, safe_.solute);
  return go_on_with(next, clock);
}

bool IntervalChooser::go_on_with(const Intervals& next, const Clock& clock) {
  std::string line;
  for (const Rule& rule : rules_)
    if (const int before = now_.*rule.interval, after = next.*rule.interval; before != after)
      line += fmt::format("{}{}_interval {} -> {}", line.empty() ? "" : ", ", rule.name, before, after);
  now_ = next;
  if (!line.empty()) news_.push_back(fmt::format("step {}, {:.4g} s: {}", clock.step, clock.time(), line));
  return !line.empty();
}

void IntervalChooser::history(std::vector<HistoryValue>& row) const {
  for (const Rule& rule : rules_)
    row.push_back({fmt::format("{}_interval_1", rule.name), static_cast<double>(now_.*rule.interval)});
}

void IntervalChooser::state(StateList& list) {
  for (const Rule& rule : rules_)
    list.add_value(fmt::format("intervals/{}", rule.name), now_.*rule.interval,
                   {1, static_cast<double>(most_.*rule.interval)});
  list.add_value("intervals/wary_looks", wary_looks_, {0, 2});
}

}  // namespace vug
