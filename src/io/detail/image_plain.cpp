#include "io/detail/image_plain.hpp"

#include "io/detail/samples.hpp"

#include <fmt/format.h>

#include <bit>

namespace vug::detail {

PlainRows::PlainRows(const std::string& path, ImageHeader what, PlainStrips strips, SampleType type, bool swapped,
                     bool white_is_zero)
    : file_(path), strips_(std::move(strips)), type_(type), swapped_(swapped), white_is_zero_(white_is_zero) {
  header = std::move(what);
}

void PlainRows::read(int y, int first, std::span<double> values) {
  const std::uint64_t size = bytes_of(type_);
  const std::uint64_t at =
      strips_.begin[y / strips_.rows] +
      size * (static_cast<std::uint64_t>(y % strips_.rows) * static_cast<std::uint64_t>(header.width) + first);
  bytes_.resize(size * values.size());
  if (at > file_.size() || file_.read(at, bytes_.data(), bytes_.size()) < bytes_.size())
    refuse_image(file_.path(), "the file ends too early");
  decode(bytes_.data(), type_, swapped_, values);
  if (white_is_zero_)
    for (double& value : values) value = header.white - value;
}

bool is_swapped(bool big_endian) {
  return big_endian != (std::endian::native == std::endian::big);
}

ImageHeader plain_header(std::int64_t width, std::int64_t height, SampleType type) {
  return {width, height, name_of(type), white_of(type), true, {}};
}

std::unique_ptr<ImageRows> open_raw(const ImageSection& image) {
  const auto [width, height] = image.raw_size;
  const std::uint64_t page = bytes_of(image.raw_type) * static_cast<std::uint64_t>(width) * height;
  const std::uint64_t wanted = page * image.raw_pages, size = BinaryFile(image.file).size();
  if (size != wanted) {
    const std::string pages = image.raw_pages > 1 ? fmt::format(" and {} pages", image.raw_pages) : "";
    refuse_image(image.file, fmt::format("the file has {} bytes, a raw image of {} x {} pixels{} of {} has {}", size,
                                         width, height, pages, name_of(image.raw_type), wanted));
  }
  require_page(image, image.raw_pages);
  return std::make_unique<PlainRows>(image.file, plain_header(width, height, image.raw_type),
                                     PlainStrips{{page * image.page}, height}, image.raw_type,
                                     is_swapped(image.raw_big_endian));
}

}  // namespace vug::detail
