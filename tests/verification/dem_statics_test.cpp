// Bodies that have come to rest: thermal strain, stiffness, preload.
#include "dem_support.hpp"
#include "support/record.hpp"
#include "support/tectonic_loads.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace {

using namespace vug;
using vug::test::elastic;
using vug::test::host_copy;

TEST(ThermalExpansion, OfAFreeBlockIsExactAndLeavesNoStress) {
  const double dT = 50, alpha = 8e-6, size = 0.02;
  MechanicsParameters parameters = elastic();
  Mechanics rock(test::block(size, size, 2e-3, 0.2), parameters, {});
  const Particles& p = rock.particles();
  Kokkos::deep_copy(p.temperature_change, dT);
  const auto x0 = host_copy(p.x0);
  for (int i = 0; i < p.count; ++i) test::place(p, i, alpha * dT * x0(i, 0), alpha * dT * x0(i, 1));
  rock.advance(Exec(), 0.3 * rock.critical_step(), 1);
  const auto stress = host_copy(rock.bonds().stress);
  for (int k = 0; k < rock.bonds().count; ++k) {
    // round-off of displacements alpha dT L over the bond length
    EXPECT_LT(std::abs(stress(k, 0)), 1e-10 * 27.8e9 * alpha * dT);
    EXPECT_LT(std::abs(stress(k, 1)), 1e-10 * 27.8e9 * alpha * dT);
  }
}

TEST(ThermalExpansion, RelaxesToTheFreeShapeFromTheColdOne) {
  const double dT = -50, alpha = 8e-6;
  MechanicsParameters parameters = elastic();
  parameters.bond.damping = 4.6e-5;
  parameters.local_damping = 0.3;
  Mechanics rock(test::block(0.01, 0.01, 2e-3, 0.2), parameters, {});
  const Particles& p = rock.particles();
  Kokkos::deep_copy(p.temperature_change, dT);
  rock.advance(Exec(), 0.3 * rock.critical_step(), 20000);
  const auto x0 = host_copy(p.x0), u = host_copy(p.u);
  for (int i = 1; i < p.count; ++i) {
    const double distance = std::hypot(x0(i, 0) - x0(0, 0), x0(i, 1) - x0(0, 1));
    const double now = std::hypot(x0(i, 0) + u(i, 0) - x0(0, 0) - u(0, 0), x0(i, 1) + u(i, 1) - x0(0, 1) - u(0, 1));
    EXPECT_NEAR(now / distance - 1, alpha * dT, 1e-8 * std::abs(alpha * dT) + 1e-14);
  }
}

TEST(ThermalExpansion, OfAClampedBlockGivesTheStressOfTheBondModuli) {
  const double dT = 20, alpha = 8e-6, size = 0.04;
  MechanicsParameters parameters = elastic();
  parameters.bond.damping = 4.6e-5;
  parameters.local_damping = 0.3;
  Loads loads;
  loads.support = {Support::roller, Support::roller, Support::roller, Support::roller};
  Mechanics rock(test::block(size, size, 2e-3, 0.2), parameters, loads);
  Kokkos::deep_copy(rock.particles().temperature_change, dT);
  rock.advance(Exec(), 0.3 * rock.critical_step(), 6000);
  // sigma = -M_n / chi alpha dT: every bond is shortened by its spacing times the strain. The platens hold centroids
  // (a third of a row inside), so the reaction at a side is compared, which is the stress across the whole block.
  const double expected = 24.03e9 / 0.659 * alpha * dT * size;
  test::record("clamped_heating", {{"left", rock.reaction(RockSide::left).x / size},
                                   {"bottom", rock.reaction(RockSide::bottom).y / size},
                                   {"exact", expected / size}});
  EXPECT_NEAR(rock.reaction(RockSide::left).x, expected, 0.01 * expected);
  EXPECT_NEAR(rock.reaction(RockSide::bottom).y, expected, 0.01 * expected);
}

