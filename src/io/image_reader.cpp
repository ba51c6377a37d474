#include "io/image_reader.hpp"

#include "io/detail/input_file.hpp"
#include "io/message.hpp"
#include "kernels/require.hpp"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstring>
#include <string_view>

namespace vug {

namespace {

void require_size(const std::string& path, std::int64_t width, std::int64_t height, int nx, int ny) {
  if (width != nx || height != ny)
    throw InputError(fmt::format("{}: the image has {} x {} pixels, the lattice {} x {} nodes; they must agree", path,
                                 width, height, nx, ny));
}

/// libpng's state, the bytes it reads, and what it had to say.
struct PngReader {
  std::string_view rest;
  std::string message = "damaged";
  png_structp png = nullptr;
  png_infop info = nullptr;

  explicit PngReader(std::string_view data) : rest(data) {
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, on_error, [](png_structp, png_const_charp) {});
    info = png ? png_create_info_struct(png) : nullptr;
    if (info) png_set_read_fn(png, this, read);
  }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }

  static void on_error(png_structp png, png_const_charp text) {
    static_cast<PngReader*>(png_get_error_ptr(png))->message = text;
    std::longjmp(png_jmpbuf(png), 1);
  }
  static void read(png_structp png, png_bytep out, std::size_t bytes) {
    auto& rest = static_cast<PngReader*>(png_get_io_ptr(png))->rest;
    if (bytes > rest.size()) png_error(png, "the file ends too early");
    std::memcpy(out, rest.data(), bytes);
    rest.remove_prefix(bytes);
  }
  // libpng leaves these two by a jump, so nothing in them may need a destructor.
  bool read_header() {
    if (!info || setjmp(png_jmpbuf(png))) return false;
    png_read_info(png, info);
    return true;
  }
  bool read_rows(png_bytepp rows) {
    if (setjmp(png_jmpbuf(png))) return false;
    png_set_expand_16(png);  // palettes and 1 to 8 bits, to 16 bits
    png_set_gray_to_rgb(png);
    png_set_add_alpha(png, 0xffff, PNG_FILLER_AFTER);
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
    png_read_image(png, rows);
    png_read_end(png, nullptr);
    return true;
  }
};

// Luma of a pixel of red, green, blue and alpha, 16 bits each, most significant byte first, over white.
float grey_of(const png_byte* pixel) {
  const auto channel = [pixel](int k) { return (256 * pixel[2 * k] + pixel[2 * k + 1]) / 65535.0; };
  const double luma = 0.299 * channel(0) + 0.587 * channel(1) + 0.114 * channel(2);
  return static_cast<float>(channel(3) * luma + 1 - channel(3));
}

GreyImage read_png(const std::string& data, const std::string& path, int nx, int ny) {
  PngReader reader(data);
  const auto fail = [&] {
    throw InputError(one_line(fmt::format("{}: not a readable PNG: {}", path, reader.message)));
  };
  if (!reader.read_header()) fail();
  require_size(path, png_get_image_width(reader.png, reader.info), png_get_image_height(reader.png, reader.info), nx,
               ny);
  constexpr std::size_t pixel_bytes = 8;
  std::vector<png_byte> pixels(pixel_bytes * static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny));
  std::vector<png_bytep> rows;
  for (int y = 0; y < ny; ++y) rows.push_back(&pixels[pixel_bytes * static_cast<std::size_t>(y) * nx]);
  if (!reader.read_rows(rows.data())) fail();
  GreyImage image{nx, ny, {}};
  image.grey.reserve(pixels.size() / pixel_bytes);
  for (std::size_t i = 0; i < pixels.size(); i += pixel_bytes) image.grey.push_back(grey_of(&pixels[i]));
  return image;
}

GreyImage read_raw(const std::string& data, const std::string& path, std::array<int, 2> size, int nx, int ny) {
  require_size(path, size[0], size[1], nx, ny);
  const auto wanted = static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny);
  if (data.size() != wanted)
    throw InputError(fmt::format("{}: the file has {} bytes, a raw image of {} x {} pixels has {}", path, data.size(),
                                 nx, ny, wanted));
  GreyImage image{nx, ny, std::vector<float>(wanted)};
  std::transform(data.begin(), data.end(), image.grey.begin(),
                 [](char value) { return static_cast<float>(static_cast<unsigned char>(value)) / 255; });
  return image;
}

}  // namespace

GreyImage read_image(const GeometrySection& geometry, int nx, int ny) {
  const auto& path = geometry.image_file;
  const auto data = detail::read_input_file(path);
  const bool raw = geometry.raw_size[0] != 0 || geometry.raw_size[1] != 0;
  return raw ? read_raw(data, path, geometry.raw_size, nx, ny) : read_png(data, path, nx, ny);
}

std::vector<bool> solid_nodes(const GreyImage& image, const GeometrySection& geometry) {
  std::vector<bool> solid(image.grey.size());
  for (int y = 0; y < image.height; ++y) {
    const auto row = static_cast<std::size_t>(image.width) * y;
    const auto from = static_cast<std::size_t>(image.width) * (image.height - 1 - y);  // the picture begins at the top
    for (int x = 0; x < image.width; ++x)
      solid[row + x] = (image.grey[from + x] < geometry.image_threshold) != geometry.image_invert;
  }
  return solid;
}

std::vector<bool> read_solid_image(const GeometrySection& geometry, int nx, int ny) {
  return solid_nodes(read_image(geometry, nx, ny), geometry);
}

}  // namespace vug
