#pragma once
// Rock from a picture.
#include "io/scene.hpp"

#include <optional>
#include <string>
#include <vector>

namespace vug {

/// What a picture turned out to hold, for `vug check`.
struct ImageSummary {
  std::int64_t width = 0, height = 0;                   ///< pixels of the whole page
  std::string type;                                     ///< of its values
  std::optional<double> pixel_size;                     ///< m, of the case or else of the file
  double least = 0, largest = 0;                        ///< values in the part that is used
  std::vector<std::pair<std::int64_t, double>> labels;  ///< of a label map: share of the pixels of each label
};

/// Where the lattice is solid, row by row from the bottom.
struct SolidImage {
  std::vector<bool> solid;
  std::vector<std::uint8_t> mineral;  ///< by image.minerals, in a cell of several pixels that of most of its rock
                                      ///< pixels, of as many the lower number; empty where no label has one
  ImageSummary summary;
};

/// Reads the picture of a case: crops, tells rock from pore pixel by pixel, coarsens, turns, mirrors. Grey values are
/// taken as they are stored, colours by their luma (Rec. 601), what is transparent as white; a picture whose rows come
/// in order is never held as a whole. Throws FileError for a file that cannot be read, and InputError for one that is
/// damaged, has a size, a pixel size or a type of values that contradicts the case, a label that the case does not
/// name, or a value that is no number.
SolidImage read_solid_image(const ImageSection& image, const LatticeSection& lattice);

}  // namespace vug
