#include "io/image_reader.hpp"

#include "io/detail/image_rows.hpp"
#include "kernels/base/require.hpp"
#include "temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>
#include <tiffio.h>

namespace vug {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// Pictures from Python's own zlib, Pillow and numpy: encoders that share nothing with the readers.
int make(const std::string& script, const std::string& path, const std::string& kind) {
  const auto command =
      std::string(VUG_PYTHON) + " " + VUG_SOURCE_DIR + "/tests/unit/" + script + " " + path + " " + kind;
  return std::system(command.c_str());
}
int make_png(const std::string& path, const std::string& kind) {
  return make("make_png.py", path, kind);
}

ImageSection image(const std::string& path) {
  ImageSection image;
  image.file = path;
  return image;
}

LatticeSection lattice(int nx, int ny, double spacing = 1e-6) {
  LatticeSection lattice;
  lattice.nx = nx;
  lattice.ny = ny;
  lattice.spacing = spacing;
  return lattice;
}

std::vector<double> values_of(const ImageSection& image) {
  const auto rows = detail::open_image(image);
  std::vector<double> values;
  std::vector<double> row(static_cast<std::size_t>(rows->header.width));
  for (int y = 0; y < rows->header.height; ++y) {
    rows->read(y, 0, row);
    values.insert(values.end(), row.begin(), row.end());
  }
  return values;
}

std::vector<bool> solid_of(const ImageSection& image, int nx, int ny) {
  return read_solid_image(image, lattice(nx, ny)).solid;
}

std::string refusal(const ImageSection& image, const LatticeSection& lattice) {
  try {
    read_solid_image(image, lattice);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

// make_png.py draws 3 x 2 pixels: 0, 0.2, 0.4 above 0.6, 0.8, 1.
TEST(ImageReader, ReadsEveryKindOfPngAsItIsStored) {
  const test::TemporaryFolder folder;
  for (const std::string kind : {"grey8", "grey16", "rgb8", "rgb16", "rgba8", "greyalpha16", "palette8", "grey4"}) {
    const auto path = folder / (kind + ".png");
    ASSERT_EQ(make_png(path, kind), 0);
    const double white = detail::open_image(image(path))->header.white;
    const auto read = values_of(image(path));
    for (int i = 0; i < 6; ++i) EXPECT_NEAR(read[i] / white, 0.2 * i, 1e-6) << kind << ' ' << i;
    EXPECT_THAT(solid_of(image(path), 3, 2), ElementsAre(false, false, false, true, true, true)) << kind;
  }
}

TEST(ImageReader, PutsTheFirstRowAtTheTopOfTheLattice) {
  const test::TemporaryFolder folder;
  ASSERT_EQ(make_png(folder / "a.png", "grey8"), 0);
  auto picture = image(folder / "a.png");
  picture.threshold = 0.1;  // only the first pixel of the top row is darker
  EXPECT_THAT(solid_of(picture, 3, 2), ElementsAre(false, false, false, true, false, false));
  picture.invert = true;
  EXPECT_THAT(solid_of(picture, 3, 2), ElementsAre(true, true, true, false, true, true));
}

TEST(ImageReader, ShowsTransparentPixelsAsWhite) {
  const test::TemporaryFolder folder;
  ASSERT_EQ(make_png(folder / "a.png", "transparent"), 0);
  for (const double grey : values_of(image(folder / "a.png"))) EXPECT_EQ(grey, 1);
}

TEST(ImageReader, ReadsRawBytes) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "a.raw", std::string("\x00\xff\x80\x7f\x01\xfe", 6));
  auto picture = image(folder / "a.raw");
  picture.raw_size = {3, 2};
  EXPECT_THAT(solid_of(picture, 3, 2), ElementsAre(true, true, false, true, false, false));
  test::write_text(folder / "a.raw", "12345");
  EXPECT_THROW(solid_of(picture, 3, 2), InputError);
}

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

TEST(ImageReader, TellsRockByLabels) {
  const test::TemporaryFolder folder;
  auto picture = image(folder / "a.npy");
  ASSERT_EQ(make("make_image.py", picture.file, "'npy_<i8'"), 0);
  picture.solid_labels = {0, 5, 11};
  picture.fluid_labels = {1, 2, 3, 4, 6, 7, 8, 9, 10};
  const SolidImage read = read_solid_image(picture, lattice(4, 3));
  EXPECT_THAT(read.solid, ElementsAre(false, false, false, true, false, true, false, false, true, false, false, false));
  EXPECT_THAT(read.summary.labels, ::testing::Contains(std::pair<std::int64_t, double>(5, 1.0 / 12)));
  picture.fluid_labels.pop_back();
  EXPECT_THAT(refusal(picture, lattice(4, 3)), HasSubstr("column 2, row 2 has the label 10"));
  ASSERT_EQ(make_png(folder / "b.png", "rgb8"), 0);
  picture.file = folder / "b.png";
  EXPECT_THAT(refusal(picture, lattice(3, 2)), HasSubstr("labels are grey values"));
  ASSERT_EQ(make_png(folder / "c.png", "palette8"), 0);
  picture = image(folder / "c.png");  // the index of pixel i is 5 - i
  picture.solid_labels = {5, 3};
  picture.fluid_labels = {4, 2, 1, 0};
  EXPECT_THAT(solid_of(picture, 3, 2), ElementsAre(false, false, false, true, false, true));
}

TEST(ImageReader, TellsMineralsFromLabels) {
  const test::TemporaryFolder folder;
  auto picture = image(folder / "a.npy");  // 0 1 2 3 above 4 5 6 7 above 8 9 10 11
  ASSERT_EQ(make("make_image.py", picture.file, "npy_u1"), 0);
  picture.solid_labels = {0, 1, 4, 5, 6, 7, 9};
  picture.fluid_labels = {2, 3, 8, 10, 11};
  EXPECT_TRUE(read_solid_image(picture, lattice(4, 3)).mineral.empty());
  picture.minerals = {{4, 2}, {5, 1}, {9, 1}, {7, 2}};
  EXPECT_THAT(read_solid_image(picture, lattice(4, 3)).mineral, ElementsAre(0, 1, 0, 0, 2, 1, 0, 2, 0, 0, 0, 0));
  picture.rotate = ImageTurn::half;
  EXPECT_THAT(read_solid_image(picture, lattice(4, 3)).mineral, ElementsAre(0, 0, 0, 0, 2, 0, 1, 2, 0, 0, 1, 0));
  picture.rotate = ImageTurn::none;
  picture.crop_size = {4, 2};
  picture.coarsen = 2;  // 0 1 4 5: two of no mineral, one each of the others; 2 3 6 7: of the two that are rock each
  LatticeSection coarse = lattice(2, 1);
  EXPECT_THAT(read_solid_image(picture, coarse).mineral, ElementsAre(0, 0));
  picture.minerals = {{0, 3}, {4, 2}, {5, 1}, {1, 1}, {6, 2}};  // the earlier of two with as many is 0
  EXPECT_THAT(read_solid_image(picture, coarse).mineral, ElementsAre(1, 0));
}

TEST(ImageReader, CropsTurnsAndMirrors) {
  const test::TemporaryFolder folder;
  auto picture = image(folder / "a.npy");
  ASSERT_EQ(make("make_image.py", picture.file, "npy_u1"), 0);
  picture.solid_labels = {6};  // of 5 6 7 above 9 10 11, the middle of the upper row
  picture.fluid_labels = {5, 7, 9, 10, 11};
  picture.crop_from = {1, 1};
  EXPECT_THAT(solid_of(picture, 3, 2), ElementsAre(false, false, false, false, true, false));
  picture.crop_size = {2, 1};
  picture.coarsen = 1;
  EXPECT_THAT(solid_of(picture, 2, 1), ElementsAre(false, true));
  picture.mirror = ImageMirror::left_right;
  EXPECT_THAT(solid_of(picture, 2, 1), ElementsAre(true, false));
  picture.mirror = ImageMirror::none;
  picture.rotate = ImageTurn::left;  // 6 above 5
  EXPECT_THAT(solid_of(picture, 1, 2), ElementsAre(false, true));
  picture.rotate = ImageTurn::right;
  EXPECT_THAT(solid_of(picture, 1, 2), ElementsAre(true, false));
  picture.mirror = ImageMirror::top_bottom;
  EXPECT_THAT(solid_of(picture, 1, 2), ElementsAre(false, true));
  picture.mirror = ImageMirror::none;
  picture.crop_size = {0, 0};
  picture.rotate = ImageTurn::left;  // 7 11 above 6 10 above 5 9
  EXPECT_THAT(solid_of(picture, 2, 3), ElementsAre(false, false, true, false, false, false));
  picture.rotate = ImageTurn::right;  // 9 5 above 10 6 above 11 7
  EXPECT_THAT(solid_of(picture, 2, 3), ElementsAre(false, false, false, true, false, false));
  picture.rotate = ImageTurn::half;  // 11 10 9 above 7 6 5
  EXPECT_THAT(solid_of(picture, 3, 2), ElementsAre(false, true, false, false, false, false));
  picture.crop_size = {4, 2};
  EXPECT_THAT(refusal(picture, lattice(4, 2)), HasSubstr("leaves the image, which has 4 x 3"));
}

// 0 1 / 4 5 and 2 3 / 6 7: of the first cell one value of four is below 1, their mean is 2.5; of the second 4.5.
TEST(ImageReader, CoarsensByMajorityOrMean) {
  const test::TemporaryFolder folder;
  auto picture = image(folder / "a.npy");
  ASSERT_EQ(make("make_image.py", picture.file, "npy_f4"), 0);
  EXPECT_THAT(refusal(picture, lattice(4, 3)), HasSubstr("geometry.grey_range"));
  picture.grey_range = {0, 10};
  picture.coarsen = 2;
  EXPECT_THAT(refusal(picture, lattice(2, 1)), HasSubstr("crop_size = [4, 2]"));
  picture.crop_size = {4, 2};
  picture.threshold = 0.3;
  EXPECT_THAT(solid_of(picture, 2, 1), ElementsAre(true, false)) << "two of four are rock: a tie is rock";
  picture.threshold = 0.45;
  EXPECT_THAT(solid_of(picture, 2, 1), ElementsAre(true, true));
  picture.coarsen_rule = CoarsenRule::mean;
  EXPECT_THAT(solid_of(picture, 2, 1), ElementsAre(true, false));
  picture.threshold = 0.2;
  EXPECT_THAT(solid_of(picture, 2, 1), ElementsAre(false, false));
}

TEST(ImageReader, HoldsThePixelSizeAgainstTheLattice) {
  const test::TemporaryFolder folder;
  for (const auto& [kind, ending, size] : {std::tuple{"inch", "tif", 1e-6},
                                           {"imagej", "tif", 0.5e-6},
                                           {"nrrd_raw", "nrrd", 5e-6},
                                           {"nrrd_gzip", "nrrd", 5e-6}}) {
    auto picture = image(folder / (std::string("a.") + ending));
    ASSERT_EQ(make("make_image.py", picture.file, kind), 0);
    EXPECT_EQ(refusal(picture, lattice(4, 3, size)), "accepted") << kind;
    EXPECT_THAT(refusal(picture, lattice(4, 3, 1.01 * size)), HasSubstr("the file says pixels of")) << kind;
    picture.pixel_size = 3e-6;
    EXPECT_EQ(refusal(picture, lattice(4, 3, 3e-6)), "accepted") << kind;
    EXPECT_THAT(refusal(picture, lattice(4, 3, size)), HasSubstr("geometry.pixel_size says pixels of 3e-06")) << kind;
  }
  ASSERT_EQ(make("make_image.py", folder / "b.tif", "oblong"), 0);
  EXPECT_THAT(refusal(image(folder / "b.tif"), lattice(4, 3)), HasSubstr("must be square"));
}

TEST(ImageReader, RefusesValuesThatAreNotWhatTheySeem) {
  const test::TemporaryFolder folder;
  auto picture = image(folder / "a.tif");
  ASSERT_EQ(make("make_image.py", picture.file, "dark"), 0);
  EXPECT_THAT(refusal(picture, lattice(4, 3)), HasSubstr("values of 8 bits in a wider type"));
  picture.grey_range = {0, 255};
  EXPECT_EQ(refusal(picture, lattice(4, 3)), "accepted");
  auto raw = image(folder / "a.raw");
  raw.raw_size = {4, 3};
  ASSERT_EQ(make("make_image.py", raw.file, "raw_i2"), 0);
  EXPECT_THAT(refusal(raw, lattice(4, 3)), HasSubstr("has 24 bytes, a raw image of 4 x 3 pixels of uint8 has 12"));
  raw.raw_type = SampleType::int16;
  raw.raw_big_endian = true;
  EXPECT_EQ(values_of(raw)[11], 11);
  ASSERT_EQ(make("make_image.py", raw.file, "raw_nan"), 0);
  raw.raw_type = SampleType::float32;
  raw.raw_big_endian = false;
  raw.grey_range = {0, 11};
  EXPECT_THAT(refusal(raw, lattice(4, 3)), HasSubstr("column 2, row 1 is nan"));
  for (const auto& [kind, ending, why] : {std::tuple{"npy_fortran", "npy", "Fortran order"},
                                          {"npy_c16", "npy", "'<c16'"},
                                          {"nrrd_bzip2", "nrrd", "\"bzip2\""}}) {
    const auto path = folder / (std::string("b.") + ending);
    ASSERT_EQ(make("make_image.py", path, kind), 0);
    EXPECT_THAT(refusal(image(path), lattice(4, 3)), HasSubstr(why)) << kind;
  }
}

TEST(ImageReader, NamesBothSizesWhenTheyDiffer) {
  const test::TemporaryFolder folder;
  ASSERT_EQ(make_png(folder / "a.png", "grey8"), 0);
  EXPECT_THAT(refusal(image(folder / "a.png"), lattice(400, 280)),
              ::testing::AllOf(HasSubstr("3 x 2 pixels"), HasSubstr("400 x 280 nodes")));
}

TEST(ImageReader, RefusesDamageAsInput) {
  const test::TemporaryFolder folder;
  const std::vector<std::array<std::string, 4>> kinds = {{"make_png.py", "rgba8", "a.png", "12"},
                                                         {"make_image.py", "pillow_u2_tiff_lzw", "a.tif", ""},
                                                         {"make_image.py", "little", "b.tif", ""},
                                                         {"make_image.py", "nrrd_gzip", "a.nrrd", "12"},
                                                         {"make_image.py", "npy_u1", "a.npy", "0"}};
  for (const auto& [script, kind, name, tail] : kinds) {
    const auto path = folder / name;
    ASSERT_EQ(make(script, path, kind), 0);
    const auto whole = test::contents(path);
    const auto read = [&] { values_of(image(path)); };
    if (!tail.empty()) {  // what may be cut off: an empty end chunk, a checksum
      for (std::size_t length = 0; length + std::stoul(tail) < whole.size(); ++length) {
        test::write_text(path, whole.substr(0, length));
        EXPECT_THROW(read(), InputError) << name << ' ' << length;
      }
    }
    std::mt19937 random(1);
    for (int i = 0; i < 300; ++i) {
      auto damaged = whole;
      damaged[random() % whole.size()] = static_cast<char>(random() % 256);
      test::write_text(path, damaged);
      try {
        read_solid_image(image(path), lattice(4, 3));
      } catch (const InputError&) {
      }
    }
  }
  EXPECT_THROW(values_of(image(folder / "missing.png")), InputError);
}

}  // namespace
}  // namespace vug