/// Held along one side of each direction only, it is free to shrink: from the mean planes of what is held.
TEST(ThermalExpansion, OfABlockOnTwoRollersLeavesNoStress) {
  const double dT = -200, alpha = 8e-6, size = 0.02;
  for (const bool of_two_materials : {false, true}) {
    MechanicsParameters parameters = elastic();
    parameters.bond.damping = 4.6e-5;
    parameters.local_damping = 0.7;
    Assembly assembly = test::block(size, size, 2e-3, 0.2);
    if (of_two_materials) {
      RockMaterial other;
      other.bond = parameters.bond;
      parameters.materials = {other};
      assembly.region.assign(assembly.triangles.size(), 0);
      assembly.region.back() = 1;
    }
    Loads loads;
    loads.support[static_cast<std::size_t>(RockSide::left)] = Support::roller;
    loads.support[static_cast<std::size_t>(RockSide::bottom)] = Support::roller;
    Mechanics rock(assembly, parameters, loads);
    for (const double share : {0.3, 1.0}) {
      Kokkos::deep_copy(rock.particles().temperature_change, share * dT);
      rock.advance(Exec(), 0.3 * rock.critical_step(), 24000);
    }
    const double held_back = 27.8e9 * alpha * std::abs(dT);
    const auto stress = host_copy(rock.bonds().stress);
    for (int k = 0; k < rock.bonds().count; ++k)
      for (const int component : {0, 1}) ASSERT_LT(std::abs(stress(k, component)), 1e-6 * held_back) << k;
    const auto x0 = host_copy(rock.particles().x0), u = host_copy(rock.particles().u);
    std::set<int> left;
    for (const BoundaryEdge& edge : rock.boundary())
      if (edge.side == static_cast<int>(RockSide::left)) left.insert(edge.particle);
    double plane = 0;
    for (const int i : left) plane += x0(i, 0) / static_cast<double>(left.size());
    for (int i = 0; i < rock.particles().count; ++i)
      EXPECT_NEAR(u(i, 0), alpha * dT * (x0(i, 0) - plane), 1e-6 * alpha * std::abs(dT) * size) << i;
  }
}

/// Distance between the centroids on the left and on the right side: there the rollers hold and the rock beyond pushes.
double distance_of_sides(const Mechanics& rock) {
  const auto x0 = host_copy(rock.particles().x0);
  double sum[2] = {}, n[2] = {};
  for (const BoundaryEdge& edge : rock.boundary()) {
    if (edge.side != static_cast<int>(RockSide::left) && edge.side != static_cast<int>(RockSide::right)) continue;
    const int s = edge.side == static_cast<int>(RockSide::right) ? 1 : 0;
    sum[s] += x0(edge.particle, 0);
    n[s] += 1;
  }
  return sum[1] / n[1] - sum[0] / n[0];
}

TEST(RockBeyond, CarriesTheShareOfAThermalExpansionThatItsStiffnessSays) {
  const double dT = 20, alpha = 8e-6, size = 0.02, modulus = 27.8e9;
  for (const double ratio : {0.25, 1.0, 4.0}) {  // of its stiffness to that of the block, E / L
    MechanicsParameters parameters = elastic();
    parameters.bond.damping = 4.6e-5;
    parameters.local_damping = 0.7;
    Loads loads;
    loads.support[static_cast<std::size_t>(RockSide::left)] = Support::roller;
    loads.support[static_cast<std::size_t>(RockSide::bottom)] = Support::roller;
    loads.stiffness[static_cast<std::size_t>(RockSide::right)] = ratio * modulus / size;
    Mechanics rock(test::block(size, size, 2e-3, 0.2), parameters, loads);
    Kokkos::deep_copy(rock.particles().temperature_change, dT);
    rock.advance(Exec(), 0.3 * rock.critical_step(), 12000);
    const Energies energies = rock.energies(Exec());
    ASSERT_LT(energies.kinetic, 1e-7 * energies.elastic) << ratio;  // a soft spring rings for long
    // two springs in series, one of which wants to be longer by its thermal expansion
    const double length = distance_of_sides(rock);
    const double expected = alpha * dT * length / (length / modulus + size / (ratio * modulus)) * size;
    EXPECT_NEAR(rock.reaction(RockSide::left).x, expected, 0.02 * expected) << ratio;
  }
}

