#include "io/detail/image_rows.hpp"

#include <fmt/format.h>
#include <png.h>

#include <csetjmp>
#include <cstring>
#include <vector>

namespace vug::detail {
namespace {

/// libpng's state, the file that it reads, and its error message.
struct PngReader {
  const BinaryFile& file;
  std::uint64_t at = 0;
  std::string message = "damaged";
  png_structp png = nullptr;
  png_infop info = nullptr;

  explicit PngReader(const BinaryFile& data) : file(data) {
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
    auto& reader = *static_cast<PngReader*>(png_get_io_ptr(png));
    const std::size_t got = reader.file.read(reader.at, out, bytes);
    reader.at += got;
    if (got < bytes) png_error(png, "the file ends too early");
  }
  // libpng leaves these functions by longjmp, so they must not hold objects with destructors.
  bool read_header() {
    if (!info || setjmp(png_jmpbuf(png))) return false;
    png_read_info(png, info);
    return true;
  }
  /// Requests rows as they are stored, one or two bytes per value, or red, green, blue and alpha of 16 bits each.
  bool transform(bool stored) {
    if (setjmp(png_jmpbuf(png))) return false;
    if (stored) {
      png_set_packing(png);
    } else {
      png_set_expand_16(png);  // palettes and 1 to 8 bits, to 16 bits
      png_set_gray_to_rgb(png);
      png_set_add_alpha(png, 0xffff, PNG_FILLER_AFTER);
    }
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
    return true;
  }
  bool read_row(png_bytep row) {
    if (setjmp(png_jmpbuf(png))) return false;
    png_read_row(png, row, nullptr);
    return true;
  }
  bool read_image(png_bytepp rows) {
    if (setjmp(png_jmpbuf(png))) return false;
    png_read_image(png, rows);
    return true;
  }
  bool read_end() {
    if (setjmp(png_jmpbuf(png))) return false;
    png_read_end(png, nullptr);
    return true;
  }
};

// Luma of a pixel in front of white, 0 to 1; red, green, blue and alpha have 16 bits each, most significant byte first.
double luma_of(const png_byte* pixel) {
  const auto channel = [pixel](int k) { return (256 * pixel[2 * k] + pixel[2 * k + 1]) / 65535.0; };
  return over_white(channel(3) * luma(channel(0), channel(1), channel(2)), channel(3), 1);
}

class PngRows : public ImageRows {
 public:
  PngRows(const std::string& path, bool labelled) : file_(path), reader_(file_) {
    if (!reader_.read_header()) fail();
    const int colours = png_get_color_type(reader_.png, reader_.info),
              bits = png_get_bit_depth(reader_.png, reader_.info);
    const bool opaque = png_get_valid(reader_.png, reader_.info, PNG_INFO_tRNS) == 0;
    header.stored = (colours == PNG_COLOR_TYPE_GRAY && opaque) || (colours == PNG_COLOR_TYPE_PALETTE && labelled);
    header.width = png_get_image_width(reader_.png, reader_.info);
    header.height = png_get_image_height(reader_.png, reader_.info);
    header.type = header.stored ? fmt::format("{} bits", bits) : "colour or transparent";
    header.white = header.stored ? static_cast<double>((1 << bits) - 1) : bits == 16 ? 65535 : 255;
    const png_uint_32 across = png_get_x_pixels_per_meter(reader_.png, reader_.info);
    const png_uint_32 up = png_get_y_pixels_per_meter(reader_.png, reader_.info);
    if (across > 0 && up > 0) header.pixel = {1.0 / across, 1.0 / up};
    value_bytes_ = header.stored ? (bits == 16 ? 2 : 1) : 8;
    interlaced_ = png_get_interlace_type(reader_.png, reader_.info) != PNG_INTERLACE_NONE;
    if (!reader_.transform(header.stored)) fail();
  }

  void read(int y, int first, std::span<double> values) override {
    const std::size_t row = value_bytes_ * header.width;
    if (interlaced_)
      read_whole(row);
    else
      for (pixels_.resize(row); next_ <= y; ++next_) read_next();
    const png_byte* pixel = pixels_.data() + (interlaced_ ? row * y : 0) + value_bytes_ * first;
    for (double& value : values) {
      value = value_bytes_ == 1   ? pixel[0]
              : value_bytes_ == 2 ? 256 * pixel[0] + pixel[1]
                                  : header.white * luma_of(pixel);
      pixel += value_bytes_;
    }
  }

 private:
  void read_next() {
    if (!reader_.read_row(pixels_.data())) fail();
    if (next_ + 1 == header.height && !reader_.read_end()) fail();
  }
  /// Reads the whole picture at once, because it is interlaced.
  void read_whole(std::size_t row) {
    if (!pixels_.empty()) return;
    pixels_.resize(row * header.height);
    std::vector<png_bytep> rows;
    for (std::int64_t y = 0; y < header.height; ++y) rows.push_back(pixels_.data() + row * y);
    if (!reader_.read_image(rows.data()) || !reader_.read_end()) fail();
  }
  [[noreturn]] void fail() const { refuse_image(file_.path(), "not a readable PNG: " + reader_.message); }

  BinaryFile file_;
  PngReader reader_;
  std::size_t value_bytes_ = 1;
  bool interlaced_ = false;
  std::int64_t next_ = 0;  ///< row that libpng returns next
  std::vector<png_byte> pixels_;
};

}  // namespace

std::unique_ptr<ImageRows> open_png(const ImageSection& image) {
  require_page(image, 1);
  return std::make_unique<PngRows>(image.file, image.labelled());
}

}  // namespace vug::detail
