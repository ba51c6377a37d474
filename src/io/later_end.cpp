#include "io/later_end.hpp"

#include "base/require.hpp"
#include "io/detail/case_tables.hpp"

namespace vug {

namespace {

toml::table all_but_time(const TomlDocument& document) {
  toml::table root = document.root();
  root.erase("time");
  return root;
}

}  // namespace

std::optional<TimeSection> time_of_same_case(const Scene& scene, const std::string& text,
                                             const std::vector<std::string>& overrides) try {
  const TomlDocument ours(scene.source_text, scene.path, scene.overrides), other(text, scene.path, overrides);
  if (all_but_time(ours) != all_but_time(other)) return std::nullopt;
  const TimeSection time = read_time(TomlCursor(other).table("time"));
  if (time.end.has_value() != scene.time.end.has_value()) return std::nullopt;
  return time;
} catch (const InputError&) {
  return std::nullopt;
}

}  // namespace vug
