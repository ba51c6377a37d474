#include "io/palette_picture.hpp"

#include "base/require.hpp"
#include "io/detail/files.hpp"
#include "io/detail/input_file.hpp"
#include "io/message.hpp"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cctype>
#include <csetjmp>
#include <filesystem>
#include <string_view>

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

  /// libpng leaves this function by longjmp, so nothing in it may need a destructor.
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

void require_place_for_picture(const std::string& path, const std::vector<std::string>& inputs) {
  namespace fs = std::filesystem;
  const std::string shown = one_line(path);
  std::string ending = fs::path(path).extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (ending != ".png") throw InputError(shown + ": the picture is a PNG file; give a name that ends in .png");
  if (!fs::exists(path)) return;
  std::error_code none;  // a file that cannot be looked at is no file of the case
  for (const std::string& input : inputs)
    if (fs::equivalent(path, input, none))
      throw InputError(fmt::format("{}: is a file of the case ({}), which the picture would replace", shown, input));
  if (const std::string why = detail::why_no_file(path); !why.empty()) throw InputError(shown + ": " + why);
  constexpr std::string_view signature = "\x89PNG\r\n\x1a\n";
  std::string beginning(signature.size(), '\0');
  const detail::BinaryFile file(path);
  if (file.read(0, beginning.data(), beginning.size()) < beginning.size() || beginning != signature)
    throw InputError(shown + ": is there already and is no PNG; give another name");
}

void write_palette_picture(const std::string& path, int width, std::span<const std::uint8_t> pixels,
                           std::span<const Colour> palette) {
  constexpr int enough = 600;  // pixels along the longer edge
  const int height = static_cast<int>(pixels.size()) / width;
  const int scale = std::max(1, enough / std::max(width, height));
  std::vector<png_byte> data(pixels.size() * scale);
  std::vector<png_bytep> rows;
  for (int y = height - 1; y >= 0; --y) {  // the first row of a picture is its top
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
  detail::replace_file(path, out, false);
}

}  // namespace vug
