// Snapshots: what is written is what h5py reads, the XDMF names only what exists, and a resumed run continues the
// files.
#include "io/snapshot_writer.hpp"

#include "base/require.hpp"
#include "support/made_field.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace vug {
namespace {

using test::made_field;
using ::testing::HasSubstr;

constexpr int nx = 7, ny = 5;
constexpr double spacing = 1e-3;

// A field whose value says where it is: read_snapshots.py expects the same numbers.
FieldList numbered_fields() {
  FieldList list;
  list.lattice.push_back(made_field("pressure", "Pa", 1, [](std::size_t i) { return 1e5 + static_cast<double>(i); }));
  list.lattice.push_back(made_field("velocity", "m/s", 2, [](std::size_t i) { return 0.5 * static_cast<double>(i); }));
  list.particles.push_back(
      made_field("temperature", "K", 1, [](std::size_t i) { return 300 + static_cast<double>(i); }));
  list.particles.push_back(made_field("displacement", "m", 2, [](std::size_t i) { return i % 2 == 0 ? 0.25 : 0.0; }));
  list.particles.push_back(made_field("rotation", "1", 1, [](std::size_t) { return std::acos(0.0); }));
  list.bonds.push_back(made_field("d_m", "1", 1, [](std::size_t i) { return static_cast<double>(i); }));
  list.bonds.push_back(made_field("stress", "Pa", 2, [](std::size_t i) { return static_cast<double>(i); }));
  return list;
}

RockShape two_triangles() {
  return {{{{0, 0}, {3, 0}, {3, 3}, {0, 3}}, {{0, 1, 2}, {0, 2, 3}}, {}}, {{{0, 1}, {0, 2}}}};
}

int python(const std::string& arguments) {
  return std::system((std::string(VUG_PYTHON) + " " + VUG_SOURCE_DIR + "/tests/unit/" + arguments).c_str());
}

TEST(SnapshotWriter, WritesWhatH5pyReadsAndXdmfNames) {
  const test::TemporaryFolder folder;
  SnapshotWriter writer(folder.path(), Lattice(nx, ny), spacing, numbered_fields(), {}, two_triangles());
  for (const int step : {0, 10, 20}) writer.write(1e-7 * step, step);
  EXPECT_EQ(python("read_snapshots.py " + folder.path() + " 0 10 20"), 0);
}

TEST(SnapshotWriter, StoresUncompressedWhenAsked) {
  const test::TemporaryFolder folder;
  SnapshotOptions options;
  options.compress = false;
  SnapshotWriter(folder.path(), Lattice(nx, ny), spacing, numbered_fields(), options, two_triangles()).write(0, 0);
  EXPECT_EQ(python("read_snapshots.py --uncompressed " + folder.path() + " 0"), 0);
}

TEST(SnapshotWriter, ContinuesAfterTheCheckpointWithoutLaterSnapshots) {
  const test::TemporaryFolder folder;
  {
    SnapshotWriter writer(folder.path(), Lattice(nx, ny), spacing, numbered_fields(), {}, two_triangles());
    for (const int step : {0, 10, 20, 30}) writer.write(1e-7 * step, step);
  }
  SnapshotOptions options;
  options.resume_step = 15;
  SnapshotWriter writer(folder.path(), Lattice(nx, ny), spacing, numbered_fields(), options, two_triangles());
  writer.write(1e-7 * 25, 25);
  EXPECT_EQ(python("read_snapshots.py " + folder.path() + " 0 10 25"), 0);
}

TEST(SnapshotWriter, WritesOnlyTheFieldsAskedFor) {
  const test::TemporaryFolder folder;
  SnapshotOptions options;
  options.fields = {"velocity", "d_m"};
  SnapshotWriter(folder.path(), Lattice(nx, ny), spacing, numbered_fields(), options, two_triangles()).write(0, 0);
  const auto fields = test::contents(folder / "fields.xdmf");
  EXPECT_THAT(fields, HasSubstr("velocity"));
  EXPECT_THAT(fields, ::testing::Not(HasSubstr("pressure")));
  EXPECT_THAT(test::contents(folder / "particles.xdmf"), HasSubstr("bonds/d_m"));
}

TEST(SnapshotWriter, NamesWhatThereIsWhenAFieldIsUnknown) {
  const test::TemporaryFolder folder;
  SnapshotOptions options;
  options.fields = {"presure"};
  try {
    SnapshotWriter(folder.path(), Lattice(nx, ny), spacing, numbered_fields(), options);
    FAIL() << "accepted";
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), HasSubstr("'presure'"));
    EXPECT_THAT(e.what(), HasSubstr("pressure"));
  }
}

TEST(SnapshotWriter, WritesNoParticlesWithoutRock) {
  const test::TemporaryFolder folder;
  SnapshotWriter(folder.path(), Lattice(nx, ny), spacing, numbered_fields(), {}).write(0, 0);
  EXPECT_TRUE(std::filesystem::exists(folder / "fields.h5"));
  EXPECT_FALSE(std::filesystem::exists(folder / "particles.h5"));
}

TEST(SnapshotWriter, NamesPathAndReasonWhenItCannotWrite) {
  try {
    SnapshotWriter("/proc/no/such/folder", Lattice(nx, ny), spacing, numbered_fields(), {});
    FAIL() << "accepted";
  } catch (const FileError& e) {
    EXPECT_THAT(e.what(), HasSubstr("/proc/no/such/folder/fields: cannot create"));
    EXPECT_THAT(e.what(), HasSubstr("No such file or directory"));
  }
}

}  // namespace
}  // namespace vug
