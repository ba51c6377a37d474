// Rock of the example cases under steady loads, by the numbers that a user finds in history.csv, against beam theory,
// laminate theory, fracture mechanics and Kirsch.
#include "coupling/rock.hpp"
#include "dem/mean_stress.hpp"
#include "io/form.hpp"
#include "support/coupled_run.hpp"
#include "support/host_copy.hpp"
#include "support/record.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace {

using namespace vug;
using test::CoupledRun;
using test::record;

constexpr double E = 30e9, nu = 0.2;

Scene rock_case(const std::string& name, const std::vector<std::string>& overrides = {}) {
  return read_scene(VUG_SOURCE_DIR "/cases/rock/" + name + ".toml", overrides);
}

/// Of a beam of height h: second moment of area, and the shear stiffness k G A with Cowper's k for a rectangle.
double second_moment(double h) {
  return h * h * h / 12;
}
double shear_stiffness(double h) {
  const double k = 10 * (1 + nu) / (12 + 11 * nu);
  return k * E / (2 * (1 + nu)) * h;
}

TEST(ThreePointBending, SagsAsTimoshenkosBeam) {
  const CoupledRun run(rock_case("three_point_bending"));
  constexpr double P = 1e3, L = 0.16, h = 0.02;
  const double exact = P * L * L * L / (48 * E * second_moment(h)) + P * L / (4 * shear_stiffness(h));
  const double sag = 0.5 * (run.now("left_bearing_y_m") + run.now("right_bearing_y_m")) - run.now("middle_y_m");
  const double bending = P / 2 * (0.0725 - 0.02) * (h / 2 - 0.0015) / second_moment(h);
  std::printf("    sag %.4f of Timoshenko's, bearing %.6f of P/2, stress %.4f of bending theory's\n", sag / exact,
              run.now("bearing_force_y_N_per_m") / (P / 2), run.now("below_the_load_xx_Pa") / bending);
  record("three_point_bending", {{"sag", sag / exact},
                                 {"bearing", run.now("bearing_force_y_N_per_m") / (P / 2)},
                                 {"stress", run.now("below_the_load_xx_Pa") / bending}});
  EXPECT_NEAR(sag, exact, 0.03 * exact);
  EXPECT_NEAR(run.now("bearing_force_y_N_per_m"), P / 2, 0.01 * P / 2);  // bearings stand at centroids, 0.3 mm aside
  EXPECT_NEAR(run.now("below_the_load_xx_Pa"), bending, 0.03 * bending);
}

TEST(Cantilever, SagsAsTimoshenkosBeam) {
  const CoupledRun run(rock_case("cantilever"));
  constexpr double L = 0.1, h = 0.01, P = 20e3 * h;
  const double exact = -P * L * L * L / (3 * E * second_moment(h)) - P * L / shear_stiffness(h);
  const double tip = run.now("tip_y_m");
  std::printf("    tip %.4f of Timoshenko's\n", tip / exact);
  record("cantilever", {{"tip", tip / exact}, {"wall", run.now("wall_y_N_per_m") / P}});
  EXPECT_NEAR(tip, exact, 0.03 * std::abs(exact));
  EXPECT_NEAR(run.now("wall_y_N_per_m"), P, 1e-6 * P);
  EXPECT_NEAR(run.now("wall_x_N_per_m"), 0, 1e-6 * P);
}

/// Whatever the beam is made of, every section of it carries the force on its end: shear P / h in the mean.
TEST(Cantilever, CarriesItsLoadThroughEverySection) {
  const CoupledRun run(
      rock_case("cantilever", {"output.gauges=[{ name = \"half\", type = \"stress\", shape = { type = \"rectangle\", "
                               "from = [0.03, 0.0], to = [0.07, 0.01] } }]"}));
  EXPECT_NEAR(run.now("half_xy_Pa"), -20e3, 0.02 * 20e3);
  EXPECT_NEAR(run.now("half_yy_Pa"), 0, 0.02 * 20e3);
}

/// The beam's axis turns as it sags, so that of two points on it the outer one lies lower; its upper half is stretched.
TEST(Cantilever, SlidesAndIsStretchedAsABeamIs) {
  constexpr double L = 0.1, h = 0.01, P = 20e3 * h;
  const CoupledRun run(rock_case(
      "cantilever", {"output.gauges=[{ name = \"out\", type = \"opening\", points = [[0.05, 0.005], [0.1, 0.005]] }, "
                     "{ name = \"in\", type = \"opening\", points = [[0.1, 0.005], [0.05, 0.005]] }, "
                     "{ name = \"upper\", type = \"stress\", at = [0.03, 0.0085] }, "
                     "{ name = \"lower\", type = \"stress\", at = [0.03, 0.0015] }]"}));
  const auto sag = [&](double x) {
    return P * x * x * (3 * L - x) / (6 * E * second_moment(h)) + P * x / shear_stiffness(h);
  };
  const double slid = sag(L / 2) - sag(L), bending = P * (L - 0.03) * 0.0035 / second_moment(h);
  std::printf("    sliding %.4f of Timoshenko's, stress above %.4f and below %.4f of bending theory's\n",
              run.now("out_sliding_m") / slid, run.now("upper_xx_Pa") / bending, run.now("lower_xx_Pa") / -bending);
  EXPECT_NEAR(run.now("out_sliding_m"), slid, 0.03 * std::abs(slid));  // down is right of the way out: negative
  EXPECT_NEAR(run.now("in_sliding_m"), slid, 0.03 * std::abs(slid));   // up is right of the way back
  EXPECT_NEAR(run.now("out_opening_m"), 0, 0.03 * std::abs(slid));
  EXPECT_NEAR(run.now("upper_xx_Pa"), bending, 0.15 * bending);  // of single triangles, which differ by some per cent
  EXPECT_NEAR(run.now("lower_xx_Pa"), -bending, 0.15 * bending);
}

