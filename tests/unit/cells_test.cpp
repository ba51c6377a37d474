// n cells are n cells wherever they lie: shapes, openings, injections, holes and notches whose bounds pass through
// centres or boundaries of cells, at coordinates that are not exact in floating point.
#include "coupling/cells.hpp"

#include "base/require.hpp"
#include "coupling/geometry.hpp"
#include "coupling/rock.hpp"
#include "support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace vug {
namespace {

const std::vector<double> offsets{0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9};

TEST(FirstCell, BelongsToWhatHoldsItsCentre) {
  EXPECT_EQ(first_cell(3), 3);
  EXPECT_EQ(first_cell(3.4), 3);
  EXPECT_EQ(first_cell(3.5), 3);
  EXPECT_EQ(first_cell(3.5 + 1e-12), 3);
  EXPECT_EQ(first_cell(3.5 - 1e-12), 3);
  EXPECT_EQ(first_cell(3.5 + 1e-6), 4);
}

TEST(CellOf, IsTheHigherOneOnABoundaryWhateverItsLastDigit) {
  EXPECT_EQ(cell_of(2.5), 2);
  EXPECT_EQ(cell_of(3), 3);
  EXPECT_EQ(cell_of(3 - 1e-6), 2);
  for (const double spacing : {1e-4, 5e-5, 1e-3 / 3})
    for (int cell = 0; cell < 100; ++cell) EXPECT_EQ(cell_of(cell * spacing / spacing), cell) << spacing;
  EXPECT_LT(3e-4 / 1e-4, 3);
  EXPECT_EQ(cell_of(3e-4 / 1e-4), 3);
}

/// A case of 40 x 30 cells.
std::string case_of(double spacing, const std::string& rest) {
  return fmt::format(
             "[lattice]\nsize = [{:.17g}, {:.17g}]\nspacing = {:.17g}\ntime_step = {:.17g}\n[time]\nsteps = 1\n"
             "[flow]\nviscosity = {:.17g}\n",
             40 * spacing, 30 * spacing, spacing, spacing, 0.1 * spacing) +
         rest;
}

std::vector<bool> box_mask(int x0, int y0, int width, int height) {
  std::vector<bool> mask(40 * 30, false);
  for (int y = y0; y < y0 + height; ++y)
    for (int x = x0; x < x0 + width; ++x) mask[y * 40 + x] = true;
  return mask;
}

TEST(Shapes, OfWholeCellsHaveThemWhereverTheyLie) {
  for (const double spacing : {1.0, 5e-5, 1e-3 / 3})
    for (const double at : offsets) {
      const auto metres = [&](double cells) { return fmt::format("{:.12g}", cells * spacing); };
      const std::string x0 = metres(7 + at), x1 = metres(16 + at), y0 = metres(11 + at), y1 = metres(15 + at);
      const auto expected = box_mask(at > 0.5 ? 8 : 7, at > 0.5 ? 12 : 11, 9, 4);
      const std::string rectangle =
          fmt::format("type = \"rectangle\"\nfrom = [{}, {}]\nto = [{}, {}]\n", x1, y0, x0, y1);
      const std::string polygon = fmt::format(
          "type = \"polygon\"\npoints = [[{0}, {1}], [{2}, {1}], [{2}, {3}], [{0}, {3}]]\n", x0, y0, x1, y1);
      for (const std::string& shape : {rectangle, polygon}) {
        const std::string drawn = "[geometry]\ntype = \"shapes\"\n[[geometry.shapes]]\n" + shape;
        EXPECT_EQ(drawn_rock(parse_scene(case_of(spacing, drawn), "case.toml")).solid, expected) << at << "\n" << shape;
        const auto opening = opening_of_nodes(
            parse_scene(case_of(spacing, "[[geometry.shapes]]\nname = \"well\"\n" + shape + "[boundary.shape.well]\n"),
                        "case.toml"));
        std::vector<bool> open;
        for (const int o : opening) open.push_back(o >= 0);
        EXPECT_EQ(open, expected) << at << "\n" << shape;
      }
    }
}

TEST(Shapes, AreMirroredWhenADiscIs) {
  const Scene disc =
      parse_scene(case_of(1e-3 / 3, fmt::format("[geometry]\ntype = \"shapes\"\n[[geometry.shapes]]\n"
                                                "type = \"disc\"\ncentre = [{:.12g}, {:.12g}]\nradius = {:.12g}\n",
                                                20.5e-3 / 3, 14.5e-3 / 3, 5e-3 / 3)),
                  "case.toml");
  const auto mask = drawn_rock(disc).solid;
  for (int y = 0; y < 29; ++y)
    for (int x = 1; x < 40; ++x) {
      EXPECT_EQ(mask[y * 40 + x], mask[y * 40 + 40 - x]);
      EXPECT_EQ(mask[y * 40 + x], mask[(28 - y) * 40 + x]);
    }
  EXPECT_EQ(std::count(mask.begin(), mask.end(), true), 81);  // Gauss's circle problem: x^2 + y^2 <= 25
}

TEST(Injection, OfWholeCellsHasThemWhereverItLies) {
  for (const double spacing : {1.0, 5e-5, 1e-3 / 3})
    for (const double at : offsets)
      for (int n = 1; n <= 5; ++n) {
        const Scene scene = parse_scene(
            case_of(spacing, fmt::format("[boundary.injection]\nside = \"left\"\ncentre = {:.12g}\nwidth = {:.12g}\n"
                                         "flow = {{ type = \"pressure\", pressure = 2e5 }}\n",
                                         (10 + at) * spacing, n * spacing)),
            "case.toml");
        for (const Stretch& stretch : boundary_stretches(scene)) {
          if (stretch.name != "injection") continue;
          EXPECT_EQ(stretch.first, first_cell(10 + at - 0.5 * n)) << n << " at " << at;
          EXPECT_EQ(stretch.last - stretch.first + 1, n) << n << " at " << at;
        }
      }
}

std::string rock_case(double spacing, const std::string& rock) {
  return case_of(spacing,
                 fmt::format("[geometry]\ntype = \"rock\"\n[rock]\nelement_size = {:.17g}\n", 8 * spacing) + rock);
}

std::vector<bool> open_nodes(const std::string& text) {
  const Scene scene = parse_scene(text, "case.toml");
  std::vector<bool> open = build_rock(scene, Lattice(scene.lattice.nx, scene.lattice.ny)).solid;
  open.flip();
  return open;
}

TEST(Hole, OfWholeCellsHasThemWhereverItLies) {
  for (const double spacing : {1.0, 5e-5, 1e-3 / 3})
    for (const double at : {0.0, 0.3, 0.5, 0.7}) {
      const std::string hole =
          fmt::format("[rock.hole]\nfrom = [{:.12g}, {:.12g}]\nto = [{:.12g}, {:.12g}]\n", (9 + at) * spacing,
                      (11 + at) * spacing, (20 + at) * spacing, (18 + at) * spacing);
      EXPECT_EQ(open_nodes(rock_case(spacing, hole)), box_mask(at > 0.5 ? 10 : 9, at > 0.5 ? 12 : 11, 11, 7)) << at;
    }
}

std::string notch(double spacing, std::array<double, 2> from, std::array<double, 2> to, double aperture) {
  return fmt::format("[[rock.notches]]\nfrom = [{:.12g}, {:.12g}]\nto = [{:.12g}, {:.12g}]\naperture = {:g}\n",
                     from[0] * spacing, from[1] * spacing, to[0] * spacing, to[1] * spacing, aperture);
}

int open_rows(const std::vector<bool>& open, int nx, int x, int low, int high) {
  int rows = 0;
  for (int y = low; y < high; ++y) rows += open[y * nx + x];
  return rows;
}

TEST(Notch, HasItsOwnAperture) {
  const double spacing = 2.5e-4;
  const auto open =
      open_nodes(rock_case(spacing, notch(spacing, {8, 7}, {32, 7}, 2) + notch(spacing, {8, 22.3}, {32, 22.3}, 5)));
  for (int x = 9; x < 31; ++x) {
    EXPECT_EQ(open_rows(open, 40, x, 0, 15), 2) << x;
    EXPECT_EQ(open_rows(open, 40, x, 15, 30), 5) << x;
  }
}

/// Where notches cross both are open; where they lie on each other the wider is.
TEST(Notch, KeepsItsApertureWhereNotchesMeet) {
  const double spacing = 2.5e-4;
  auto open = open_nodes(
      rock_case(spacing, notch(spacing, {4, 15.5}, {36, 15.5}, 1) + notch(spacing, {20.5, 3}, {20.5, 27}, 3)));
  for (const int x : {6, 12, 26, 34}) EXPECT_EQ(open_rows(open, 40, x, 0, 30), 1) << x;
  for (const int y : {5, 10, 20, 25})
    EXPECT_EQ(std::count(open.begin() + 40 * y, open.begin() + 40 * (y + 1), true), 3) << y;
  open = open_nodes(
      rock_case(spacing, notch(spacing, {4, 15.5}, {36, 15.5}, 1) + notch(spacing, {20, 15.5}, {36, 15.5}, 4)));
  for (const int x : {6, 12, 15}) EXPECT_EQ(open_rows(open, 40, x, 0, 30), 1) << x;
  for (const int x : {21, 28, 34}) EXPECT_EQ(open_rows(open, 40, x, 0, 30), 4) << x;
}

/// The pre-existing fracture lies on the boundary between two rows of either lattice, at a coordinate that is not
/// exact.
TEST(Notch, OfTheShippedCasesHasThreeRows) {
  for (const char* file : {"cases/quickstart.toml", "cases/acid_fracturing/p20_da1.5.toml",
                           "cases/acid_fracturing/coarse/p20_da1.5.toml"}) {
    std::ifstream in(std::string(VUG_SOURCE_DIR) + "/" + file);
    std::stringstream text;
    text << in.rdbuf();
    const Scene scene = parse_scene(text.str(), file, {"rock.porosity=0", "rock.element_size=6e-3"});
    const double dx = scene.lattice.spacing;
    const auto solid = build_rock(scene, Lattice(scene.lattice.nx, scene.lattice.ny)).solid;
    for (int x = first_cell(0.0042 / dx); x < first_cell(0.0119 / dx); ++x) {
      int rows = 0;
      for (int y = 0; y < scene.lattice.ny; ++y) rows += !solid[static_cast<std::size_t>(y) * scene.lattice.nx + x];
      ASSERT_EQ(rows, 3) << file << ", column " << x;
    }
  }
}

/// On a mesh the lines of its group are the cracks: a notch that none of them lies on would be left out.
TEST(Notch, MustBeInTheMesh) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "notch.msh";
  std::ofstream(file) << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n1 2 \"crack\"\n$EndPhysicalNames\n"
                         "$Nodes\n4\n1 0 0 0\n2 0.01 0 0\n3 0.01 0.0075 0\n4 0 0.0075 0\n$EndNodes\n"
                         "$Elements\n3\n1 1 2 2 1 1 3\n2 2 2 1 1 1 2 3\n3 2 2 1 1 1 3 4\n$EndElements\n";
  const auto with = [&](const std::string& notches) {
    return case_of(2.5e-4,
                   "[geometry]\ntype = \"rock\"\n[rock]\npathway_aperture = 2\nmesh = \"" + file + "\"\n" + notches);
  };
  const auto count = [&](const std::string& notches) {
    const auto open = open_nodes(with(notches));
    return std::count(open.begin(), open.end(), true);
  };
  const auto wide = notch(2.5e-4, {0, 0}, {40, 30}, 6);
  EXPECT_GT(count(wide), 2.5 * static_cast<double>(count("")));
  EXPECT_GT(count(""), 60);
  try {
    count(wide + notch(2.5e-4, {5, 20}, {30, 20}, 3));
    ADD_FAILURE() << "a notch was left out";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("rock.notches.1: no line of the group"));
  }
}

}  // namespace
}  // namespace vug
