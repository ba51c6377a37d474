// Mistakes about a picture, as a user makes them: one line, the right exit code, nothing written.
#include "support/run_vug.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace vug {
namespace {

using ::testing::HasSubstr;

const std::string slice = " " VUG_SOURCE_DIR "/cases/ct_slice/ct_slice.toml ";

TEST(Pictures, ThatContradictTheCaseAreRefusedInOneLine) {
  const test::TemporaryFolder folder;
  const struct {
    const char *change, *why;
  } mistakes[] = {
      {"--set geometry.coarsen=1",
       "the image has 400 x 280 pixels of 5e-06 m, the lattice 200 x 140 nodes; give lattice.spacing = 5e-06 and "
       "lattice.size = [0.002, 0.0014] (m), or use a part"},
      {"--set geometry.rotate=left",
       "coarsened and turned 140 x 200 cells, the lattice 200 x 140 nodes; give lattice.spacing = 1e-05 and "
       "lattice.size = [0.0014, 0.002] (m)"},
      {"--set geometry.coarsen=4 --set geometry.pixel_size=1e-5",
       "give lattice.spacing = 4e-05 and lattice.size = [0.004, 0.0028] (m)"},
      {"--set geometry.pixel_size=6e-6", "geometry.pixel_size says pixels of 6e-06 m, 2 of them 1.2e-05 m"},
      {"--set lattice.spacing=2e-5 --set geometry.coarsen=4 --set geometry.pixel_size=1e-5", "must agree"},
      {"--set geometry.page=1", "has 1 page, counted from 0"},
      {"--set 'geometry.crop_size=[399, 280]'", "geometry.crop_size = [398, 280]"},
      {"--set 'geometry.grey_range=[0, 255]'", "has values 0 ... 50688, and geometry.grey_range, threshold and invert"},
      {"--set 'geometry.crop_from=[10, 0]' --set 'geometry.crop_size=[400, 280]'",
       "the crop of 400 x 280 pixels from column 10, row 0 leaves the image, which has 400 x 280 pixels"},
      {"--set 'geometry.crop_from=[500, 0]'", "the crop from column 500, row 0 leaves the image"},
  };
  for (const auto& [change, why] : mistakes) {
    const test::Outcome outcome = test::run_vug("run" + slice + change + " -o " + (folder / "out"));
    EXPECT_EQ(outcome.exit_code, 2) << change;
    EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 1) << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr(why));
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

// Of 10 x 10 cells two rows are open from left to right, and a pocket of 3 x 2 is closed.
TEST(Pictures, OfJoinedPoresCountWhatReachesFromSideToSide) {
  const test::TemporaryFolder folder;
  const std::string shape = "[[geometry.shapes]]\ntype = \"rectangle\"\nmaterial = \"fluid\"\n";
  test::write_text(
      folder / "case.toml",
      "[lattice]\nsize = [10, 10]\nspacing = 1\ntime_step = 1\n[time]\nsteps = 1\n[flow]\nviscosity = 0.1\n"
      "[geometry]\ntype = \"shapes\"\nbackground = \"solid\"\n" +
          shape + "from = [0, 2]\nto = [10, 4]\n" + shape + "from = [5, 6]\nto = [8, 8]\n");
  const test::Outcome across = test::run_vug("check --json " + (folder / "case.toml"));
  EXPECT_THAT(across.output,
              HasSubstr("\"porosity\": 0.26000000000000001, \"joined_porosity\": [0.20000000000000001, 0],"));
}

TEST(Pictures, ArePreviewedOrSayWhyNot) {
  const test::TemporaryFolder folder;
  const test::Outcome drawn = test::run_vug("check" + slice + "--preview " + (folder / "preview.png"));
  EXPECT_EQ(drawn.exit_code, 0) << drawn.output;
  EXPECT_THAT(drawn.output, HasSubstr("picture of 400 x 280 pixels, uint16"));
  EXPECT_THAT(drawn.output, HasSubstr("pores joined from left to right 29."));
  EXPECT_TRUE(test::contents(folder / "preview.png").starts_with("\x89PNG"));
  const test::Outcome nowhere = test::run_vug("check" + slice + "--preview " + (folder / "no/preview.png"));
  EXPECT_EQ(nowhere.exit_code, 4) << nowhere.output;
  const test::Outcome full =
      test::run_command("ulimit -f 0; " VUG_EXECUTABLE " check" + slice + "--preview " + (folder / "full.png"));
  EXPECT_EQ(full.exit_code, 4) << full.output;
  EXPECT_THAT(full.output, HasSubstr("full.png"));
  EXPECT_FALSE(std::filesystem::exists(folder / "full.png"));
  EXPECT_EQ(test::run_vug("check" + slice + "--preview /dev/null").exit_code, 2);
  EXPECT_FALSE(std::filesystem::is_regular_file("/dev/null")) << "a device is left alone";
}

TEST(Pictures, ReplacePicturesOnlyAndNoneOfTheCase) {
  const test::TemporaryFolder folder;
  namespace fs = std::filesystem;
  fs::copy(VUG_SOURCE_DIR "/cases/ct_slice", folder / "slice", fs::copy_options::recursive);
  const std::string text = folder / "slice/ct_slice.toml", case_of = "check " + text;
  test::write_text(folder / "mine.png", "mine");
  fs::create_symlink(text, folder / "case.png");
  fs::create_symlink(folder / "slice/slice.tif", folder / "image.png");
  const struct {
    std::string file, why;
  } refused[] = {{text, "the picture is a PNG file; give a name that ends in .png"},
                 {folder / "notes", "ends in .png"},
                 {folder / "case.png", "is a file of the case"},
                 {folder / "image.png", "is a file of the case"},
                 {folder / "mine.png", "is there already and is no PNG"}};
  for (const auto& [file, why] : refused) {
    const std::string before = test::contents(file);
    const test::Outcome outcome = test::run_vug(case_of + " --preview " + file);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.output;
    EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 1) << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr(why));
    EXPECT_EQ(test::contents(file), before);
  }
  for (int twice = 0; twice < 2; ++twice)
    EXPECT_EQ(test::run_vug(case_of + " --preview " + (folder / "new.png")).exit_code, 0) << "one preview over another";
}

}  // namespace
}  // namespace vug
