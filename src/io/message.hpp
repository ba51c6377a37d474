#pragma once
// What comes from outside, as it may stand in a message: a terminal shows it and does nothing else.
#include <cstddef>
#include <string>
#include <string_view>

namespace vug {

/// Whether `text` is UTF-8.
bool is_utf8(std::string_view text);

/// `text` with a space for every control character (C0, C1, DEL), every mark that ends a line or turns the direction of
/// writing, and a '?' for every byte that is no UTF-8.
std::string one_line(std::string_view text);

/// The beginning of `text`, one_line of at most `most` bytes; what was cut off is shown by " ...".
std::string excerpt(std::string_view text, std::size_t most = 60);

}  // namespace vug
