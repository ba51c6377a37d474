#pragma once
// From a scene to the modules that it needs, and no others.
#include "coupling/ageing.hpp"
#include "coupling/flow_paths.hpp"
#include "coupling/geometry.hpp"
#include "coupling/module.hpp"
#include "coupling/pore_growth.hpp"
#include "coupling/rock.hpp"
#include "dem/mechanics.hpp"
#include "kernels/base/units.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace vug {

/// Everything a simulation is made of. Modules hold references into it, so it stays where it is.
struct Parts {
  LatticeUnits units;
  Geometry geometry;
  std::optional<Rock> rock;
  std::string warning;  ///< of the picture that the rock was read from; empty without
  FlowPaths paths;      ///< of the fluid at the start
  /// In the order of a step: a module sees what those above did in this step and those below in the last.
  std::vector<std::unique_ptr<Module>> modules;
  std::unique_ptr<PoreGrowth> growth;    ///< null where no node can turn fluid
  const Mechanics* mechanics = nullptr;  ///< null without [mechanics]
  const Ageing* ageing = nullptr;        ///< null without accuracy.dissolution_tolerance

  Parts() = default;
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;
};

/// SI to lattice units for a scene: temperatures count from the initial one of the rock, concentrations in the largest
/// that the case names.
LatticeUnits units_of(const Scene& scene);

/// (row) What a lattice step costs there in the mean: the populations that it moves.
std::vector<double> row_weights(const Scene& scene, const Geometry& geometry);

/// Builds what the tables of the scene ask for: table present, module present; table absent, not a byte. The ranks
/// share the work.
std::unique_ptr<Parts> build_modules(const Exec& exec, const Scene& scene, const Ranks& ranks = {});

}  // namespace vug
