// Pictures that are damaged, or are not what the case takes them for.
#include "unit/image_setup.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <random>

namespace vug {
namespace {

using test::image;
using test::lattice;
using test::make;
using test::make_png;
using test::refusal;
using test::values_of;
using ::testing::HasSubstr;

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
  auto oblong = image(folder / "b.tif");
  EXPECT_THAT(refusal(oblong, lattice(4, 3)), HasSubstr("must be square"));
  oblong.pixel_size = 1e-6;
  EXPECT_EQ(refusal(oblong, lattice(4, 3)), "accepted");
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
                                          {"npy_rgb", "npy", "a colour picture (rows, columns, 3)"},
                                          {"nrrd_bzip2", "nrrd", "\"bzip2\""}}) {
    const auto path = folder / (std::string("b.") + ending);
    ASSERT_EQ(make("make_image.py", path, kind), 0);
    EXPECT_THAT(refusal(image(path), lattice(4, 3)), HasSubstr(why)) << kind;
  }
}

/// A header of NumPy's may have 65,535 bytes, all of them blanks but for a few.
TEST(ImageReader, ReadsHeadersFullOfBlanks) {
  const test::TemporaryFolder folder;
  const std::string blanks(65000, ' '), path = folder / "a.npy";
  const auto write = [&](const std::string& header) {
    const std::size_t size = header.size();
    test::write_text(path, std::string("\x93NUMPY\x01\0", 8) + static_cast<char>(size % 256) +
                               static_cast<char>(size / 256) + header + "abcdef");
  };
  const std::string order = "'fortran_order': False, ", shape = "'shape': (2, 3)";
  write("{'descr':" + blanks + "'|u1', " + order + shape + "}\n");
  EXPECT_EQ(values_of(image(path)), (std::vector<double>{'a', 'b', 'c', 'd', 'e', 'f'}));
  write("{'descr': '|u1', " + order + "'shape':" + blanks + "(2, 3)}\n");
  EXPECT_EQ(values_of(image(path))[5], 'f');
  for (const std::string& damaged :
       {"{'descr':" + blanks, "{'descr': '" + blanks + "', " + order + shape, "{'descr': '|u1', " + shape,
        "{'descr': '|u1', " + order + "'shape': (2, " + blanks + "3)", "{'descr': '|u1', " + order + "'shape': (2, x)",
        "{'descr': '|u1', " + order + "'shape': (2, 1234567890123)",
        "{'descr': '|u1', " + order + "'shape': (2, -3)"}) {
    write(damaged);
    EXPECT_THAT(refusal(image(path), lattice(3, 2)), HasSubstr("its header is damaged")) << damaged.substr(0, 60);
  }
}

TEST(ImageReader, NamesBothSizesWhenTheyDiffer) {
  const test::TemporaryFolder folder;
  ASSERT_EQ(make_png(folder / "a.png", "grey8"), 0);
  EXPECT_THAT(refusal(image(folder / "a.png"), lattice(400, 280)),
              ::testing::AllOf(HasSubstr("3 x 2 pixels"), HasSubstr("400 x 280 nodes")));
}

/// What is proposed is what is wanted, whatever the pixel size is.
TEST(ImageReader, ProposesASizeThatFits) {
  const test::TemporaryFolder folder;
  auto picture = image(folder / "a.raw");
  test::write_text(picture.file, std::string(237 * 143, '\0'));
  picture.raw_size = {237, 143};
  for (const double size : {25e-6 / 12, 1e-6, 1.0 / 3, 7e-9 / 3}) {
    picture.pixel_size = size;
    const std::string told = refusal(picture, lattice(10, 10));
    double spacing, x, y;
    ASSERT_EQ(std::sscanf(told.substr(told.find("lattice.spacing")).c_str(),
                          "lattice.spacing = %lf and lattice.size = [%lf, %lf]", &spacing, &x, &y),
              3)
        << told;
    for (const auto& [length, cells] : {std::pair{x, 237.0}, {y, 143.0}})
      EXPECT_NEAR(length / spacing, cells, 1e-9 * cells) << told;
    EXPECT_NEAR(spacing, size, 1e-8 * size);
  }
}

struct DamagedKind {
  std::string script, kind, name;
  LatticeSection lattice;  ///< that the whole file fits
  int tail;                ///< bytes that may be cut off (an empty end chunk, a checksum); -1: not cut
  int accepted;            ///< least number of damaged files of 300 that are read; none where all bytes have checksums
};

/// Some damage is in bytes that nobody reads or changes only a value: the rest is refused, and nothing else happens.
TEST(ImageReader, RefusesDamageAsInput) {
  const test::TemporaryFolder folder;
  const std::vector<DamagedKind> kinds = {{"make_png.py", "rgba8", "a.png", lattice(3, 2), 12, 0},
                                          {"make_image.py", "pillow_u2_tiff_lzw", "a.tif", lattice(4, 3), -1, 20},
                                          {"make_image.py", "little", "b.tif", lattice(4, 3), -1, 20},
                                          {"make_image.py", "nrrd_gzip", "a.nrrd", lattice(4, 3, 5e-6), 12, 20},
                                          {"make_image.py", "npy_u1", "a.npy", lattice(4, 3), 0, 20}};
  for (const auto& [script, kind, name, fitting, tail, least] : kinds) {
    auto picture = image(folder / name);
    ASSERT_EQ(make(script, picture.file, kind), 0);
    const auto whole = test::contents(picture.file);
    ASSERT_EQ(refusal(picture, fitting), "accepted") << name;
    if (tail >= 0) {
      for (std::size_t length = 0; length + static_cast<std::size_t>(tail) < whole.size(); ++length) {
        test::write_text(picture.file, whole.substr(0, length));
        EXPECT_THROW(values_of(picture), InputError) << name << ' ' << length;
      }
    }
    std::mt19937 random(1);
    int refused = 0, accepted = 0;
    for (int i = 0; i < 300; ++i) {
      auto damaged = whole;
      damaged[random() % whole.size()] = static_cast<char>(random() % 256);
      test::write_text(picture.file, damaged);
      (refusal(picture, fitting) == "accepted" ? accepted : refused)++;
    }
    std::printf("    %s: %d refused, %d accepted\n", name.c_str(), refused, accepted);
    EXPECT_GT(refused, 50) << name;
    EXPECT_GE(accepted, least) << name;
  }
  EXPECT_THROW(values_of(image(folder / "missing.png")), InputError);
}

}  // namespace
}  // namespace vug
