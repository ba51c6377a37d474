#include "io/detail/toml_hazards.hpp"

#include "base/require.hpp"
#include "io/message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>

namespace vug {
namespace {

constexpr int deepest = 100;  // levels of dotted keys; cases have five

bool is_bare_key(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
}
bool is_quote(char c) {
  return c == '"' || c == '\'';
}
bool is_blank(char c) {
  return c == ' ' || c == '\t';
}
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// Scans TOML and distinguishes strings, comments, values and keys. It is right up to the first error of the text,
/// beyond which toml++ does not read either.
class HazardScan {
 public:
  HazardScan(const std::string& text, const std::string& path) : text_(text), path_(path) {}

  void run() {
    if (std::string_view(text_).starts_with(byte_order_mark)) at_ = byte_order_mark.size();
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '#') {
        skip_comment();
      } else if (is_quote(c)) {
        skip_string(c);
        line_begins_ = false;
      } else if (c == '\n') {
        begin_line();
      } else if (c == '[' && line_begins_ && depth_ == 0) {
        check_header();
      } else {
        step(c);
      }
    }
  }

 private:
  void step(char c) {
    if (is_beyond_ascii(c))
      refuse(fmt::format("not valid TOML: '{}' stands outside of quotation marks", first_letter()));
    if (!in_header_ && (c == '[' || c == '{')) ++depth_;
    if (!in_header_ && (c == ']' || c == '}') && depth_ > 0) --depth_;
    if (c == '.') {
      if (++dots_ >= deepest) refuse(fmt::format("a key has more than {} levels; no key of a case has", deepest));
    } else if (!is_bare_key(c) && !is_blank(c)) {
      dots_ = 0;
    }
    if (!is_blank(c)) line_begins_ = false;
    ++at_;
  }

  void begin_line() {
    ++at_;
    ++line_;
    dots_ = 0;
    in_header_ = false;
    line_begins_ = true;
  }

  void skip_comment() { at_ = std::min(text_.find('\n', at_), text_.size()); }

  void skip_string(char quote) {
    const std::string_view rest = std::string_view(text_).substr(at_);
    const std::string triple(3, quote);
    const bool many_lines = rest.starts_with(triple);
    at_ += many_lines ? 3 : 1;
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '\n' && !many_lines) return;  // invalid: the string does not end
      if (c == '\n') ++line_;
      if (c == '\\' && quote == '"') {
        if (at_ + 1 < text_.size() && text_[at_ + 1] == '\n') ++line_;
        at_ += 2;
        continue;
      }
      const bool end = many_lines ? std::string_view(text_).substr(at_).starts_with(triple) : c == quote;
      at_ += end && many_lines ? 3 : 1;
      if (end) break;
    }
    while (many_lines && at_ < text_.size() && text_[at_] == quote) ++at_;  // quotes that belong to the end
  }

  void check_header() {
    in_header_ = true;
    line_begins_ = false;
    ++at_;
    if (at_ < text_.size() && text_[at_] == '[') ++at_;
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
    if (at_ >= text_.size()) return;
    const char c = text_[at_];
    if (!is_bare_key(c) && !is_quote(c) && c != ']')
      refuse("not valid TOML: a table header must begin with a name, [name]");
  }

  std::string first_letter() const {
    std::size_t end = at_ + 1;
    while (end < text_.size() && end < at_ + 4 && (static_cast<unsigned char>(text_[end]) & 0xc0) == 0x80) ++end;
    return one_line(std::string_view(text_).substr(at_, end - at_));
  }

  [[noreturn]] void refuse(const std::string& problem) const {
    throw InputError(one_line(fmt::format("{}:{}:1: {}", path_, line_, problem)));
  }

  const std::string& text_;
  const std::string& path_;
  std::size_t at_ = 0;
  int line_ = 1, depth_ = 0, dots_ = 0;
  bool line_begins_ = true, in_header_ = false;
};

}  // namespace

void refuse_toml_hazards(const std::string& text, const std::string& path) {
  HazardScan(text, path).run();
}

}  // namespace vug
