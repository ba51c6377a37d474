#include "unit/image_setup.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace vug {
namespace {

using test::image;
using test::lattice;
using test::make;
using test::make_png;
using test::refusal;
using test::solid_of;
using test::values_of;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

// make_png.py draws 3 x 2 pixels: 0, 0.2, 0.4 above 0.6, 0.8, 1.
TEST(ImageReader, ReadsEveryKindOfPngAsItIsStored) {
  const test::TemporaryFolder folder;
  for (const std::string kind : {"grey8", "grey16", "rgb8", "rgb16", "rgba8", "greyalpha16", "palette8", "grey4"}) {
    const auto path = folder / (kind + ".png");
    ASSERT_EQ(make_png(path, kind), 0);
    const double white = detail::open_image(image(path))->header.white;
    EXPECT_EQ(white, kind == "grey4" ? 15 : kind.ends_with("16") ? 65535 : 255) << kind << ": colours like grey values";
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
  for (const double grey : values_of(image(folder / "a.png"))) EXPECT_EQ(grey, 255);
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

}  // namespace
}  // namespace vug
