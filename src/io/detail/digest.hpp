#pragma once
// Digests that detect accidental changes (not attacks).
#include <cstdint>
#include <cstring>
#include <string_view>

namespace vug::detail {

/// FNV-1a, 64 bits, byte by byte, as published: for names and short texts.
class TextDigest {
 public:
  void add(std::string_view text) {
    for (const char c : text) value_ = (value_ ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

/// A digest of large data, eight bytes at a time. Each word is mixed in by an invertible step, so that a change within
/// a single word always changes the value. Pieces of data must be multiples of eight bytes long, except the last one.
class DataDigest {
 public:
  void add(std::string_view data) {
    for (; data.size() >= sizeof(std::uint64_t); data.remove_prefix(sizeof(std::uint64_t))) mix(word(data));
    if (!data.empty()) mix(word(data) ^ std::uint64_t{data.size()} << 56);
  }
  std::uint64_t value() const { return value_; }

 private:
  static std::uint64_t word(std::string_view data) {
    std::uint64_t out = 0;
    std::memcpy(&out, data.data(), data.size() < sizeof(out) ? data.size() : sizeof(out));
    return out;
  }
  void mix(std::uint64_t word) {
    value_ = (value_ ^ word) * 0x9e3779b97f4a7c15u;
    value_ ^= value_ >> 32;  // otherwise the highest bits of two words could cancel
  }
  std::uint64_t value_ = 0x243f6a8885a308d3u;
};

}  // namespace vug::detail
