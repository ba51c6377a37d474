// Laboratory tests of a case from its keys to its files: stresses by Hooke's law.
#include "coupling/laboratory_run.hpp"

#include "base/require.hpp"
#include "coupling/laboratory_report.hpp"
#include "io/history_reader.hpp"
#include "support/temporary_folder.hpp"
#include "unit/laboratory_case.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace vug {
namespace {

using test::laboratory;
using test::platens_of;

/// Rows of stress_strain.csv of a test.
class Curve {
 public:
  explicit Curve(const Scene& scene) {
    LaboratoryOptions options;
    options.directory = folder_ / "out";
    run_laboratory(scene, options);
    curve_ = read_history(options.directory + "/stress_strain.csv");
  }
  double last(const std::string& column) const { return curve_.values.at(curve_.find(column)).back(); }

 private:
  test::TemporaryFolder folder_;
  History curve_;
};

TEST(LaboratoryReport, IsOfTheMeanOfAllSpecimens) {
  const auto specimen = [](int in_tension, int along, double work) {
    LoadedSpecimen one;
    one.result.stress = {2, 1};
    one.result.strength = 2;
    one.result.bonds_at_end.failed_in_tension = in_tension;
    one.result.energies.work = work;
    one.along_load = along;
    return one;
  };
  const std::vector<LoadedSpecimen> two{specimen(133, 7, 10), specimen(161, 140, -30)};
  Results results;
  const std::string text = report_of(two, "", results) + report_energies(two, results);
  const auto of = [&](const std::string& name) {
    for (const auto& [known, value] : results)
      if (known == name) return value;
    return 0.0;
  };
  EXPECT_EQ(of("failed_in_tension_1"), 147);
  EXPECT_DOUBLE_EQ(of("failed_along_load_1"), 0.5);
  EXPECT_DOUBLE_EQ(of("work_J_per_m"), -10);
  EXPECT_DOUBLE_EQ(std::abs(of("missing_J_per_m")), 30) << "of the one in which it is most";
  EXPECT_NE(text.find("147 and 0 at the end"), std::string::npos) << text;
}

/// Between platens that stand still: E alpha dT, with flanks that are free.
TEST(LaboratoryOfACase, HeatsToTheStressOfItsModulus) {
  const Scene scene = laboratory("heating", {"laboratory.temperature_change=50", "laboratory.sample_strain=2e-5"});
  ASSERT_DOUBLE_EQ(platens_of(scene).heating_rate, 50 / 1e-3);  // more slowly it would not end
  const Curve curve(scene);
  EXPECT_NEAR(curve.last("strain_1"), 8e-6 * 50, 2e-5);
  EXPECT_NEAR(curve.last("stress_Pa"), 30e9 * curve.last("strain_1"), 0.05 * 30e9 * 8e-6 * 50);
}

/// Plane strain, by the numbers that docs/case-file.md gives for it: rock that grows by alpha dT, free to do so across
/// the load alone. Hooke in three dimensions, eps_y = eps_z = 0 and sigma_x = 0: sigma_y = E alpha dT/(1 - nu).
TEST(LaboratoryOfACase, HeatsInPlaneStrain) {
  const double young = 28e9, poisson = 0.25, expansion = 8e-6, rise = 50;
  const auto number = [](const char* key, double value) { return key + std::to_string(value); };
  const auto of_plane = [&](double alpha) {
    std::ostringstream in_plane;
    in_plane << "mechanics.thermal_expansion=" << alpha;
    return laboratory("heating", {"laboratory.temperature_change=50", "laboratory.sample_strain=2e-5",
                                  number("mechanics.young_modulus=", young / (1 - poisson * poisson)),
                                  number("mechanics.poisson_ratio=", poisson / (1 - poisson)), in_plane.str()});
  };
  const double expected = young * expansion * rise / (1 - poisson);
  EXPECT_NEAR(Curve(of_plane((1 + poisson) * expansion)).last("stress_Pa"), expected, 0.05 * expected);
  EXPECT_LT(Curve(of_plane(expansion)).last("stress_Pa"), 0.85 * expected);  // 1/(1 + nu) of it
}

/// A base that does not grow, and grains that do: 0.5 alpha dT.
TEST(LaboratoryOfACase, HeatsRockOfSeveralMaterials) {
  const std::vector<std::string> changes{"laboratory.temperature_change=50", "laboratory.sample_strain=2e-5",
                                         "mechanics.thermal_expansion=0",
                                         "mechanics.material=[{type='rectangle', from=[0.0, 0.0], to=[0.015, 0.015], "
                                         "thermal_expansion=8e-6}]"};
  const Scene scene = laboratory("heating", changes);
  const double half = platens_of(scene).largest_strain;
  EXPECT_NEAR(half, 8e-6 * 50 * 0.5, 0.1 * 8e-6 * 50);  // by whole triangles
  const Curve curve(scene);
  EXPECT_DOUBLE_EQ(curve.last("strain_1"), half);
  EXPECT_NEAR(curve.last("stress_Pa"), 30e9 * half, 0.05 * 30e9 * half);
  EXPECT_THROW(laboratory("heating", {changes[0], "laboratory.sample_strain=3e-4", changes[2]}), InputError);
  EXPECT_THROW(platens_of(laboratory("heating", {changes[0], "laboratory.sample_strain=3e-4", changes[2], changes[3]})),
               InputError);
}

/// Hooke's law with and without: sigma_1 = E epsilon_1 + nu sigma_3.
TEST(LaboratoryOfACase, ConfinesBetweenPlatensOfAServo) {
  const std::vector<std::string> elastic{"laboratory.largest_strain=4e-4", "laboratory.sample_strain=2e-5",
                                         "mechanics.poisson_ratio=0.25"};
  std::vector<std::string> held = elastic;
  held.insert(held.end(), {"laboratory.confinement=20 MPa", "laboratory.confinement_by=servo"});
  const Curve plain(laboratory("compression", elastic)), confined(laboratory("compression", held));
  EXPECT_NEAR(confined.last("confinement_Pa"), 20e6, 0.02 * 20e6);
  EXPECT_NEAR(confined.last("stress_Pa") - plain.last("stress_Pa"), 0.25 * 20e6, 0.15 * 0.25 * 20e6);
}

}  // namespace
}  // namespace vug
