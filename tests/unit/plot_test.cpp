// scripts/plot makes a picture of whatever subset of fields a run has written.
#include "io/history_writer.hpp"
#include "io/rock_generator.hpp"
#include "io/run_record.hpp"
#include "io/snapshot_writer.hpp"
#include "support/made_field.hpp"
#include "support/run_vug.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <sstream>

namespace vug {
namespace {

constexpr int nx = 200, ny = 140;
constexpr double spacing = 5e-4;

Field on_lattice(const std::string& name, const std::string& unit, double (*value)(double, double)) {
  return test::made_field(name, unit, 1, [value](std::size_t i) {
    return value((static_cast<double>(i % nx) + 0.5) * spacing, (static_cast<double>(i / nx) + 0.5) * spacing);
  });
}

double plume(double x, double y) {
  return std::exp(-(x * x + (y - 0.035) * (y - 0.035)) / 4e-4);
}

// A made-up state of the paper's rock, of the size and look of a real one.
FieldList made_up_fields() {
  FieldList list;
  list.lattice.push_back(on_lattice("pressure", "Pa", [](double x, double) { return 2e7 * (1 - x / 0.1); }));
  list.lattice.push_back(test::made_field("velocity", "m/s", 2, [](std::size_t i) { return i % 2 == 0 ? 0.1 : 0.0; }));
  list.lattice.push_back(on_lattice("temperature", "K", [](double x, double y) { return 488 - 200 * plume(x, y); }));
  list.lattice.push_back(on_lattice("concentration_L1", "mol/m3", [](double x, double y) { return plume(x, y); }));
  list.lattice.push_back(
      on_lattice("concentration_L2", "mol/m3", [](double x, double y) { return 0.5 * plume(x, y); }));
  list.lattice.push_back(on_lattice("solid_fraction", "1", [](double x, double y) {
    return std::fmod(x + 0.7 * y, 0.008) < 0.0015 ? 0.0 : 1 - 0.3 * plume(x, y);
  }));
  return list;
}

RockShape generated_rock() {
  RockSection section;
  section.element_size = 0.004;
  section.hole = InjectionHole{{0, 0.0325}, {0.005, 0.0375}};
  RockShape rock{generate_rock(0.1, 0.07, section), {}};
  std::map<std::array<int, 2>, int> first;
  for (int t = 0; t < static_cast<int>(rock.assembly.triangles.size()); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int a = rock.assembly.triangles[t][k], b = rock.assembly.triangles[t][(k + 1) % 3];
      const std::array<int, 2> edge{std::min(a, b), std::max(a, b)};
      if (const auto found = first.find(edge); found != first.end())
        rock.bonds.push_back({{found->second, t}, edge});
      else
        first[edge] = t;
    }
  }
  return rock;
}

int plot(const std::string& folder, const std::string& options = "") {
  const auto command =
      std::string(VUG_PYTHON) + " " + VUG_SOURCE_DIR + "/scripts/plot " + options + " " + folder + " > /dev/null";
  return std::system(command.c_str());
}

/// Share of a picture that is not white, and how many colours cover a thousandth of it each: nothing on axes alone has
/// more than the two of paper and ink.
struct Picture {
  double ink = 0;
  int colours = 0;
};

Picture look_at(const std::string& path) {
  const test::Outcome seen =
      test::run_command(VUG_PYTHON
                        " -c \"import sys, numpy as np, matplotlib.image as m\n"
                        "p = (255 * m.imread(sys.argv[1])[:, :, :3]).astype(int).reshape(-1, 3)\n"
                        "n = np.unique(p // 16, axis=0, return_counts=True)[1]\n"
                        "print((p.sum(1) < 750).mean(), (n > len(p) / 1000).sum())\" " +
                        path);
  Picture picture;
  std::istringstream(seen.output) >> picture.ink >> picture.colours;
  return picture;
}

/// A field is drawn in colours over most of the paper.
bool shows_a_field(const std::string& path) {
  const Picture picture = look_at(path);
  return picture.ink > 0.2 && picture.colours > 5;
}

/// Lines in several colours.
bool shows_lines(const std::string& path) {
  const Picture picture = look_at(path);
  return picture.ink > 0.005 && picture.colours > 2;
}

TEST(Plot, DrawsEveryFieldTheOverviewAndTheHistories) {
  const test::TemporaryFolder temporary;
  // VUG_KEEP_PLOTS=FOLDER keeps the pictures there, to be looked at
  const char* keep = std::getenv("VUG_KEEP_PLOTS");
  const std::string folder = keep ? keep : temporary.path();
  auto rock = generated_rock();
  auto fields = made_up_fields();
  const auto bonds = rock.bonds;
  const auto assembly = rock.assembly;
  fields.bonds.push_back(test::made_field("state", "1", 1, [bonds, assembly](std::size_t i) {
    const auto& p = assembly.vertices[bonds[i].vertices[0]];
    const double distance = std::hypot(p[0] - 0.005, 3 * (p[1] - 0.035));
    return distance < 0.03 ? 3 : distance < 0.045 ? 1 : 0;
  }));
  SnapshotWriter writer(folder, Lattice(nx, ny), spacing, fields, {}, rock);
  writer.write(0, 0);
  writer.write(0.08, 800);
  HistoryWriter history(folder + "/history.csv", {"time_s", "reactive_area_m2", "bonds_damaged_1", "bonds_failed_1",
                                                  "kinetic_energy_J_per_m", "heat_balance_error_1"});
  for (int i = 0; i < 50; ++i)
    history.write(std::vector<double>{i * 0.002, 1e-3 * i * i, 3.0 * i, 1.0 * i, 1e-7 * std::sin(0.3 * i), 1e-16 * i});
  RunRecord record;
  record.case_path = "cases/made-up.toml";
  write_run_record(folder, record);

  ASSERT_EQ(plot(folder, "--movie"), 0);
  for (const char* name :
       {"pressure", "speed", "temperature", "concentration_L1", "concentration_L2", "solid_fraction", "overview"})
    EXPECT_TRUE(shows_a_field(folder + "/figures/" + name + ".png")) << name;
  for (const char* name : {"rock", "cracks", "balances"})
    EXPECT_TRUE(shows_lines(folder + "/figures/history_" + name + ".png")) << name;
  EXPECT_FALSE(std::filesystem::exists(folder + "/figures/history_acid.png")) << "no acid in it";
  EXPECT_TRUE(test::contents(folder + "/figures/movie.gif").starts_with("GIF89a"));
}

// Black all over tells nobody anything.
TEST(Plot, DrawsNoRockWhereThereIsNone) {
  const test::TemporaryFolder folder;
  FieldList fields;
  fields.lattice.push_back(made_up_fields().lattice[0]);
  fields.lattice.push_back(on_lattice("node_type", "1", [](double, double) { return 0.0; }));
  fields.lattice.push_back(on_lattice("solid_fraction", "1", [](double, double) { return 0.0; }));
  SnapshotWriter(folder.path(), Lattice(nx, ny), spacing, fields, {}).write(0, 0);
  ASSERT_EQ(plot(folder.path()), 0);
  EXPECT_TRUE(shows_a_field(folder / "figures/pressure.png"));
  EXPECT_FALSE(std::filesystem::exists(folder / "figures/solid_fraction.png"));
}

TEST(Plot, DrawsEverySnapshotOfASceneWithPressureOnly) {
  const test::TemporaryFolder folder;
  FieldList fields;
  fields.lattice.push_back(made_up_fields().lattice[0]);
  SnapshotWriter writer(folder.path(), Lattice(nx, ny), spacing, fields, {});
  writer.write(0, 0);
  writer.write(0.08, 800);
  ASSERT_EQ(plot(folder.path(), "--all"), 0);
  for (const char* name : {"pressure", "pressure_000000000000", "pressure_000000000800", "overview"})
    EXPECT_TRUE(shows_a_field(folder / ("figures/" + std::string(name) + ".png"))) << name;
}

TEST(Plot, DrawsTheCurvesAndTheCracksOfALaboratoryTest) {
  const test::TemporaryFolder temporary;
  const char* keep = std::getenv("VUG_KEEP_PLOTS");
  const std::string folder = keep ? std::string(keep) + "/lab" : temporary / "lab";
  std::filesystem::create_directories(folder);
  HistoryWriter curve(folder + "/stress_strain.csv", {"strain_1", "stress_Pa", "seed_1"});
  for (const int seed : {1, 2, 3}) {
    for (int i = 0; i <= 60; ++i) {
      const double strain = 7e-5 * i, elastic = 28e9 * strain;
      curve.write(std::vector<double>{strain, i < 45 + 3 * seed ? elastic : 0.5 * elastic, 1.0 * seed});
    }
  }
  auto rock = generated_rock();
  FieldList fields;
  const auto bonds = rock.bonds;
  const auto assembly = rock.assembly;
  fields.bonds.push_back(test::made_field("state", "1", 1, [bonds, assembly](std::size_t i) {
    const auto& p = assembly.vertices[bonds[i].vertices[0]];
    const double off = std::abs(p[0] - 0.02 - 0.8 * p[1]);
    return off < 0.002 ? 4 : off < 0.004 ? 3 : off < 0.008 ? 1 : 0;
  }));
  SnapshotWriter writer(folder, fields, {}, rock);
  writer.write(0, 0);
  writer.write(1e-3, 20000);
  ASSERT_EQ(plot(folder), 0);
  for (const char* name : {"stress_strain", "crack_pattern"})
    EXPECT_TRUE(shows_lines(folder + "/figures/" + name + ".png")) << name;
  EXPECT_FALSE(std::filesystem::exists(folder + "/figures/crack_pattern_000000000000.png"));
  ASSERT_EQ(plot(folder, "--all"), 0);
  EXPECT_TRUE(shows_lines(folder + "/figures/crack_pattern_000000000000.png"));
}

TEST(Plot, CallsOnlyAPeakThatWasPassedAStrength) {
  const test::Outcome outcome = test::run_command(
      VUG_PYTHON " -c \"import sys; sys.path.insert(0, '" VUG_SOURCE_DIR
                 "/python');"
                 " from vug.plot.laboratory import passed_a_peak as passed;"
                 " print(passed([1, 4, 2], 5), passed([1, 4, 2], None), passed([1, 3, 4], 5), passed([1, 4, 3.9], 5),"
                 " passed([1, 4, 2], 0))\"");
  EXPECT_EQ(outcome.output, "True True False False False\n");
}

TEST(Plot, SaysWhatIsMissing) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(plot(folder.path(), "2> " + (folder / "error")), 4 * 256);
  EXPECT_NE(test::contents(folder / "error").find("run directory"), std::string::npos);
}

}  // namespace
}  // namespace vug
