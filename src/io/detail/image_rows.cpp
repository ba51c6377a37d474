#include "io/detail/image_rows.hpp"

#include "base/require.hpp"
#include "io/message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

namespace vug::detail {

std::unique_ptr<ImageRows> open_image(const ImageSection& image) {
  std::string name = image.file;
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  if (name.ends_with(".png")) return open_png(image);
  if (name.ends_with(".tif") || name.ends_with(".tiff")) return open_tiff(image);
  if (name.ends_with(".nrrd")) return open_nrrd(image);
  if (name.ends_with(".npy")) return open_npy(image);
  return open_raw(image);
}

void refuse_image(const std::string& path, const std::string& problem) {
  throw InputError(one_line(fmt::format("{}: {}", path, problem)));
}

void require_page(const ImageSection& image, std::int64_t pages) {
  if (image.page >= pages)
    refuse_image(image.file, fmt::format("has {} page{}, counted from 0; geometry.page = {} is none of them", pages,
                                         pages == 1 ? "" : "s", image.page));
}

std::optional<double> square_pixel(const std::string& path, const ImageHeader& header) {
  if (!header.pixel) return std::nullopt;
  const auto [width, height] = *header.pixel;
  if (!(std::abs(width - height) <= 1e-3 * width))
    refuse_image(path,
                 fmt::format("says that its pixels are {:g} x {:g} m; they must be square: resample the picture, or "
                             "give geometry.pixel_size where the file is wrong",
                             width, height));
  return width;
}

std::optional<double> metres_in(const std::string& unit) {
  constexpr std::pair<const char*, double> units[] = {{"m", 1},
                                                      {"metre", 1},
                                                      {"meter", 1},
                                                      {"cm", 1e-2},
                                                      {"mm", 1e-3},
                                                      {"um", 1e-6},
                                                      {"\u00b5m", 1e-6},
                                                      {"\u03bcm", 1e-6},
                                                      {"\\u00B5m", 1e-6},
                                                      {"micron", 1e-6},
                                                      {"microns", 1e-6},
                                                      {"micrometer", 1e-6},
                                                      {"micrometre", 1e-6},
                                                      {"nm", 1e-9},
                                                      {"inch", 0.0254},
                                                      {"centimeter", 1e-2},
                                                      {"millimeter", 1e-3},
                                                      {"millimetre", 1e-3},
                                                      {"nanometer", 1e-9}};
  for (const auto& [name, metres] : units)
    if (unit == name) return metres;
  return std::nullopt;
}

}  // namespace vug::detail
