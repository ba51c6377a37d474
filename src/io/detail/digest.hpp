#pragma once
// FNV-1a, 64 bits: small, well known, and sure to change with any single byte. Guards against accidents, not attacks.
#include <cstdint>
#include <string_view>

namespace vug::detail {

class Digest {
 public:
  void add(const void* data, std::size_t bytes) {
    const auto* byte = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < bytes; ++i) value_ = (value_ ^ byte[i]) * 0x100000001b3u;
  }
  void add(std::string_view text) { add(text.data(), text.size()); }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

}  // namespace vug::detail
