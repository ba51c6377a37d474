#pragma once
// Small pictures for people, with few colours and a pixel for each node.
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace vug {

using Colour = std::array<std::uint8_t, 3>;  ///< red, green, blue

/// Throws InputError unless a picture may be written to `path`, which must be a new PNG file, or another PNG that is
/// not one of `inputs`. Throws FileError.
void require_place_for_picture(const std::string& path, const std::vector<std::string>& inputs);

/// Writes `path` as a PNG of `width` columns; `pixels` are indices into `palette`, row by row from the bottom. Small
/// pictures are enlarged. Throws FileError.
void write_palette_picture(const std::string& path, int width, std::span<const std::uint8_t> pixels,
                           std::span<const Colour> palette);

}  // namespace vug
