#include "io/detail/nearest_name.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <vector>

namespace vug {
namespace {

std::string lower(std::string_view text) {
  std::string result(text.substr(0, 64));  // longer texts are not mistyped names
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

/// The shortest candidate that begins so, the first of equals: "time_s" for a column whose unit was left out.
std::string beginning_with(const std::string& words, std::span<const std::string> candidates) {
  std::string shortest;
  for (const std::string& candidate : candidates)
    if (lower(candidate).starts_with(words) && (shortest.empty() || candidate.size() < shortest.size()))
      shortest = candidate;
  return shortest;
}

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
  const std::size_t n = b.size();
  std::vector<int> before(n + 1), last(n + 1), now(n + 1);
  for (std::size_t j = 0; j <= n; ++j) last[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    now[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= n; ++j) {
      const int replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      now[j] = std::min({replaced, last[j] + 1, now[j - 1] + 1});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) now[j] = std::min(now[j], before[j - 2] + 1);
    }
    std::swap(before, last);
    std::swap(last, now);
  }
  return last[n];
}

std::string nearest_name(std::string_view name, std::span<const std::string> candidates) {
  const std::string wanted = lower(name);
  std::string nearest;
  int least = -1;
  for (const std::string& candidate : candidates) {
    const int distance = edit_distance(wanted, lower(candidate));
    if (least < 0 || distance < least) {
      least = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string likely_name(std::string_view name, std::span<const std::string> candidates) {
  std::string nearest = beginning_with(lower(name) + "_", candidates);
  if (nearest.empty()) {
    nearest = nearest_name(name, candidates);
    const int close = std::max<int>(2, static_cast<int>(nearest.size()) / 3);
    if (nearest.empty() || edit_distance(lower(name), lower(nearest)) > close) return "";
  }
  return fmt::format("; did you mean \"{}\"?", nearest);
}

std::string suggestion(std::string_view name, std::span<const std::string> candidates) {
  if (candidates.empty()) return "";
  const std::string likely = likely_name(name, candidates);
  return likely.empty() ? fmt::format("; valid are {}", fmt::join(candidates, ", ")) : likely;
}

}  // namespace vug
