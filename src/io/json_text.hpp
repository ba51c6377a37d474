#pragma once
// Numbers and strings as JSON text.
#include <string>
#include <vector>

namespace vug {

/// A string in quotation marks. Bytes that are no UTF-8 would make a file unreadable; the case reader accepts only
/// UTF-8.
std::string json_string(const std::string& text);

/// All digits of a double; null when it is not finite.
std::string json_number(double value);

/// The texts of a list of what json_string gives, ["a", "b"]; as many as are whole.
std::vector<std::string> json_texts(const std::string& list);

}  // namespace vug