TEST(ElasticBlock, HasTheModulusAndPoissonRatioOfTheLaboratory) {
  const double width = 0.05, height = 0.1, pressure = 1e6;
  for (const int along : {0, 1}) {
    Loads loads;
    const double size[2] = {along == 1 ? width : height, along == 1 ? height : width};
    loads.traction[static_cast<std::size_t>(along == 1 ? RockSide::top : RockSide::right)]
                  [static_cast<std::size_t>(along)] = -pressure;
    loads.traction[static_cast<std::size_t>(along == 1 ? RockSide::bottom : RockSide::left)]
                  [static_cast<std::size_t>(along)] = pressure;
    MechanicsParameters parameters = elastic();
    Mechanics rock(test::block(size[0], size[1], 2.5e-3, 0.25), parameters, loads);
    const PreloadReport report = rock.preload(Exec(), 1e-4);
    ASSERT_TRUE(report.settled);
    // strains by regression of displacements over the middle 60 %
    const auto x0 = host_copy(rock.particles().x0), u = host_copy(rock.particles().u);
    double strain[2];
    for (int axis = 0; axis < 2; ++axis) {
      double n = 0, sx = 0, su = 0, sxx = 0, sxu = 0;
      for (int i = 0; i < rock.particles().count; ++i) {
        const double place = x0(i, along) / height;
        if (place < 0.2 || place > 0.8) continue;
        n += 1, sx += x0(i, axis), su += u(i, axis), sxx += x0(i, axis) * x0(i, axis), sxu += x0(i, axis) * u(i, axis);
      }
      strain[axis] = (n * sxu - sx * su) / (n * sxx - sx * sx);
    }
    RecordProperty(along == 0 ? "modulus_x" : "modulus_y", std::to_string(-pressure / strain[along]));
    EXPECT_NEAR(-pressure / strain[along], 27.8e9, 0.03 * 27.8e9);
    // 0.237 measured on Delaunay meshes; scatter of the element layout
    RecordProperty(along == 0 ? "poisson_x" : "poisson_y", std::to_string(-strain[1 - along] / strain[along]));
    EXPECT_NEAR(-strain[1 - along] / strain[along], 0.237, 0.03);
  }
}

TEST(Preload, LeavesTheTectonicStressInTheRockAndNothingBroken) {
  Loads loads = test::tectonic();
  const double width = 0.05, height = 0.035;
  Mechanics rock(test::block(width, height, 2.5e-3, 0.2), {}, loads);
  const PreloadReport report = rock.preload(Exec(), 5 * width / 3300);
  EXPECT_TRUE(report.settled);
  EXPECT_EQ(report.bonds.damaged + report.bonds.failed(), 0);
  EXPECT_NEAR(rock.reaction(RockSide::left).x, 5e6 * height, 1e-3 * 5e6 * height);
  EXPECT_NEAR(rock.reaction(RockSide::bottom).y, 7.5e6 * width, 1e-3 * 7.5e6 * width);
  rock.advance(Exec(), 0.3 * rock.critical_step(), 1000);
  EXPECT_LT(rock.energies(Exec()).kinetic, 1e-5 * rock.energies(Exec()).elastic);  // it stays at rest without damping
  // rock beyond the sides takes no part in the preload: the same stress, the same shape
  loads.stiffness[static_cast<std::size_t>(RockSide::right)] = 1e12;
  Mechanics backed(test::block(width, height, 2.5e-3, 0.2), {}, loads);
  backed.preload(Exec(), 5 * width / 3300);
  EXPECT_NEAR(backed.reaction(RockSide::left).x, 5e6 * height, 1e-3 * 5e6 * height);
}

}  // namespace
