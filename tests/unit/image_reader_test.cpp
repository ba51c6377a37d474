#include "io/image_reader.hpp"

#include "kernels/require.hpp"
#include "temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

namespace vug {
namespace {

using ::testing::HasSubstr;

// Writes PNG files of every kind with Python's own zlib: an encoder that shares nothing with the reader.
int make_png(const std::string& path, const std::string& kind) {
  const auto script = std::string(VUG_PYTHON) + " " + VUG_SOURCE_DIR + "/tests/unit/make_png.py " + path + " " + kind;
  return std::system(script.c_str());
}

GeometrySection image(const std::string& path) {
  GeometrySection geometry;
  geometry.kind = GeometryKind::image;
  geometry.image_file = path;
  return geometry;
}

// make_png.py draws 3 x 2 pixels: 0, 0.2, 0.4 above 0.6, 0.8, 1.
TEST(ImageReader, ReadsEveryKindOfPngAsItIsStored) {
  const test::TemporaryFolder folder;
  for (const std::string kind : {"grey8", "grey16", "rgb8", "rgb16", "rgba8", "greyalpha16", "palette8", "grey4"}) {
    const auto path = folder / (kind + ".png");
    ASSERT_EQ(make_png(path, kind), 0);
    const auto read = read_image(image(path), 3, 2);
    for (int i = 0; i < 6; ++i) EXPECT_NEAR(read.grey[i], 0.2 * i, 1e-6) << kind << ' ' << i;
    EXPECT_THAT(solid_nodes(read, image(path)), ::testing::ElementsAre(false, false, false, true, true, true)) << kind;
  }
}

TEST(ImageReader, PutsTheFirstRowAtTheTopOfTheLattice) {
  const test::TemporaryFolder folder;
  ASSERT_EQ(make_png(folder / "a.png", "grey8"), 0);
  auto geometry = image(folder / "a.png");
  geometry.image_threshold = 0.1;  // only the first pixel of the top row is darker
  EXPECT_THAT(read_solid_image(geometry, 3, 2), ::testing::ElementsAre(false, false, false, true, false, false));
  geometry.image_invert = true;
  EXPECT_THAT(read_solid_image(geometry, 3, 2), ::testing::ElementsAre(true, true, true, false, true, true));
}

TEST(ImageReader, ShowsTransparentPixelsAsWhite) {
  const test::TemporaryFolder folder;
  ASSERT_EQ(make_png(folder / "a.png", "transparent"), 0);
  for (const float grey : read_image(image(folder / "a.png"), 3, 2).grey) EXPECT_EQ(grey, 1);
}

TEST(ImageReader, ReadsRawBytes) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "a.raw", std::string("\x00\xff\x80\x7f\x01\xfe", 6));
  auto geometry = image(folder / "a.raw");
  geometry.raw_size = {3, 2};
  EXPECT_THAT(read_solid_image(geometry, 3, 2), ::testing::ElementsAre(true, true, false, true, false, false));
  test::write_text(folder / "a.raw", "12345");
  EXPECT_THROW(read_solid_image(geometry, 3, 2), InputError);
}

TEST(ImageReader, NamesBothSizesWhenTheyDiffer) {
  const test::TemporaryFolder folder;
  ASSERT_EQ(make_png(folder / "a.png", "grey8"), 0);
  try {
    read_solid_image(image(folder / "a.png"), 400, 280);
    FAIL() << "accepted";
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), HasSubstr("3 x 2 pixels"));
    EXPECT_THAT(e.what(), HasSubstr("400 x 280 nodes"));
  }
}

TEST(ImageReader, RefusesDamageAsInput) {
  const test::TemporaryFolder folder;
  const auto path = folder / "a.png";
  ASSERT_EQ(make_png(path, "rgba8"), 0);
  const auto whole = test::contents(path);
  for (std::size_t length = 0; length + 12 < whole.size(); ++length) {  // the last 12 bytes are the empty end chunk
    test::write_text(path, whole.substr(0, length));
    EXPECT_THROW(read_image(image(path), 3, 2), InputError) << length;
  }
  std::mt19937 random(1);
  for (int i = 0; i < 300; ++i) {
    auto damaged = whole;
    damaged[random() % whole.size()] = static_cast<char>(random() % 256);
    test::write_text(path, damaged);
    try {
      read_image(image(path), 3, 2);
    } catch (const InputError&) {
    }
  }
  EXPECT_THROW(read_image(image(folder / "missing.png"), 3, 2), InputError);
}

}  // namespace
}  // namespace vug
