#pragma once
// Numbers and strings as JSON text.
#include <string>
#include <vector>

namespace vug {

/// A string in quotation marks. A text that is no UTF-8, as names of files may be, would make a file unreadable: its
/// bytes beyond ASCII become the characters of these numbers, which json_texts turns back.
std::string json_string(const std::string& text);

/// All digits of a double; null when it is not finite.
std::string json_number(double value);

/// The texts of a list of what json_string gives, ["a", "b"]; as many as are whole.
std::vector<std::string> json_texts(const std::string& list);

}  // namespace vug
