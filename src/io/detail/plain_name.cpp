#include "io/detail/plain_name.hpp"

#include <algorithm>
#include <cctype>

namespace vug {

bool is_plain_name(const std::string& name) {
  const auto plain = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '+' || c == '-'; };
  return !name.empty() && name.size() <= 40 && std::isalpha(static_cast<unsigned char>(name.front())) != 0 &&
         std::all_of(name.begin(), name.end(), plain);
}

}  // namespace vug
