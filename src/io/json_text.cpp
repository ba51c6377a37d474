#include "io/json_text.hpp"

#include "io/message.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <utility>

namespace vug {

std::string json_string(const std::string& text) {
  const bool foreign = !is_utf8(text);
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      out += {'\\', c};
    else if (c == '\n')
      out += "\\n";
    else if (const unsigned byte = static_cast<unsigned char>(c); byte < 0x20 || (foreign && byte > 0x7e))
      out += fmt::format("\\u{:04x}", byte);
    else
      out += c;
  }
  return out + "\"";
}

std::vector<std::string> json_texts(const std::string& list) {
  std::vector<std::string> texts;
  std::string text;
  bool inside = false;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const char c = list[i];
    if (c == '"') {
      if (inside) texts.push_back(std::move(text));
      text.clear();
      inside = !inside;
    } else if (!inside) {
      continue;
    } else if (c != '\\') {
      text += c;
    } else if (list.compare(i + 1, 1, "u") == 0) {  // the code of one byte: the last two of the four digits
      text += static_cast<char>(std::strtol(list.substr(i + 2, 4).c_str(), nullptr, 16));
      i += 5;
    } else if (++i < list.size()) {
      text += list[i] == 'n' ? '\n' : list[i];
    }
  }
  return texts;
}

std::string json_number(double value) {
  return std::isfinite(value) ? fmt::format("{:.17g}", value) : "null";
}

}  // namespace vug
