#include "base/splitmix64.hpp"
#include "study/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace vug {

namespace {

/// 0 ... count - 1 in a random order (Fisher & Yates).
std::vector<int> shuffled(int count, CounterRandom& random) {
  std::vector<int> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), 0);
  for (int i = count - 1; i > 0; --i) std::swap(order[i], order[random.next() % static_cast<std::uint64_t>(i + 1)]);
  return order;
}

std::vector<std::vector<std::string>> grid(const Study& study) {
  std::vector<std::vector<std::string>> runs{{}};
  for (const StudyKey& key : study.keys) {
    std::vector<std::vector<std::string>> more;
    for (const auto& run : runs)
      for (const std::string& value : key.values) {
        more.push_back(run);
        more.back().push_back(value);
      }
    runs = std::move(more);
  }
  return runs;
}

/// Significant digits that tell a billionth of the range apart.
int digits_of(const StudyKey& key) {
  const double largest = std::max(std::abs(key.from), std::abs(key.to)), range = std::abs(key.to - key.from);
  return range > 0 ? std::clamp(9 + static_cast<int>(std::log10(largest / range)), 9, 17) : 17;
}

/// The values of one key, [run]; lists are repeated from the start as often as needed.
std::vector<std::string> hypercube_values(const Study& study, const StudyKey& key, std::uint64_t stream) {
  std::vector<std::string> values;
  CounterRandom random{study.seed * 0x100000001b3u + stream};
  const std::vector<int> part = shuffled(study.samples, random);
  for (int i = 0; i < study.samples; ++i) {
    if (!key.values.empty()) {
      values.push_back(key.values[static_cast<std::size_t>(i) % key.values.size()]);
      continue;
    }
    const double share = (part[i] + random.uniform()) / study.samples;
    const double value =
        key.logarithmic ? key.from * std::pow(key.to / key.from, share) : key.from + share * (key.to - key.from);
    values.push_back(fmt::format("{:.{}g}", value, digits_of(key)));
  }
  return values;
}

}  // namespace

std::vector<std::vector<std::string>> sample(const Study& study) {
  if (study.sampling == Sampling::grid) return grid(study);
  const bool hypercube = study.sampling == Sampling::latin_hypercube;
  const std::size_t count = hypercube ? static_cast<std::size_t>(study.samples) : study.keys[0].values.size();
  std::vector<std::vector<std::string>> runs(count);
  for (std::size_t k = 0; k < study.keys.size(); ++k) {
    const std::vector<std::string> values =
        hypercube ? hypercube_values(study, study.keys[k], k) : study.keys[k].values;
    for (std::size_t i = 0; i < count; ++i) runs[i].push_back(values[i]);
  }
  return runs;
}

}  // namespace vug
