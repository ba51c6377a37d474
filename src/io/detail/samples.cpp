#include "io/detail/samples.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

namespace vug::detail {
namespace {

/// Calls `use` with a value of the C++ type that belongs to `type`.
template <class Use>
auto with_type(SampleType type, const Use& use) {
  switch (type) {
    case SampleType::uint8:
      return use(std::uint8_t{});
    case SampleType::uint16:
      return use(std::uint16_t{});
    case SampleType::uint32:
      return use(std::uint32_t{});
    case SampleType::uint64:
      return use(std::uint64_t{});
    case SampleType::int8:
      return use(std::int8_t{});
    case SampleType::int16:
      return use(std::int16_t{});
    case SampleType::int32:
      return use(std::int32_t{});
    case SampleType::int64:
      return use(std::int64_t{});
    case SampleType::float32:
      return use(float{});
    default:
      return use(double{});
  }
}

}  // namespace

std::size_t bytes_of(SampleType type) {
  return with_type(type, [](auto value) { return sizeof(value); });
}

const char* name_of(SampleType type) {
  constexpr std::array names = {"uint8", "uint16", "uint32", "uint64",  "int8",
                                "int16", "int32",  "int64",  "float32", "float64"};
  return names[static_cast<std::size_t>(type)];
}

double white_of(SampleType type) {
  if (type == SampleType::uint8) return 255;
  if (type == SampleType::uint16) return 65535;
  return type == SampleType::uint32 ? 4294967295.0 : 0;
}

void decode(const unsigned char* bytes, SampleType type, bool swapped, std::span<double> values) {
  with_type(type, [&](auto sample) {
    unsigned char one[sizeof(sample)];
    for (double& value : values) {
      std::memcpy(one, bytes, sizeof(sample));
      if (swapped) std::reverse(one, one + sizeof(sample));
      std::memcpy(&sample, one, sizeof(sample));
      value = static_cast<double>(sample);
      bytes += sizeof(sample);
    }
  });
}

}  // namespace vug::detail
