#include "io/detail/mesh_text.hpp"

#include "base/require.hpp"
#include "io/message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace vug::detail {

namespace {
bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}
}  // namespace

void MeshText::fail(const std::string& message) const {
  throw InputError(one_line(fmt::format("{}:{}: {}", path_, line_, message)));
}

void MeshText::skip_blanks() {
  while (!rest_.empty() && is_blank(rest_.front())) {
    line_ += rest_.front() == '\n';
    rest_.remove_prefix(1);
  }
}

bool MeshText::at_end() {
  skip_blanks();
  return rest_.empty();
}

std::string_view MeshText::word() {
  if (at_end()) fail("the file ends too early");
  const auto end = std::find_if(rest_.begin(), rest_.end(), is_blank);
  const auto found = rest_.substr(0, static_cast<std::size_t>(end - rest_.begin()));
  rest_.remove_prefix(found.size());
  return found;
}

template <class Value>
Value MeshText::parsed(const char* expected) {
  const auto text = word();
  Value value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(static_cast<double>(value)))
    fail(fmt::format("found '{}', expected {}", excerpt(text), expected));
  return value;
}

std::int64_t MeshText::integer() {
  return parsed<std::int64_t>("a whole number");
}

double MeshText::number() {
  return parsed<double>("a finite number");
}

std::string MeshText::quoted() {
  if (at_end() || rest_.front() != '"') fail("expected a name in quotation marks");
  const auto end = rest_.find('"', 1);
  if (end == std::string_view::npos) fail("a name has no closing quotation mark");
  std::string name(rest_.substr(1, end - 1));
  line_ += static_cast<int>(std::count(name.begin(), name.end(), '\n'));
  rest_.remove_prefix(end + 1);
  return name;
}

std::int64_t MeshText::count() {
  const auto value = integer();
  if (value < 0 || static_cast<std::uint64_t>(value) > rest_.size() / 2)
    fail(fmt::format("a count of {} does not fit into the rest of the file", value));
  return value;
}

void MeshText::skip(std::int64_t words) {
  for (std::int64_t i = 0; i < words; ++i) word();
}

void MeshText::expect(std::string_view wanted) {
  if (const auto found = word(); found != wanted)
    fail(fmt::format("found '{}', expected {}", excerpt(found), excerpt(wanted)));
}

void MeshText::skip_past(std::string_view end) {
  while (word() != end) {
  }
}

}  // namespace vug::detail
