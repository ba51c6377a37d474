#pragma once
// A picture that is read row by row from the top, so that a crop of a large one costs the memory of a few rows.
#include "io/detail/input_file.hpp"
#include "io/scene.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace vug::detail {

struct ImageHeader {
  std::int64_t width = 0, height = 0;
  std::string type;    ///< of the values, for messages: "uint16", "colour"
  double white = 0;    ///< the value of white; 0 where the type has none
  bool stored = true;  ///< whether values are those of the file; not for colours
  /// Width and height of a pixel, m, where the file gives them.
  std::optional<std::array<double, 2>> pixel{};
};

/// One page of a picture in any format. Throws InputError `path: what is wrong`.
class ImageRows {
 public:
  virtual ~ImageRows() = default;
  /// Sets `values` to those of row `y` from column `first` on. Rows must be read from the top down.
  virtual void read(int y, int first, std::span<double> values) = 0;
  ImageHeader header;
};

/// Opens the picture that the case names, by the ending of its name: .png, .tif, .tiff, .nrrd, .npy; others are raw.
std::unique_ptr<ImageRows> open_image(const ImageSection& image);

std::unique_ptr<ImageRows> open_png(const ImageSection& image);
std::unique_ptr<ImageRows> open_tiff(const ImageSection& image);
std::unique_ptr<ImageRows> open_nrrd(const ImageSection& image);
std::unique_ptr<ImageRows> open_npy(const ImageSection& image);
std::unique_ptr<ImageRows> open_raw(const ImageSection& image);

/// Luma of a colour (Rec. 601), in the unit of its parts.
constexpr double luma(double red, double green, double blue) {
  return 0.299 * red + 0.587 * green + 0.114 * blue;
}
/// Brightness of a pixel in front of white; `light` is already multiplied by `opacity` (0 ... 1).
constexpr double over_white(double light, double opacity, double white) {
  return light + white - opacity * white;
}

/// Throws InputError `path: problem`, on one line.
[[noreturn]] void refuse_image(const std::string& path, const std::string& problem);

/// Throws InputError unless the file has the page that the case asks for.
void require_page(const ImageSection& image, std::int64_t pages);

/// Edge of a square pixel, m, where the file gives one; throws InputError where its width and height differ.
std::optional<double> square_pixel(const std::string& path, const ImageHeader& header);

/// Metres in the unit of length of that name ("mm", "micron", "µm", ...); empty where it is no unit of length.
std::optional<double> metres_in(const std::string& unit);

}  // namespace vug::detail
