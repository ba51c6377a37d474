#pragma once
// Rock from a picture.
#include "io/scene.hpp"

#include <string>
#include <vector>

namespace vug {

/// A picture as grey values from 0 (black) to 1 (white), row 0 at the top.
struct GreyImage {
  int width = 0, height = 0;
  std::vector<float> grey;
};

/// Reads the image of the case: a PNG (grey, colour or palette, with or without transparency, 1 to 16 bits), or width ×
/// height bytes where the case gives a raw size. Values are taken as they are stored, colours by their luma, what is
/// transparent as white. Throws FileError for a file that cannot be read or is damaged, and InputError, naming both
/// sizes, when the image does not have one pixel per node of the nx × ny lattice.
GreyImage read_image(const GeometrySection& geometry, int nx, int ny);

/// Where the lattice is solid, row by row from the bottom: values below the threshold, or the others when inverted.
std::vector<bool> solid_nodes(const GreyImage& image, const GeometrySection& geometry);

/// Both in one.
std::vector<bool> read_solid_image(const GeometrySection& geometry, int nx, int ny);

}  // namespace vug
