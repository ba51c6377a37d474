#pragma once
// What a coupled step of a rock must move at least: the bytes of each of its parts, by how often nodes and links occur.
#include "base/base.hpp"
#include "coupling/simulation.hpp"
#include "step_parts.hpp"

#include <algorithm>
#include <array>

namespace vug::perf {

/// How often a rock's nodes and links occur.
struct Sizes {
  double nodes, fluid, surface, links9, links5, particles, bonds, substeps;
  double awake = 1;  ///< share of the rock
};

inline Sizes sizes_of(const Simulation& simulation) {
  const Parts& parts = simulation.parts();
  const FluidNodes& fluid = parts.geometry.fluid;
  const auto links = on_host(fluid.solid_links);
  double links9 = 0, links5 = 0;
  for (int i = 0; i < fluid.count; ++i)
    for (int q = 1; q < D2Q9::Q; ++q)
      if ((links(i) >> q & 1) != 0) {
        links9 += 1;
        if (D2Q9::c(q, 0) == 0 || D2Q9::c(q, 1) == 0) links5 += 1;
      }
  double substeps = 0;
  for (const Limit& limit : simulation.limits())
    if (limit.name == "sub-steps per lattice step") substeps = limit.value;
  const Lattice& lattice = parts.geometry.lattice;
  return {static_cast<double>(lattice.nx) * lattice.ny,
          static_cast<double>(fluid.count),
          static_cast<double>(parts.geometry.surface.count),
          links9,
          links5,
          static_cast<double>(parts.mechanics->particles().count),
          static_cast<double>(parts.mechanics->bonds().count),
          substeps};
}

/// Of a lattice number.
inline double bytes_of_number(const Scene& scene) {
  return scene.accuracy.precision == Precision::single_precision ? sizeof(float) : sizeof(double);
}

/// Bytes that each part must move in one lattice step: every number once, what is written without its allocation. `T`
/// is the size of a lattice number, 8 and 4 are those of a double and an index.
inline std::array<double, part_count> bytes_of(const Scene& scene, const Sizes& s) {
  const double T = bytes_of_number(scene);
  const double every = scene.accuracy.update_interval, species = static_cast<double>(scene.solute->species.size());
  const double heat_every = scene.accuracy.heat_interval, solute_every = scene.accuracy.solute_interval;
  const double carriers = heat_every == solute_every ? 1 / heat_every : 1 / heat_every + 1 / solute_every;
  std::array<double, part_count> bytes{};
  // nine populations both ways, velocity, eight indices in every second step
  bytes[flow] = s.fluid * (20 * T + 16);
  // five populations both ways, link mask, temperatures for the rock; of the fluid velocity, defect and its lag,
  // places, links
  bytes[heat] =
      (s.nodes * (10 * T + 1) + s.fluid * (5 * T + 14)) / heat_every + s.nodes * T / std::max(heat_every, every);
  // velocity in, defect out, four indices, links
  bytes[carried] = s.fluid * carriers * (3 * T + 22);
  // Five populations both ways, concentration out, velocity and defect in, four indices in every second step; of each
  // link its slot and conductance, what it turns over both ways.
  bytes[solutes] = (species * s.fluid * (14 * T + 8) + s.links5 * (4 + T + 16)) / solute_every;
  // of each link what it has turned over both ways, its number; of each surface node its own, solid volume and what
  // has dissolved both ways
  const double book = s.links5 * (16 + 4) + s.surface * (4 + 32);
  // normals from eight volumes; of each link slot, node, temperatures, rate both ways, conductance
  const double refresh = s.surface * (4 + 8 * 8 + 16) + s.links5 * (8 + 5 * T);
  bytes[reaction] = book / every + refresh / scene.accuracy.wall_interval;
  // of each link its population, slot and lever; force and torque of the particles
  bytes[fluid_force] = (s.links9 * (T + 4 + 4) + s.particles * (24 + 4)) / scene.accuracy.exchange_interval;
  // What a bond must read: pair, length, spacing, normal, arms (8 + 8 + 8 + 16 + 64), strengths (16), chemical damage
  // (8), damage of its points (16); write: stress, forces, which its particles read, and whether it is overstressed,
  // which is looked at (16 + 64 + 8). What damage costs beyond that few bonds need.
  // A particle: motion for its bonds (64); bonds (12), mass, inertia, solid share, temperature, outside and boundary
  // forces, stiffness, reference, supports (32 + 24 + 32 + 32 + 17); u, v, angle, spin and rotation both ways,
  // reaction.
  const double bond = 232, particle = 64 + 12 + 137 + 2 * 64 + 16;
  // Every look has the particles that sleep, and their bonds the one after an update of the pores.
  const double asleep = 1 - s.awake, looks = s.substeps / steps_between_looks, looked_at = 64 + 12 + 137;
  bytes[mechanics] = s.awake * s.substeps * (s.bonds * bond + s.particles * particle) +
                     asleep * (s.bonds * bond * std::min(looks, 1 / every) + s.particles * looked_at * looks) +
                     (s.nodes * T + s.surface * 12) / every;  // temperatures, dissolved shares
  bytes[pores] = s.surface * (4 + 8) / every;
  return bytes;
}

}  // namespace vug::perf
