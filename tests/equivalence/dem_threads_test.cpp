// The same bits whatever the number of threads and of sub-steps taken at once: forces are gathered in fixed order,
// pairs are listed by their numbers.
#include "dem_support.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>
#include <utility>
#include <vector>

namespace {

using namespace vug;
using vug::test::host_copy;

template <class V>
void append(std::vector<std::uint64_t>& bits, const V& view) {
  const auto host = host_copy(view);
  for (std::size_t k = 0; k < host.span(); ++k) {
    std::uint64_t word;
    std::memcpy(&word, host.data() + k, sizeof word);
    bits.push_back(word);
  }
}

/// Platens that crush a block, a servo platen on its right flank.
Loads confined_press() {
  Loads loads;
  loads.support = {Support::servo, Support::roller, Support::roller, Support::roller};
  loads.velocity[static_cast<std::size_t>(RockSide::top)] = {0, -20};
  loads.traction[static_cast<std::size_t>(RockSide::right)] = {-5e6, 0};
  return loads;
}

/// State of a crushed block after many failures and contacts, and its energies.
std::vector<std::uint64_t> crushed(const Exec& exec) {
  MechanicsParameters parameters;
  parameters.bond.cohesion = 20e6;
  parameters.energy_ledger = true;
  const Loads loads = confined_press();
  Mechanics rock(test::block(0.04, 0.04, 2e-3, 0.25), parameters, loads);
  rock.advance(exec, 0.3 * rock.critical_step(), 1500);
  exec.fence();
  EXPECT_GT(rock.bond_counts().failed(), 50);
  std::vector<std::uint64_t> bits;
  append(bits, rock.particles().u);
  append(bits, rock.particles().v);
  append(bits, rock.particles().angle);
  append(bits, rock.bonds().d_m);
  append(bits, rock.bonds().slip);
  const Energies e = rock.energies(exec);
  for (const double value : {e.kinetic, e.elastic, e.work, e.fracture, e.friction, e.damping}) {
    std::uint64_t word;
    std::memcpy(&word, &value, sizeof word);
    bits.push_back(word);
  }
  return bits;
}

TEST(MechanicsOfThreads, GivesTheSameBitsOnOneTwoAndFour) {
  const Exec exec;
  const std::vector<std::uint64_t> all = crushed(exec);
  EXPECT_EQ(crushed(exec), all);   // a second run
#if defined(KOKKOS_ENABLE_OPENMP)  // elsewhere there is no number of threads to choose
  for (const int threads : {1, 2, 4}) EXPECT_EQ(crushed(Exec(threads)), all) << threads << " threads";
#endif
}

TEST(MechanicsResumed, GoesOnWithTheSameBits) {
  MechanicsParameters parameters;
  parameters.bond.cohesion = 20e6;
  const Loads loads = confined_press();
  const Assembly assembly = test::block(0.02, 0.02, 2e-3, 0.25);
  const Exec exec;
  Mechanics whole(assembly, parameters, loads), resumed(assembly, parameters, loads);
  const double dt = 0.3 * whole.critical_step();
  whole.advance(exec, dt, 1030);
  std::vector<std::vector<std::byte>> saved;
  whole.visit_state([&](const char*, const auto& view, auto...) {
    const auto host = host_copy(view);
    const auto* first = reinterpret_cast<const std::byte*>(host.data());
    saved.emplace_back(first, first + host.span() * sizeof(*host.data()));
  });
  std::size_t next = 0;
  resumed.visit_state([&](const char*, const auto& view, auto...) {
    const auto host = Kokkos::create_mirror_view(view);
    std::memcpy(host.data(), saved[next].data(), saved[next].size());
    Kokkos::deep_copy(view, host);
    ++next;
  });
  resumed.set_steps(whole.steps());
  resumed.set_time(whole.time());
  whole.advance(exec, dt, 500);
  resumed.advance(exec, dt, 500);
  EXPECT_GT(whole.bond_counts().failed(), 20);
  for (const auto& [a, b] :
       {std::pair{whole.particles().u, resumed.particles().u}, std::pair{whole.particles().v, resumed.particles().v}}) {
    std::vector<std::uint64_t> bits_a, bits_b;
    append(bits_a, a);
    append(bits_b, b);
    EXPECT_EQ(bits_a, bits_b);
  }
}

/// State of a block that platens break and that then is warm, with slower platens and, for a while, shorter steps.
std::vector<std::uint64_t> pressed(int at_once) {
  MechanicsParameters parameters;
  parameters.bond.cohesion = 20e6;
  parameters.rest_tolerance = 1e-3;
  Loads loads;
  loads.support = {Support::free, Support::roller, Support::roller, Support::roller};
  loads.velocity[static_cast<std::size_t>(RockSide::top)] = {0, -20};
  Mechanics rock(test::block(0.02, 0.02, 2e-3, 0.25), parameters, loads);
  const Exec exec;
  const double dt = 0.3 * rock.critical_step();
  const auto advance = [&](double step) {
    for (int s = 0; s < 480; s += at_once) rock.advance(exec, step, at_once);
  };
  advance(dt);
  Kokkos::deep_copy(rock.particles().temperature_change, 5.0);
  rock.set_platen_velocity(RockSide::top, {0, -10});
  for (const double share : {1.0, 0.8, 1.0}) advance(share * dt);
  exec.fence();
  EXPECT_GT(rock.bond_counts().failed(), 20);
  std::vector<std::uint64_t> bits;
  append(bits, rock.particles().u);
  append(bits, rock.particles().v);
  append(bits, rock.bonds().d_m);
  append(bits, rock.bonds().slip);
  return bits;
}

/// A GPU records sub-steps that are taken at once, and what it recorded must follow all that has changed since.
TEST(MechanicsAtOnce, HasTheBitsOfOneSubStepAfterTheOther) {
  const std::vector<std::uint64_t> one_by_one = pressed(1);
  for (const int at_once : {5, 48}) EXPECT_EQ(pressed(at_once), one_by_one) << at_once << " at once";
}

}  // namespace
