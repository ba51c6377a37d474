#pragma once
// Loads on the outside of the rock: stress and supports on its four sides, and gravity.
#include "dem/particles.hpp"
#include "dem/support.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace vug {

/// The four sides of the rock, numbered like the outward axes +x, +y, -x, -y.
enum class RockSide : int { right = 0, top = 1, left = 2, bottom = 3 };
inline constexpr int rock_side_count = 4;

/// A number as a function of the time since the preload, s; empty: 0.
using OverTime = std::function<double(double)>;
inline double value_at(const OverTime& number, double time) {
  return number ? number(time) : 0;
}

/// A part of a side with its own load and support; there the loads of the side itself do not apply.
struct SidePart {
  RockSide side = RockSide::right;
  double from = 0, to = 0;  ///< m along the side; if equal: the edge at that place
  Support support = Support::free;
  std::array<OverTime, 2> traction;  ///< force on the rock per area along x and y, Pa; of a part that is not held
  double stiffness = 0;              ///< of the rock beyond, Pa/m
  std::array<OverTime, 2> velocity;  ///< of a held part, m/s; at rest during a preload
  bool changes = false;              ///< whether a traction changes in time
  std::string name = {};             ///< in messages
  bool moves() const { return velocity[0] || velocity[1]; }
};

/// Loads of the four sides in the order of RockSide.
struct Loads {
  /// Force on the rock per area, Pa: {-5e6, 0} on the right presses. On a servo side the normal part is the target.
  std::array<std::array<double, 2>, 4> traction{};
  std::array<Support, 4> support{Support::free, Support::free, Support::free, Support::free};
  std::array<std::array<double, 2>, 4> velocity{};  ///< of the platen of a held side, m/s
  /// Stiffness of the rock beyond a free side: stress that it adds per distance that the side moves outwards after the
  /// preload, Pa/m; about its Young's modulus over the size of the specimen. 0: a dead load, whatever the rock does.
  std::array<double, 4> stiffness{};
  std::array<double, 2> gravity{};  ///< m/s2
  std::vector<SidePart> parts;      ///< where they overlap, the later one counts
  std::array<std::string, 4> name{"right side", "top side", "left side", "bottom side"};  ///< in messages
  /// Largest stress that loads the rock at any time, from these or other loads, Pa; limits how much unrest sleeping
  /// rock may have (rest.hpp). 0: unknown.
  double largest = 0;
  double change = 0;  ///< by how much such a stress changes after the preload, Pa; 0: unknown
};

/// An edge of the rock's boundary.
struct BoundaryEdge {
  int particle;
  std::array<int, 2> vertex;  ///< p, q with the rock on their left
  int side;                   ///< RockSide, or -1: hole, notch or inner surface
};

/// All boundary edges. An edge belongs to a side when both its ends lie on that side of the assembly's bounding box and
/// its outward normal points out there; of two such sides, in a corner, to the one that it faces more.
std::vector<BoundaryEdge> find_boundary(const Assembly& assembly);

/// Whether parts of the boundary are in front of others, as in holes, in slots and between pieces: true for any outline
/// that is not convex. Such rock may touch itself before a bond has failed.
bool faces_itself(const Assembly& assembly, const std::vector<BoundaryEdge>& boundary);

/// Steady loads of each particle, ready for the integrator. The torque of a dead load changes as the particle turns:
///   T = (cos - 1) A - sin B + A with A = sum of r × F and B = sum of r . F at the start.
struct BoundaryLoads {
  VectorField<double> force;      ///< (particle, axis) N
  VectorField<double> moment;     ///< (particle, A or B) N m
  VectorField<double> stiffness;  ///< (particle, axis) of the rock beyond, at the centroid, N/m
  double gravity_x = 0;           ///< m/s2
  double gravity_y = 0;
};

/// An edge of the boundary, or a piece of one, that belongs to one part of a side, or to the side itself (-1).
struct LoadedPiece {
  int part = -1;
  int side = 0;  ///< RockSide
  int particle = 0;
  double length = 0;    ///< along the side, m
  Vec2 arm;             ///< from the particle's centroid to the middle of the piece, m
  bool holds = true;    ///< whether its support holds the edge, alone or with pieces alike
  bool decides = true;  ///< whether it decides how the particle is held
};

/// Support of a piece.
Support support_of(const LoadedPiece& piece, const Loads& loads);

/// All edges of the four sides, cut into pieces, in the order of the boundary. A support holds an edge if its pieces
/// are more than half of it.
std::vector<LoadedPiece> pieces_of_boundary(const Assembly& assembly, const std::vector<BoundaryEdge>& boundary,
                                            const Loads& loads, const Particles& particles);

/// (side) Axes, bit 0: x, bit 1: y.
using AxesOfSides = std::array<int, 4>;

/// (particle, side) The axes along which the support of this side holds the particle, so that it moves with the side
/// and its reaction there belongs to the side. An axis that several sides hold, in a corner, belongs to the side whose
/// normal it is, else to the first in the order of RockSide. The reactions of all sides therefore add up to the force
/// that holds the rock.
std::vector<AxesOfSides> axes_held(const std::vector<LoadedPiece>& pieces, const Loads& loads, int particles);

/// Applies tractions at the middles of the pieces, and writes the supports into held and drive of the particles. Parts
/// are taken at time zero and without their velocities. Throws InputError where a load finds no edge of the rock to act
/// on, or a support none to hold, unless later parts hide it completely.
BoundaryLoads apply_loads(const Assembly& assembly, const std::vector<BoundaryEdge>& boundary, const Loads& loads,
                          const Particles& particles);

/// Sets the velocity of the platen at a held side.
void set_platen_velocity(const std::vector<BoundaryEdge>& boundary, RockSide side, std::array<double, 2> velocity,
                         const Particles& particles);

}  // namespace vug
