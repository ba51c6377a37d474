// Prints the flow's stability map as Markdown: for docs/stability.md, see scripts/stability-map.
#include "coupling/plane_waves.hpp"
#include "support/unstable_flows.hpp"

#include <cstdio>

namespace {

using namespace vug;

constexpr double relaxation_times[] = {0.5001, 0.501, 0.505, 0.51, 0.52, 0.55, 0.6, 0.764, 1, 2, 5};
constexpr struct {
  const char* name;
  Collision collision;
} collisions[] = {{"trt", Collision::trt},
                  {"lallemand_luo", Collision::lallemand_luo},
                  {"regularised", Collision::regularised},
                  {"bgk", Collision::bgk}};

void print_header(const char* first) {
  std::printf("| %s |", first);
  for (const double tau : relaxation_times) std::printf(" %g |", tau);
  std::printf("\n| --- |");
  for (std::size_t k = 0; k < std::size(relaxation_times); ++k) std::printf(" --- |");
  std::printf("\n");
}

/// Largest speed, in steps of 0.05 up to 0.4, below which holds(collision, tau, speed) for every speed.
template <class Holds>
void print_speeds(const Holds& holds) {
  print_header("collision \\ tau");
  for (const auto& [name, collision] : collisions) {
    std::printf("| %s |", name);
    for (const double tau : relaxation_times) {
      int k = 0;
      while (k < 8 && holds(collision, tau, 0.05 * (k + 1))) ++k;
      std::printf(k > 0 ? " %.2f |" : " none |", 0.05 * k);
    }
    std::printf("\n");
  }
}

/// Largest speed of the survivor, or "lost".
void print_percolation(int ramp, double limit) {
  print_header("collision, rho' \\ tau");
  for (const auto& [name, collision] : collisions)
    for (const double difference : {0.03, 0.12, 0.36}) {
      std::printf("| %s, %.2f |", name, difference);
      for (const double tau : relaxation_times) {
        const test::Percolation run = test::percolate(collision, tau, difference, ramp, limit);
        if (!run.survives)
          std::printf(" lost |");
        else if (run.limited > 0)
          std::printf(" %.2f* |", run.largest_speed);
        else
          std::printf(" %.2f |", run.largest_speed);
      }
      std::printf("\n");
    }
}

}  // namespace

int main(int argc, char** argv) {
  Kokkos::ScopeGuard kokkos(argc, argv);
  std::printf("**Shear layer**: largest speed (lattice units, tried in steps of 0.05 up to 0.40) that survives.\n\n");
  print_speeds(test::shear_layer_survives);
  std::printf("\n**Uniform flow**, by linear analysis: largest such speed at which no plane wave grows.\n\n");
  print_speeds([](Collision collision, double tau, double speed) {
    return flow_wave_growth(collision, tau, speed) <= neutral_growth;
  });
  std::printf("\n**Percolation**, pressure ramped over 2000 steps: largest speed at the end, or lost.\n\n");
  print_percolation(2000, 0);
  std::printf("\n**Percolation**, pressure at once: the same.\n\n");
  print_percolation(0, 0);
  std::printf("\n**Percolation**, pressure at once, speed limited to 0.2 (* where the limiter was used).\n\n");
  print_percolation(0, 0.2);
}
