#pragma once
// Whether a triangulation can be used as rock: no needles, no tiny triangles, no loose pieces, no edge of three
// triangles.
#include "dem/assembly.hpp"

#include <array>
#include <optional>
#include <string>

namespace vug {

/// Measures of a triangulation.
struct AssemblyQuality {
  double min_angle = 0;        ///< degrees
  double min_area_share = 0;   ///< smallest area over the mean
  double mean_edge = 0;        ///< m, over all edges
  double area = 0;             ///< m2
  int islands = 0;             ///< pieces that are not joined by a shared edge
  int overused_edges = 0;      ///< edges of three or more triangles, or of two that run along it in the same direction
  int inverted_triangles = 0;  ///< clockwise or without area
  /// m: the triangles with the smallest angle and area, one that is inverted, one in the smallest piece; an overused
  /// edge.
  std::array<double, 2> sharpest{}, smallest{}, inverted{}, apart{}, overused{};
};

/// Bounds of a usable triangulation. Outside them the mechanics would be wrong or slow: the time step is proportional
/// to the smallest height.
struct AssemblyLimits {
  double min_angle = 20;        ///< degrees
  double min_area_share = 0.2;  ///< of the mean area
  int islands = 1;
};

AssemblyQuality assembly_quality(const Assembly& assembly);

/// Why a triangulation cannot be used, and where, m.
struct Flaw {
  std::string what;
  std::optional<std::array<double, 2>> at;
};

/// What is wrong with a triangulation, and what is allowed; none when `quality` is inside `limits`.
std::optional<Flaw> flaw_of(const AssemblyQuality& quality, const AssemblyLimits& limits);

/// Throws InputError, beginning with `where`, when the assembly is not usable.
void require_usable(const Assembly& assembly, const AssemblyLimits& limits, const std::string& where);

}  // namespace vug
