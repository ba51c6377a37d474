// Rock that is moved: a plane impact and the crack that its wave sets going, bodies that meet, loads over time.
#include "support/coupled_run.hpp"
#include "support/record.hpp"

#include <gtest/gtest.h>

namespace {

using namespace vug;
using test::CoupledRun;
using test::record;

constexpr double E = 30e9, nu = 0.2, density = 2500;

/// Of plane waves in a plate in plane stress: c = sqrt(E / (1 - nu^2) / rho).
double wave_speed() {
  return std::sqrt(E / (1 - nu * nu) / density);
}

TEST(Impact, SendsAWaveOfRhoCVAtC) {
  CoupledRun run(read_scene(VUG_SOURCE_DIR "/cases/rock/impact.toml", {"output.interval=1e-6"}));
  const double c = wave_speed(), stress = density * c * 1.2;
  double arrival = 0, plateau = 0, samples = 0, time = 0;
  while (time < 25e-6) {
    run.steps(2);
    time += 2e-7;
    const double now = -run.now("middle_xx_Pa");
    if (arrival == 0 && now > 0.5 * stress) arrival = time;
    if (time > 0.04 / c + 4e-6 && time < 0.04 / c + 12e-6) plateau += now, samples += 1;
  }
  plateau /= samples;
  const double speed = 0.04 / (arrival - 0.5e-6);  // the platen gets to half of its speed in half a microsecond
  std::printf("    wave speed %.4f of c, stress %.4f of rho c v\n", speed / c, plateau / stress);
  record("impact", {{"speed", speed / c}, {"stress", plateau / stress}});
  EXPECT_NEAR(speed, c, 0.03 * c);
  EXPECT_NEAR(plateau, stress, 0.03 * stress);
}

TEST(Impact, SetsACrackGoingThatStaysSlowerThanRayleighWaves) {
  CoupledRun run(read_scene(VUG_SOURCE_DIR "/cases/rock/impact.toml"));
  const double rayleigh = (0.862 + 1.14 * nu) / (1 + nu) * std::sqrt(E / (2 * (1 + nu)) / density);
  double start = 0, last = 0.005, fastest = 0, time = 0, from = 0.005, since = 0;
  while (time < 60e-6 && last < 0.018) {
    run.steps(20);
    time += 2e-6;
    const double tip = run.now("crack_y_m");
    EXPECT_GE(tip, last - 1e-12);
    if (start == 0 && tip > 0.0061) start = time;
    if (time - since > 5.9e-6) {
      fastest = std::max(fastest, (tip - from) / (time - since));
      from = tip, since = time;
    }
    last = tip;
  }
  std::printf("    crack starts at %.1f us, reaches %.1f mm, fastest %.3f of Rayleigh's\n", 1e6 * start, 1e3 * last,
              fastest / rayleigh);
  record("impact_crack", {{"start", start}, {"tip", last}, {"fastest", fastest / rayleigh}});
  EXPECT_GT(start, 0.14 / wave_speed());  // not before the wave has come back from the free side, 100 + 40 mm
  EXPECT_GT(last, 0.01);
  EXPECT_LT(fastest, rayleigh);
}

TEST(MeetingBodies, ShareTheirMomentumAcrossACrack) {
  // two halves of a bar, parted by a crack: the left one flies at 1 m/s, and stops as the right one takes its speed
  CoupledRun run(
      "[lattice]\nsize = [0.04, 0.01]\nspacing = 1e-3\ntime_step = 1e-7\n[time]\nsteps = 1000\n[geometry]\ntype = "
      "\"rock\"\n[rock]\nelement_size = 1e-3\n[[rock.notches]]\nfrom = [0.02, 0.0]\nto = [0.02, 0.01]\n[mechanics]\n"
      "young_modulus = \"30 GPa\"\npoisson_ratio = 0.0\npreload_time = 0\nbond = { weibull_shape = 0 }\n"
      "[[mechanics.initial_velocity]]\ntype = \"rectangle\"\nfrom = [0.0, 0.0]\nto = [0.02, 0.01]\nvelocity = [1.0, "
      "0.0]\n"
      "[[output.gauges]]\nname = \"left\"\ntype = \"displacement\"\nat = [0.01, 0.005]\n[[output.gauges]]\nname = "
      "\"right\"\ntype = \"displacement\"\nat = [0.03, 0.005]\n");
  const double c = std::sqrt(E / density), before = 2 * 0.02 / c;
  run.steps(static_cast<int>(1.5 * before / 1e-7));  // the waves of both have come back to the crack
  const double left = run.now("left_x_m"), right = run.now("right_x_m");
  run.steps(100);
  const double v_left = (run.now("left_x_m") - left) / 1e-5, v_right = (run.now("right_x_m") - right) / 1e-5;
  std::printf("    afterwards %.3f and %.3f m/s\n", v_left, v_right);
  record("meeting_bodies", {{"left", v_left}, {"right", v_right}});
  EXPECT_NEAR(v_left, 0, 0.05);
  EXPECT_NEAR(v_right, 1, 0.05);
}

}  // namespace
