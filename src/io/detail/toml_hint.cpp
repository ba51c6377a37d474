#include "io/detail/toml_hint.hpp"

#include "io/message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

namespace vug {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// How much of a text is a number, as people write it: with digits on one side of the point only as well.
std::size_t length_of_number(std::string_view text) {
  const auto digits = [&](std::size_t at) {
    while (at < text.size() && (is_digit(text[at]) || text[at] == '_')) ++at;
    return at;
  };
  const std::size_t sign = !text.empty() && (text[0] == '-' || text[0] == '+') ? 1 : 0;
  const bool point_first = text.size() > sign + 1 && text[sign] == '.' && is_digit(text[sign + 1]);
  if (text.size() == sign || (!is_digit(text[sign]) && !point_first)) return 0;
  std::size_t at = digits(sign);
  if (at < text.size() && text[at] == '.') at = digits(at + 1);
  if (at + 1 < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    const std::size_t power = at + (text[at + 1] == '-' || text[at + 1] == '+' ? 2 : 1);
    if (power < text.size() && is_digit(text[power])) at = digits(power);
  }
  return at;
}

std::string hint_on_number(std::string_view value, std::size_t length) {
  const std::string_view number = value.substr(0, length), rest = trimmed(value.substr(length));
  if (rest.empty()) {
    const std::size_t point = number.find('.');
    const bool bare = point != std::string_view::npos && (point == 0 || !is_digit(number[point - 1]) ||
                                                          point + 1 == number.size() || !is_digit(number[point + 1]));
    return bare ? "digits stand on both sides of a decimal point: 0.5, 1.0e-6" : "";
  }
  const bool fortran = (rest[0] == 'd' || rest[0] == 'D') && rest.size() > 1 && !is_letter(rest[1]);
  if (rest[0] == '*' || rest[0] == '^' || rest.starts_with("x10") || rest.starts_with("x 10") || fortran)
    return "powers of ten are written 4e-6";
  if (rest.starts_with("//")) return "a comment begins with #";
  if (rest[0] == ';') return "no semicolon ends a line";
  if (rest[0] == '%') return "a fraction is a number from 0 to 1: 0.15 for 15 %";
  if (is_letter(rest[0])) return fmt::format("a number with a unit stands in quotes: \"{}\"", excerpt(value, 40));
  return "";
}

/// On a value outside of quotes, or an element of a list.
std::string hint_on_value(std::string_view value) {
  value = trimmed(value);
  if (value.empty()) return "";
  if (const std::size_t length = length_of_number(value); length > 0) return hint_on_number(value, length);
  std::string word(value.substr(0, 8));
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  constexpr std::array switches{"true", "false", "yes", "no", "on", "off"};
  if (std::find(switches.begin(), switches.end(), word) != switches.end())
    return value == "true" || value == "false" ? "" : "write true or false";
  if (is_letter(value[0]) || value[0] == '/' || value[0] == '.' || value[0] == '~' || value[0] == '\\')
    return word == "inf" || word == "nan" ? "" : "text, such as a word or a path, stands in quotes";
  return "";
}

}  // namespace

std::string_view line_of(std::string_view text, std::size_t number) {
  for (; number > 1; --number) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end + 1);
  }
  return text.substr(0, text.find('\n'));
}

bool has_decimal_comma(std::string_view text) {
  for (std::size_t at = 1; at + 1 < text.size(); ++at)
    if (text[at] == ',' && is_digit(text[at - 1]) && is_digit(text[at + 1])) return true;
  return false;
}

std::string hint_on(std::string_view line) {
  line = trimmed(line);
  if (line.starts_with('[') || line.find("\"\"\"") != std::string_view::npos ||
      line.find("'''") != std::string_view::npos)
    return "";
  std::vector<std::string_view> values;  // what stands outside of quotes after a key, or between commas
  std::size_t begin = 0, key_end = 0;    // of the value, and of the first key
  int braces = 0;
  char quote = 0;
  bool quoted = false;  // the value so far has a text in quotes
  for (std::size_t at = 0; at <= line.size(); ++at) {
    const char c = at < line.size() ? line[at] : '\n';
    if (quote != 0) {
      if (c == '\\' && quote == '"') {
        const char next = at + 1 < line.size() ? line[at + 1] : ' ';
        if (next != '"' && next != '\\')
          return "\\ has a meaning of its own in double quotes: write a path with / instead";
        ++at;
        continue;
      }
      if (c == '\n') return "a quotation mark is missing";
      if (c == quote) quote = 0;
      continue;
    }
    const bool ends = c == '\n' || c == '#';
    if (c == '=' && key_end == 0) {
      key_end = at;
      values.clear();
    } else if ((ends || c == ',' || c == ']' || c == '}') && !quoted) {
      values.push_back(line.substr(begin, at - begin));
    }
    if (c == '"' || c == '\'') {
      quote = c;
      quoted = true;
    }
    braces += c == '{' ? 1 : c == '}' ? -1 : 0;
    if (c == '=' || c == ',' || c == '[' || c == ']' || c == '{' || c == '}') {
      begin = at + 1;
      quoted = false;
    }
    if (ends) break;
  }
  if (key_end == 0 && !line.empty() && is_letter(line[0]) && line.find(':') != std::string_view::npos)
    return "a key and its value are joined by =";
  const std::string_view value = key_end > 0 ? trimmed(line.substr(key_end + 1)) : line;
  if (!value.empty() && is_digit(value[0]) && has_decimal_comma(value)) return "the decimal sign is a point: 0.5";
  if (value.starts_with('(')) return "lists stand in square brackets: [1, 2]";
  for (const std::string_view each : values)
    if (std::string hint = hint_on_value(each); !hint.empty()) return hint;
  return braces > 0 ? "a table in braces ends with } on the same line" : "";
}

}  // namespace vug
