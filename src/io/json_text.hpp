#pragma once
// Numbers and strings as JSON text.
#include <string>
#include <vector>

namespace vug {

/// A string in quotation marks. A text that is not UTF-8, which names of files may be, would make the file unreadable.
/// Each of its bytes beyond ASCII is therefore written as the character with that number; json_texts reverses this.
std::string json_string(const std::string& text);

/// A number with all digits of a double; null when it is not finite.
std::string json_number(double value);

/// The texts of a list as json_string writes them, ["a", "b"]; the last one is left out when it is incomplete.
std::vector<std::string> json_texts(const std::string& list);

}  // namespace vug
