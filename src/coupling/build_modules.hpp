#pragma once
// Builds the modules that a scene needs, and no others.
#include "coupling/ageing.hpp"
#include "coupling/flow_paths.hpp"
#include "coupling/geometry.hpp"
#include "coupling/module.hpp"
#include "coupling/pore_growth.hpp"
#include "coupling/rock.hpp"
#include "dem/mechanics.hpp"
#include "io/units.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace vug {

/// All parts of a simulation. Modules hold references into it, so it must not be moved.
struct Parts {
  LatticeUnits units;
  Geometry geometry;
  std::optional<Rock> rock;
  std::string warning;  ///< of the picture that the rock was read from; otherwise empty
  FlowPaths paths;      ///< of the fluid at the start
  /// In the order of a step: a module sees this step's results of the modules before it and the previous step's of
  /// those after it.
  std::vector<std::unique_ptr<Module>> modules;
  std::unique_ptr<PoreGrowth> growth;     ///< null where no node can become fluid
  const Mechanics* mechanics = nullptr;   ///< null without [mechanics]
  std::function<int()> fragments_let_go;  ///< number of triangles so far; null without [mechanics]
  const Ageing* ageing = nullptr;         ///< null without accuracy.dissolution_tolerance

  Parts() = default;
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;
};

/// Conversion from SI to lattice units for a scene. Temperatures are relative to the initial one of the rock; the unit
/// of concentration is the largest value in the case.
LatticeUnits units_of(const Scene& scene);

/// (row) Mean cost of a lattice step in each row of the lattice: the number of populations that are moved.
std::vector<double> row_weights(const Scene& scene, const Geometry& geometry);

/// Builds a module for each table of the scene; an absent table takes no memory. The ranks share the work.
std::unique_ptr<Parts> build_modules(const Exec& exec, const Scene& scene, const Ranks& ranks = {});

}  // namespace vug
