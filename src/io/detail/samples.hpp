#pragma once
// Numbers as they lie in files.
#include "io/scene.hpp"

#include <cstddef>
#include <span>

namespace vug::detail {

/// Bytes of one value.
std::size_t bytes_of(SampleType type);

/// "uint16", as in the case file.
const char* name_of(SampleType type);

/// Largest value of an unsigned type that pictures are stored in, 255 for uint8; 0 for all others.
double white_of(SampleType type);

/// Values of `type` from `bytes`, as many as `values` holds; `swapped` when they are not in this machine's byte order.
void decode(const unsigned char* bytes, SampleType type, bool swapped, std::span<double> values);

}  // namespace vug::detail
