#pragma once
// Numbers as they are stored in files.
#include "io/scene.hpp"

#include <cstddef>
#include <span>

namespace vug::detail {

/// Bytes of one value.
std::size_t bytes_of(SampleType type);

/// "uint16", as in the case file.
const char* name_of(SampleType type);

/// Largest value of an unsigned type in which pictures are stored, 255 for uint8; 0 for all other types.
double white_of(SampleType type);

/// Reads values of `type` from `bytes`, as many as `values` holds; `swapped` when their byte order is not this
/// machine's.
void decode(const unsigned char* bytes, SampleType type, bool swapped, std::span<double> values);

}  // namespace vug::detail