/// Between walls the layers have the modulus E / (1 - nu^2).
double confined(double young) {
  return young / (1 - nu * nu);
}

TEST(LayeredRock, AcrossItsLayersIsReuss) {
  const CoupledRun run(rock_case("layered"));
  const double reuss = 1 / (0.6 / confined(60e9) + 0.4 / confined(15e9));
  const double found = 5e6 * 0.05 / -run.now("top_y_m");
  std::printf("    modulus %.4f of Reuss, stress %.4f %.4f of that outside\n", found / reuss,
              -run.now("soft_yy_Pa") / 5e6, -run.now("stiff_yy_Pa") / 5e6);
  record("layered", {{"across", found / reuss}});
  EXPECT_NEAR(found, reuss, 0.03 * reuss);
  EXPECT_NEAR(run.now("soft_yy_Pa"), -5e6, 0.02 * 5e6);
  EXPECT_NEAR(run.now("stiff_yy_Pa"), -5e6, 0.02 * 5e6);
  EXPECT_NEAR(run.now("soft_xx_Pa"), -nu * 5e6, 0.03 * 5e6);
}

TEST(LayeredRock, AlongItsLayersIsVoigt) {
  // away from the loaded side, where a dead load makes stiff and soft layers go different ways
  const CoupledRun run(
      rock_case("layered", {"boundary.top.traction={}", "boundary.right.traction={normal_stress=5e6}"}));
  const double voigt = 0.6 * 60 + 0.4 * 15;
  const double soft = -run.now("soft_xx_Pa") / 5e6, stiff = -run.now("stiff_xx_Pa") / 5e6;
  std::printf("    soft %.4f, stiff %.4f of their shares\n", soft / (15 / voigt), stiff / (60 / voigt));
  record("layered_along", {{"soft", soft / (15 / voigt)}, {"stiff", stiff / (60 / voigt)}});
  EXPECT_NEAR(soft, 15 / voigt, 0.03 * 15 / voigt);
  EXPECT_NEAR(stiff, 60 / voigt, 0.03 * 60 / voigt);
}

TEST(LayeredRock, UnderHeatIsAsLaminateTheoryHasIt) {
  // warm layers between walls, free along x: sigma_x is zero in the mean, and by the difference of what they would grow
  std::string text =
      "[lattice]\nsize = [0.08, 0.02]\nspacing = 1e-3\ntime_step = 1e-6\n[time]\nsteps = 1\n[geometry]\ntype = "
      "\"rock\"\n[rock]\nelement_size = 1e-3\n[mechanics]\nyoung_modulus = \"30 GPa\"\npoisson_ratio = 0.2\n"
      "thermal_expansion = 1e-5\nbond = { weibull_shape = 0, normal_strength = 1e9, cohesion = 1e9 }\n";
  for (const auto& [low, high] : {std::pair{0.0, 0.005}, {0.015, 0.02}})
    text += fmt::format(
        "[[mechanics.material]]\ntype = \"rectangle\"\nfrom = [0.0, {}]\nto = [0.08, {}]\nthermal_expansion = 2e-5\n",
        low, high);
  Scene scene = parse_scene(text, "case.toml");
  const Lattice lattice(scene.lattice.nx, scene.lattice.ny);
  const Rock rock = build_rock(scene, lattice);
  Loads loads;
  loads.support[static_cast<std::size_t>(RockSide::left)] = Support::pin_roller;
  loads.support[static_cast<std::size_t>(RockSide::bottom)] = Support::pin_roller;
  Mechanics warm(rock.assembly, scene.mechanics->parameters, loads);
  Kokkos::deep_copy(warm.particles().temperature_change, 50.0);
  ASSERT_TRUE(warm.preload_statically(Exec()));
  const auto x0 = test::host_copy(warm.particles().x0);
  std::vector<int> core, rind;
  for (int i = 0; i < warm.particles().count; ++i) {
    if (x0(i, 0) < 0.03 || x0(i, 0) > 0.05) continue;
    if (std::abs(x0(i, 1) - 0.01) < 0.0045) core.push_back(i);
    if (std::abs(x0(i, 1) - 0.01) > 0.0055 && x0(i, 1) > 0.01) rind.push_back(i);
  }
  const double exact = 30e9 * 1e-5 * 50 / 2;  // half of each: E dalpha dT / 2
  const double in_core = mean_stress(warm.particles(), warm.bonds(), core).xx,
               in_rind = mean_stress(warm.particles(), warm.bonds(), rind).xx;
  std::printf("    core %.4f, rind %.4f of laminate theory\n", in_core / exact, -in_rind / exact);
  record("layered_heat", {{"core", in_core / exact}, {"rind", -in_rind / exact}});
  EXPECT_NEAR(in_core, exact, 0.03 * exact);
  EXPECT_NEAR(in_rind, -exact, 0.03 * exact);
}

