#include "io/palette_picture.hpp"

#include "io/detail/files.hpp"
#include "io/detail/input_file.hpp"
#include "kernels/base/require.hpp"

#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <filesystem>

namespace vug {

namespace {

void append(png_structp png, png_bytep data, std::size_t bytes) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), bytes);
}

struct PngWriter {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  PngWriter() = default;
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;
  ~PngWriter() { png_destroy_write_struct(&png, &info); }

  /// libpng leaves this by a jump, so nothing in it may need a destructor.
  bool write(std::string& out, int width, int height, png_colorp colours, int count, png_bytepp rows) {
    if (!info || setjmp(png_jmpbuf(png))) return false;
    png_set_write_fn(png, &out, append, nullptr);
    png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), 8,
                 PNG_COLOR_TYPE_PALETTE, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_PLTE(png, info, colours, count);
    png_set_rows(png, info, rows);
    png_write_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
    return true;
  }
};

}  // namespace

void write_palette_picture(const std::string& path, int width, std::span<const std::uint8_t> pixels,
                           std::span<const Colour> palette) {
  constexpr int enough = 600;  // pixels along the longer edge
  const int height = static_cast<int>(pixels.size()) / width;
  const int scale = std::max(1, enough / std::max(width, height));
  std::vector<png_byte> data(pixels.size() * scale);
  std::vector<png_bytep> rows;
  for (int y = height - 1; y >= 0; --y) {  // a picture begins at its top
    png_byte* row = data.data() + static_cast<std::size_t>(y) * width * scale;
    for (int x = 0; x < width * scale; ++x) row[x] = pixels[static_cast<std::size_t>(y) * width + x / scale];
    rows.insert(rows.end(), static_cast<std::size_t>(scale), row);
  }
  std::vector<png_color> colours;
  for (const Colour& colour : palette) colours.push_back({colour[0], colour[1], colour[2]});
  std::string out;
  if (!PngWriter().write(out, width * scale, height * scale, colours.data(), static_cast<int>(colours.size()),
                         rows.data()))
    throw FileError(path + ": cannot make the picture");
  if (std::filesystem::exists(path))
    if (const std::string why = detail::why_no_file(path); !why.empty()) throw FileError(path + ": " + why);
  detail::replace_file(path, out, false);
}

}  // namespace vug
