// The paper's wall takes another amount of acid than the rock that dissolves accounts for: docs/model.md says how much.
#include "support/coupled_run.hpp"
#include "support/run_vug.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace vug {
namespace {

/// The per cents of the page's row that begins with `| name |`.
std::vector<double> row_of_the_page(const std::string& name) {
  const std::string page = test::contents(VUG_SOURCE_DIR "/docs/model.md");
  const std::string begin = "  | " + name + " | ";
  const std::size_t at = page.find(begin);
  if (at == std::string::npos) return {};
  std::istringstream cells(page.substr(at + begin.size(), page.find('\n', at) - at - begin.size()));
  std::vector<double> numbers;
  for (std::string cell; std::getline(cells, cell, '|');) numbers.push_back(std::stod(cell));
  return numbers;
}

/// Acid that the walls took, as the volume that it dissolves, over the volume that dissolved, less 1.
double error(const std::string& velocity_set, const std::string& rate_constant, const std::string& wall = "paper") {
  test::CoupledRun run(
      read_scene(test::small_rock, {"reaction.surface_normal=false", "reaction.wall=" + wall,
                                    "reaction.rate_constant=" + rate_constant, "solute.velocity_set=" + velocity_set}));
  run.steps(400);
  return run.gain("dissolved_volume", "acid_times_molar_volume") / run.now("dissolved_volume_m3_per_m") - 1;
}

TEST(PaperWall, TakesAsMuchMoreOrLessAcidAsThePageSays) {
  const std::vector<std::string> rates = {"1e-7", "1e-5", "1e-3", "0.1", "10"};
  for (const auto& [set, row] : {std::pair{"d2q5", "D2Q5"}, std::pair{"d2q9", "D2Q9"}}) {
    const std::vector<double> page = row_of_the_page(row);
    ASSERT_EQ(page.size(), rates.size()) << row;
    for (std::size_t i = 0; i < rates.size(); ++i)  // rounded to whole per cents; bonds may fail a sub-step later
      EXPECT_NEAR(100 * error(set, rates[i]), page[i], std::max(1.0, 0.01 * std::abs(page[i])))
          << row << ", " << rates[i];
  }
}

TEST(PaperWall, IsAloneInThat) {
  for (const char* rate : {"1e-7", "10"}) EXPECT_NEAR(error("d2q9", rate, "kinetic"), 0, 1e-9) << rate;
}

}  // namespace
}  // namespace vug
