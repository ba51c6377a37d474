#include "io/detail/image_plain.hpp"
#include "io/detail/samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <tiffio.h>

namespace vug::detail {
namespace {

/// libtiff's state, the file that it reads, and its error message.
class TiffFile {
 public:
  explicit TiffFile(const std::string& path) : file_(path) {
    TIFFSetErrorHandler(nullptr);
    TIFFSetWarningHandler(nullptr);
    TIFFSetErrorHandlerExt(on_error);
    const auto seek = [](thandle_t self, toff_t offset, int from) -> toff_t {
      TiffFile& tiff = *static_cast<TiffFile*>(self);
      return tiff.at_ = offset + (from == SEEK_CUR ? tiff.at_ : from == SEEK_END ? tiff.file_.size() : 0);
    };
    const auto write = [](thandle_t, tdata_t, tsize_t) -> tsize_t { return 0; };
    const auto close = [](thandle_t) { return 0; };
    const auto size = [](thandle_t self) -> toff_t { return static_cast<TiffFile*>(self)->file_.size(); };
    tiff_ = TIFFClientOpen(path.c_str(), "rm", this, read, write, seek, close, size, nullptr, nullptr);
    if (tiff_ == nullptr) fail();
  }
  TiffFile(const TiffFile&) = delete;
  TiffFile& operator=(const TiffFile&) = delete;
  ~TiffFile() {
    if (tiff_ != nullptr) TIFFClose(tiff_);
  }

  TIFF* get() const { return tiff_; }
  const std::string& path() const { return file_.path(); }
  [[noreturn]] void fail() const { refuse_image(file_.path(), "not a readable TIFF: " + message_); }

  /// Value of a field with one number, or `fallback` where the file has no such field.
  template <class Value>
  Value get(ttag_t tag, Value fallback) const {
    Value value{};
    return TIFFGetField(tiff_, tag, &value) == 1 ? value : fallback;
  }
  std::uint16_t get_default(ttag_t tag) const {
    std::uint16_t value = 0;
    TIFFGetFieldDefaulted(tiff_, tag, &value);
    return value;
  }

 private:
  static tsize_t read(thandle_t self, tdata_t bytes, tsize_t count) {
    TiffFile& tiff = *static_cast<TiffFile*>(self);
    const std::size_t got = tiff.file_.read(tiff.at_, bytes, static_cast<std::size_t>(count));
    tiff.at_ += got;
    return static_cast<tsize_t>(got);
  }
  static void on_error(thandle_t self, const char* module, const char* format, va_list arguments) {
    char text[256];
    std::vsnprintf(text, sizeof text, format, arguments);
    if (self != nullptr) static_cast<TiffFile*>(self)->message_ = fmt::format("{}: {}", module, text);
  }

