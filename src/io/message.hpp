#pragma once
// Makes text from outside safe for messages: a terminal only shows it.
#include <cstddef>
#include <string>
#include <string_view>

namespace vug {

/// Whether `text` is UTF-8.
bool is_utf8(std::string_view text);

/// `text` with a space in place of every control character (C0, C1, DEL) and every mark that ends a line or changes the
/// writing direction, and a '?' in place of every byte that is not UTF-8.
std::string one_line(std::string_view text);

/// The beginning of one_line(text), at most `most` bytes; " ..." shows that something was cut off.
std::string excerpt(std::string_view text, std::size_t most = 60);

}  // namespace vug
