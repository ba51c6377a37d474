// Pictures of every format: values as they are stored, pages, tiles and transparency.
#include "unit/image_setup.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tiffio.h>

namespace vug {
namespace {

using test::image;
using test::lattice;
using test::make;
using test::refusal;
using test::solid_of;
using test::values_of;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

// make_image.py draws 4 x 3 pixels: 0 ... 11 times a step.
TEST(ImageReader, ReadsEveryFormatAsItIsStored) {
  const test::TemporaryFolder folder;
  const std::vector<std::tuple<std::string, std::string, double>> kinds = {{"pillow_u1_raw", "tif", 23},
                                                                           {"pillow_u1_tiff_lzw", "tiff", 23},
                                                                           {"pillow_u2_tiff_deflate", "tif", 5957},
                                                                           {"pillow_i4_raw", "tif", 100000},
                                                                           {"pillow_f4_tiff_lzw", "tif", 0.25},
                                                                           {"rgb", "tif", 23},
                                                                           {"little", "tif", 5957},
                                                                           {"big", "TIF", 5957},
                                                                           {"fill_order_2", "tif", 23},
                                                                           {"nrrd_raw", "nrrd", 5957},
                                                                           {"nrrd_gzip", "nrrd", 5957},
                                                                           {"nrrd_big", "nrrd", 5957},
                                                                           {"npy_u1", "npy", 1},
                                                                           {"npy_>u2", "npy", 1},
                                                                           {"npy_<i4", "npy", 1},
                                                                           {"npy_<i8", "npy", 1},
                                                                           {"npy_f4", "npy", 1},
                                                                           {"npy_>f8", "npy", 1}};
  for (const auto& [kind, ending, step] : kinds) {
    const auto path = folder / ("a." + ending);
    ASSERT_EQ(make("make_image.py", path, "'" + kind + "'"), 0);
    const auto values = values_of(image(path));
    ASSERT_EQ(values.size(), 12u) << kind;
    for (int i = 0; i < 12; ++i) EXPECT_NEAR(values[i], step * i, 1e-9) << kind << ' ' << i;
    std::vector<double> part(2);
    const auto rows = detail::open_image(image(path));
    rows->read(1, 1, part);  // a crop begins below the first row
    EXPECT_NEAR(part[0], 5 * step, 1e-9) << kind;
    rows->read(2, 2, part);
    EXPECT_NEAR(part[1], 11 * step, 1e-9) << kind;
  }
  ASSERT_EQ(make("make_image.py", folder / "w.tif", "white_is_zero"), 0);
  EXPECT_EQ(values_of(image(folder / "w.tif"))[1], 65535 - 5957);
  ImageSection labels = image(folder / "w.tif");
  labels.solid_labels = {0};
  EXPECT_EQ(values_of(labels)[1], 5957);  // as stored
}

TEST(ImageReader, ReadsPagesOfStacks) {
  const test::TemporaryFolder folder;
  for (const auto& [kind, ending, second] :
       {std::tuple{"stack", "tif", 23}, {"nrrd_stack", "nrrd", 23}, {"npy_stack", "npy", 101}}) {
    auto picture = image(folder / (std::string("a.") + ending));
    ASSERT_EQ(make("make_image.py", picture.file, kind), 0);
    EXPECT_EQ(values_of(picture)[1], 1) << kind;
    picture.page = 1;
    EXPECT_EQ(values_of(picture)[1], second) << kind;
    picture.page = 2;
    EXPECT_THAT(refusal(picture, lattice(4, 3)), HasSubstr("has 2 pages")) << kind;
  }
  auto raw = image(folder / "a.raw");
  test::write_text(raw.file, "abcdefghijkl");
  raw.raw_size = {3, 2};
  raw.raw_pages = 2;
  raw.page = 1;
  EXPECT_EQ(values_of(raw)[0], 'g');
}

// 70 x 50 pixels in tiles of 32 x 16, written by libtiff.
TEST(ImageReader, ReadsTiles) {
  const test::TemporaryFolder folder;
  const auto path = folder / "a.tif";
  TIFF* tiff = TIFFOpen(path.c_str(), "w");
  ASSERT_NE(tiff, nullptr);
  for (const auto& [tag, value] : {std::pair{TIFFTAG_IMAGEWIDTH, 70},
                                   {TIFFTAG_IMAGELENGTH, 50},
                                   {TIFFTAG_TILEWIDTH, 32},
                                   {TIFFTAG_TILELENGTH, 16},
                                   {TIFFTAG_BITSPERSAMPLE, 16},
                                   {TIFFTAG_SAMPLESPERPIXEL, 1},
                                   {TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK},
                                   {TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE}})
    TIFFSetField(tiff, tag, value);
  std::vector<std::uint16_t> tile(32 * 16);
  for (std::uint32_t y = 0; y < 50; y += 16)
    for (std::uint32_t x = 0; x < 70; x += 32) {
      for (std::uint32_t i = 0; i < tile.size(); ++i)
        tile[i] = static_cast<std::uint16_t>(100 * (y + i / 32) + x + i % 32);
      TIFFWriteTile(tiff, tile.data(), x, y, 0, 0);
    }
  TIFFClose(tiff);
  const auto rows = detail::open_image(image(path));
  std::vector<double> part(40);
  for (const int y : {3, 17, 49}) {
    rows->read(y, 28, part);
    for (int i = 0; i < 40; ++i) EXPECT_EQ(part[i], 100 * y + 28 + i);
  }
}

/// 3 x 1 pixels of colours, or of grey, with another value each; `kind`: what that is, none where it is negative.
void write_three(const std::string& path, const std::vector<std::uint8_t>& pixels, int kind,
                 int photometric = PHOTOMETRIC_RGB, int format = SAMPLEFORMAT_UINT) {
  TIFF* tiff = TIFFOpen(path.c_str(), "w");
  ASSERT_NE(tiff, nullptr);
  for (const auto& [tag, value] : {std::pair{TIFFTAG_IMAGEWIDTH, 3},
                                   {TIFFTAG_IMAGELENGTH, 1},
                                   {TIFFTAG_BITSPERSAMPLE, 8},
                                   {TIFFTAG_SAMPLEFORMAT, format},
                                   {TIFFTAG_SAMPLESPERPIXEL, static_cast<int>(pixels.size() / 3)},
                                   {TIFFTAG_PHOTOMETRIC, photometric}})
    TIFFSetField(tiff, tag, value);
  const auto extra = static_cast<std::uint16_t>(kind);
  if (kind >= 0) TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, 1, &extra);
  std::vector<std::uint8_t> row = pixels;
  TIFFWriteScanline(tiff, row.data(), 0, 0);
  TIFFClose(tiff);
}

/// Black that is transparent, half of it and opaque, as a PNG of the same pixels is seen.
TEST(ImageReader, ShowsTransparentPixelsOfATiffAsWhite) {
  const test::TemporaryFolder folder;
  const auto picture = image(folder / "a.tif");
  write_three(picture.file, {0, 0, 0, 0, 0, 0, 0, 51, 100, 100, 100, 255}, EXTRASAMPLE_UNASSALPHA);
  const std::vector<double> apart = values_of(picture);
  EXPECT_EQ(apart[0], 255);
  EXPECT_NEAR(apart[1], 0.8 * 255, 1e-9);
  EXPECT_NEAR(apart[2], 100, 1e-9);
  EXPECT_THAT(solid_of(picture, 3, 1), ElementsAre(false, false, true));
  write_three(picture.file, {0, 0, 0, 0, 40, 40, 40, 51, 100, 100, 100, 255}, EXTRASAMPLE_ASSOCALPHA);
  const std::vector<double> multiplied = values_of(picture);
  EXPECT_EQ(multiplied[0], 255);
  EXPECT_NEAR(multiplied[1], 40 + 0.8 * 255, 1e-9);
  EXPECT_NEAR(multiplied[2], 100, 1e-9);
  write_three(picture.file, {0, 0, 0, 51, 100, 255}, EXTRASAMPLE_UNASSALPHA, PHOTOMETRIC_MINISBLACK);
  EXPECT_EQ(values_of(picture), apart);
  write_three(picture.file, {255, 0, 255, 51, 155, 255}, EXTRASAMPLE_UNASSALPHA, PHOTOMETRIC_MINISWHITE);
  EXPECT_EQ(values_of(picture), apart);
}

TEST(ImageReader, RefusesATiffWhoseFourthValueIsUnknown) {
  const test::TemporaryFolder folder;
  const auto picture = image(folder / "a.tif");
  for (const int kind : {-1, static_cast<int>(EXTRASAMPLE_UNSPECIFIED)}) {
    write_three(picture.file, std::vector<std::uint8_t>(12, 0), kind);
    EXPECT_THAT(refusal(picture, lattice(3, 1)), HasSubstr("has 4 values per pixel and does not say that those after"));
  }
  write_three(picture.file, std::vector<std::uint8_t>(12, 0), EXTRASAMPLE_UNASSALPHA, PHOTOMETRIC_RGB,
              SAMPLEFORMAT_INT);
  EXPECT_THAT(refusal(picture, lattice(3, 1)), HasSubstr("whose white is not known; save it without transparency"));
}

}  // namespace
}  // namespace vug
