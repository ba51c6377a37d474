#pragma once
// Reads rock from a picture.
#include "io/scene.hpp"

#include <optional>
#include <string>
#include <vector>

namespace vug {

/// What a picture contains, for `vug check`.
struct ImageSummary {
  std::int64_t width = 0, height = 0;                   ///< pixels of the whole page
  std::string type;                                     ///< of its values
  std::optional<double> pixel_size;                     ///< m, from the case or else from the file
  double least = 0, largest = 0;                        ///< values in the part that is used
  std::string rock;                                     ///< which values are rock, "rock below 127.5"; empty of labels
  std::vector<std::pair<std::int64_t, double>> labels;  ///< of a label map: share of the pixels of each label
};

/// Where the lattice is solid, row by row from the bottom.
struct SolidImage {
  std::vector<bool> solid;
  std::vector<std::uint8_t> mineral;  ///< number in image.minerals: in a cell of several pixels that of most of its
                                      ///< rock pixels, the lower of equal ones; empty where no label has a mineral
  ImageSummary summary;
};

/// Reads the picture of a case: crops, distinguishes rock from pore pixel by pixel, coarsens, turns, mirrors. Grey
/// values are used as they are stored, colours by their luma (Rec. 601); what is transparent counts as white. A picture
/// whose rows are stored in order is never in memory as a whole. Throws FileError for a file that cannot be read.
/// Throws InputError for one that is damaged, whose size, pixel size or type of values contradicts the case, or that
/// has a label that the case does not name or a value that is not a number.
SolidImage read_solid_image(const ImageSection& image, const LatticeSection& lattice);

}  // namespace vug