  BinaryFile file_;
  std::uint64_t at_ = 0;
  std::string message_ = "damaged";
  TIFF* tiff_ = nullptr;
};

SampleType type_of(const TiffFile& tiff) {
  const int bits = tiff.get_default(TIFFTAG_BITSPERSAMPLE), format = tiff.get_default(TIFFTAG_SAMPLEFORMAT);
  if (format == SAMPLEFORMAT_IEEEFP && bits == 32) return SampleType::float32;
  if (format == SAMPLEFORMAT_IEEEFP && bits == 64) return SampleType::float64;
  const bool sign = format == SAMPLEFORMAT_INT;
  if (sign || format == SAMPLEFORMAT_UINT || format == SAMPLEFORMAT_VOID) {
    if (bits == 8) return sign ? SampleType::int8 : SampleType::uint8;
    if (bits == 16) return sign ? SampleType::int16 : SampleType::uint16;
    if (bits == 32) return sign ? SampleType::int32 : SampleType::uint32;
  }
  refuse_image(tiff.path(), fmt::format("has values of {} bits (sample format {}); whole numbers of 8, 16 and 32 bits "
                                        "and floating-point ones of 32 and 64 are read",
                                        bits, format));
}

/// Width and height of a pixel, m, from the resolution and its unit; ImageJ writes the unit into the description.
std::optional<std::array<double, 2>> pixel_of(const TiffFile& tiff) {
  const float across = tiff.get<float>(TIFFTAG_XRESOLUTION, 0), up = tiff.get<float>(TIFFTAG_YRESOLUTION, 0);
  if (!(across > 0) || !(up > 0)) return std::nullopt;
  const int unit = tiff.get_default(TIFFTAG_RESOLUTIONUNIT);
  std::optional<double> metres;
  if (unit == RESUNIT_INCH) metres = 0.0254;
  if (unit == RESUNIT_CENTIMETER) metres = 0.01;
  const char* text = tiff.get<const char*>(TIFFTAG_IMAGEDESCRIPTION, nullptr);
  const std::string description = text != nullptr ? text : "";
  if (description.starts_with("ImageJ=")) {
    const std::size_t at = description.find("\nunit=");
    metres = at == std::string::npos ? std::nullopt
                                     : metres_in(description.substr(at + 6, description.find('\n', at + 6) - at - 6));
  }
  if (!metres) return std::nullopt;
  return std::array{*metres / across, *metres / up};
}

/// Role of the last value of a pixel. none: there is none; apart: the colour must still be multiplied by it;
/// multiplied: it already is.
enum class Opacity { none, apart, multiplied };

/// Properties of a page that this reader needs.
struct TiffPage {
  ImageHeader header;
  SampleType type;
  int samples;
  int colours;  ///< the first of these: 1 of grey, or red, green and blue
  bool white_is_zero;
  Opacity opacity = Opacity::none;
};

/// Opacity of a page. Throws InputError where values per pixel are of unknown meaning.
Opacity opacity_of(const TiffFile& tiff, const TiffPage& page) {
  if (page.samples == page.colours) return Opacity::none;
  std::uint16_t count = 0, *kinds = nullptr;
  TIFFGetField(tiff.get(), TIFFTAG_EXTRASAMPLES, &count, &kinds);
  const int kind = count == 1 && kinds != nullptr ? kinds[0] : EXTRASAMPLE_UNSPECIFIED;
  if (page.samples != page.colours + 1 || kind == EXTRASAMPLE_UNSPECIFIED)
    refuse_image(tiff.path(), fmt::format("has {} values per pixel and does not say that those after {} are one for "
                                          "opacity; save it without them",
                                          page.samples, page.colours == 3 ? "red, green and blue" : "grey"));
  if (page.header.white == 0)
    refuse_image(tiff.path(),
                 "has transparent pixels of values with a sign, or floating-point ones, whose white is not "
                 "known; save it without transparency");
  return kind == EXTRASAMPLE_ASSOCALPHA ? Opacity::multiplied : Opacity::apart;
}

TiffPage page_of(const TiffFile& tiff, bool labelled) {
  TiffPage page{{}, type_of(tiff), tiff.get_default(TIFFTAG_SAMPLESPERPIXEL), 1, false, Opacity::none};
  const int photometric = tiff.get<std::uint16_t>(TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  const bool grey = photometric == PHOTOMETRIC_MINISBLACK || photometric == PHOTOMETRIC_MINISWHITE;
  if (!(grey && page.samples >= 1) && !(photometric == PHOTOMETRIC_RGB && page.samples >= 3) &&
      !(photometric == PHOTOMETRIC_PALETTE && page.samples == 1 && labelled))
    refuse_image(tiff.path(), fmt::format("has {} values per pixel of the kind {} (photometric interpretation); grey, "
                                          "red with green and blue, and for labels palettes are read",
                                          page.samples, photometric));
  if (page.samples > 1 && tiff.get_default(TIFFTAG_PLANARCONFIG) != PLANARCONFIG_CONTIG)
    refuse_image(tiff.path(), "keeps its colours in separate planes; they must be together");
  if (tiff.get_default(TIFFTAG_ORIENTATION) != ORIENTATION_TOPLEFT)
    refuse_image(tiff.path(), "does not begin at its upper left corner; save it so that it does");
  page.header = plain_header(tiff.get<std::uint32_t>(TIFFTAG_IMAGEWIDTH, 0),
                             tiff.get<std::uint32_t>(TIFFTAG_IMAGELENGTH, 0), page.type);
  page.header.pixel = pixel_of(tiff);
  page.colours = photometric == PHOTOMETRIC_RGB ? 3 : 1;
  page.white_is_zero = photometric == PHOTOMETRIC_MINISWHITE && !labelled;  // labels are values as stored
  if (page.white_is_zero && page.header.white == 0)
    refuse_image(tiff.path(), "has values with a sign, or floating-point ones, of which 0 is white");
  if (page.samples > 1) {
    page.opacity = opacity_of(tiff, page);
    page.header.type = std::string(page.colours == 3 ? "colours of " : "grey with opacity of ") + page.header.type;
    page.header.stored = false;
  }
  return page;
}

/// Rows that libtiff reads: compressed strips, tiles, colours.
class TiffRows : public ImageRows {
 public:
  TiffRows(std::unique_ptr<TiffFile> tiff, const TiffPage& page) : tiff_(std::move(tiff)), page_(page) {
    header = page.header;
    if (TIFFIsTiled(tiff_->get()) != 0) {
      tile_width_ = tiff_->get<std::uint32_t>(TIFFTAG_TILEWIDTH, 0);
      tile_height_ = tiff_->get<std::uint32_t>(TIFFTAG_TILELENGTH, 0);
    } else {
      TIFFGetFieldDefaulted(tiff_->get(), TIFFTAG_ROWSPERSTRIP, &strip_rows_);
    }
    const tmsize_t unit = tile_width_ > 0 ? TIFFTileSize(tiff_->get()) : TIFFScanlineSize(tiff_->get());
    constexpr tmsize_t most = tmsize_t{1} << 30;
    if (unit <= 0 || unit > most || (tile_width_ > 0 && tile_height_ == 0) || strip_rows_ == 0) tiff_->fail();
    part_.resize(static_cast<std::size_t>(unit));
  }

  void read(int y, int first, std::span<double> values) override {
    if (tile_width_ > 0)
      read_tiles(y, first, static_cast<int>(values.size()));
    else
      read_strip(y, first, values.size());
    if (page_.samples == 1) {
      decode(row_.data(), page_.type, false, values);
      if (page_.white_is_zero)
        for (double& value : values) value = header.white - value;
      return;
    }
    samples_.resize(values.size() * page_.samples);
    decode(row_.data(), page_.type, false, samples_);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = seen(&samples_[i * page_.samples]);
  }

 private:
  double seen(const double* pixel) const {
    const double grey = page_.colours == 3 ? luma(pixel[0], pixel[1], pixel[2]) : pixel[0];
    const double light = page_.white_is_zero ? header.white - grey : grey;
    if (page_.opacity == Opacity::none) return light;
    const double opacity = pixel[page_.colours] / header.white;
    return over_white(page_.opacity == Opacity::apart ? opacity * light : light, opacity, header.white);
  }

  std::size_t pixel_bytes() const { return bytes_of(page_.type) * page_.samples; }

  /// Reads up to row `y`: rows of a compressed strip can only be read in order.
  void read_strip(int y, int first, std::size_t count) {
    const int begin = y - y % static_cast<int>(std::min<std::uint32_t>(strip_rows_, 1u << 30));
    if (next_ < begin) next_ = begin;
    for (; next_ <= y; ++next_)
      if (TIFFReadScanline(tiff_->get(), part_.data(), static_cast<std::uint32_t>(next_), 0) != 1) tiff_->fail();
    if (part_.size() < (first + count) * pixel_bytes()) tiff_->fail();
    const unsigned char* from = part_.data() + first * pixel_bytes();
    row_.assign(from, from + count * pixel_bytes());
  }

  /// Reads row `y` from the needed tiles of its band, which are kept for the next rows.
  void read_tiles(int y, int first, int count) {
    const int width = static_cast<int>(tile_width_), height = static_cast<int>(tile_height_);
    const int left = first / width, right = (first + count - 1) / width, band = y / height;
    const std::size_t row = pixel_bytes() * tile_width_;
    if (part_.size() < row * tile_height_) tiff_->fail();
    if (band != band_) {
      band_ = band;
      tiles_.resize(part_.size() * (right - left + 1));
      for (int t = left; t <= right; ++t)
        if (TIFFReadTile(tiff_->get(), tiles_.data() + part_.size() * (t - left), static_cast<std::uint32_t>(t * width),
                         static_cast<std::uint32_t>(band * height), 0, 0) < 0)
          tiff_->fail();
    }
    row_.clear();
    for (int t = left; t <= right; ++t) {
      const unsigned char* tile = tiles_.data() + part_.size() * (t - left) + row * (y % height);
      const int from = std::max(first - t * width, 0), to = std::min(first + count - t * width, width);
      row_.insert(row_.end(), tile + from * pixel_bytes(), tile + to * pixel_bytes());
    }
  }

  std::unique_ptr<TiffFile> tiff_;
  TiffPage page_;
  std::uint32_t tile_width_ = 0, tile_height_ = 0, strip_rows_ = 1;
  int next_ = 0, band_ = -1;
  std::vector<unsigned char> part_, tiles_, row_;  ///< a tile or a row of libtiff's; a band of tiles; the requested row
  std::vector<double> samples_;
};

/// Rows of uncompressed grey values in strips, read without libtiff at the offsets that the file gives.
std::unique_ptr<ImageRows> plain_rows(const TiffFile& tiff, const TiffPage& page) {
  std::uint32_t rows = 0;
  TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_ROWSPERSTRIP, &rows);
  std::uint64_t* offsets = nullptr;
  const std::uint32_t count = TIFFNumberOfStrips(tiff.get());
  if (TIFFGetField(tiff.get(), TIFFTAG_STRIPOFFSETS, &offsets) != 1 || offsets == nullptr || rows == 0) tiff.fail();
  PlainStrips strips{{offsets, offsets + count}, std::min<std::int64_t>(rows, page.header.height)};
  return std::make_unique<PlainRows>(tiff.path(), page.header, std::move(strips), page.type,
                                     TIFFIsByteSwapped(tiff.get()) != 0, page.white_is_zero);
}

}  // namespace

std::unique_ptr<ImageRows> open_tiff(const ImageSection& image) {
  auto tiff = std::make_unique<TiffFile>(image.file);
  if (image.page > 0) require_page(image, TIFFNumberOfDirectories(tiff->get()));
  if (image.page > 0 && TIFFSetDirectory(tiff->get(), static_cast<tdir_t>(image.page)) != 1) tiff->fail();
  const TiffPage page = page_of(*tiff, image.labelled());
  if (page.header.width < 1 || page.header.height < 1) tiff->fail();
  if (tiff->get_default(TIFFTAG_COMPRESSION) == COMPRESSION_NONE && TIFFIsTiled(tiff->get()) == 0 &&
      tiff->get_default(TIFFTAG_FILLORDER) == FILLORDER_MSB2LSB && page.samples == 1)
    return plain_rows(*tiff, page);
  return std::make_unique<TiffRows>(std::move(tiff), page);
}

}  // namespace vug::detail