TEST(DoubleCantilever, GainsTheComplianceOfItsEnergyRelease) {
  // K = P sqrt(12) (a + 0.673 h) / h^(3/2) (Fichter 1983, Int. J. Fract. 22), G = K^2 / E, dC/da = 2 G / P^2
  constexpr double P = 1e3, h = 0.02, a1 = 0.06, a2 = 0.09;
  const auto compliance = [](const std::string& a) {
    const CoupledRun run(rock_case("double_cantilever", {"rock.notches.0.to=[" + a + ", 0.02]"}));
    EXPECT_NEAR(run.now("tip_x_m"), std::stod(a), 1e-12);
    EXPECT_NEAR(run.now("tip_y_m"), 0.02, 1e-9);
    return run.now("load_opening_m") / P;
  };
  const auto cubed = [](double a) { return std::pow(a + 0.673 * h, 3); };
  const double exact = 8 / (E * h * h * h) * (cubed(a2) - cubed(a1)), found = compliance("0.09") - compliance("0.06");
  std::printf("    gain of compliance %.4f of that by energy release\n", found / exact);
  record("double_cantilever", {{"gain", found / exact}});
  EXPECT_NEAR(found, exact, 0.03 * exact);
}

/// Kirsch: stress at (r, angle) from the direction of the pull, over the pull; hole of radius a.
std::array<double, 2> kirsch(double r, double angle, double a) {
  const double q = a * a / (r * r), c = std::cos(2 * angle), s = std::sin(2 * angle);
  const double rr = 0.5 * (1 - q) + 0.5 * (1 - 4 * q + 3 * q * q) * c, tt = 0.5 * (1 + q) - 0.5 * (1 + 3 * q * q) * c,
               rt = -0.5 * (1 + 2 * q - 3 * q * q) * s;
  const double x = std::cos(angle), y = std::sin(angle);
  return {rr * x * x + tt * y * y - 2 * rt * x * y, rr * y * y + tt * x * x + 2 * rt * x * y};
}

/// Mean over a shape of a gauge, about the hole at its middle.
std::array<double, 2> kirsch_in(const Form& form) {
  std::array<double, 2> sum{0, 0};
  double points = 0;
  for (double x = -0.04; x < 0.04; x += 5e-5)
    for (double y = -0.04; y < 0.04; y += 5e-5) {
      const double r = std::hypot(x, y);
      if (r < 0.01 || !holds(form, {0.08 + x, 0.08 + y}, 0)) continue;
      const auto stress = kirsch(r, std::atan2(y, x), 0.01);
      sum[0] += stress[0], sum[1] += stress[1], points += 1;
    }
  return {sum[0] / points, sum[1] / points};
}

TEST(HoleInAPlate, HasTheStressesOfKirsch) {
  const Scene scene = rock_case("hole_in_a_plate");
  const CoupledRun run(scene);
  for (const Gauge& gauge : scene.output.gauges) {
    const auto exact = kirsch_in(*gauge.region);
    const double xx = run.now(gauge.name + "_xx_Pa") / 1e6, yy = run.now(gauge.name + "_yy_Pa") / 1e6;
    std::printf("    %s: xx %.4f (Kirsch %.4f), yy %.4f (%.4f)\n", gauge.name.c_str(), xx, exact[0], yy, exact[1]);
    record("kirsch", {{"gauge", gauge.name}, {"xx", xx}, {"exact_xx", exact[0]}, {"yy", yy}, {"exact_yy", exact[1]}});
    EXPECT_NEAR(xx, exact[0], 0.03 * std::max(1.0, std::abs(exact[0]))) << gauge.name;
    EXPECT_NEAR(yy, exact[1], 0.03 * std::max(1.0, std::abs(exact[1]))) << gauge.name;
  }
}

TEST(Gravity, PressesAsTheWeightAbove) {
  const CoupledRun run(
      "[lattice]\nsize = [0.02, 0.04]\nspacing = 1e-3\ntime_step = 1e-6\n[time]\nsteps = 1\n[geometry]\ntype = "
      "\"rock\"\n"
      "[rock]\nelement_size = 2e-3\n[mechanics]\ngravity = [0.0, -9.81]\n[boundary.bottom]\ntraction = { support = "
      "\"roller\" }\n[boundary.left]\ntraction = { support = \"roller\" }\n[[output.gauges]]\nname = \"floor\"\ntype = "
      "\"reaction\"\nside = \"bottom\"\n");
  const double weight = 2500 * 9.81 * 0.02 * 0.04;
  EXPECT_NEAR(run.now("floor_y_N_per_m"), weight, 1e-9 * weight);
}

}  // namespace
