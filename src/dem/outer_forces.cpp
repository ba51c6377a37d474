#include "dem/outer_forces.hpp"

namespace vug {

OuterForces::OuterForces(const Assembly& assembly, const std::vector<BoundaryEdge>& boundary, const Loads& loads,
                         const Particles& particles) {
  const std::vector<LoadedPiece> pieces = pieces_of_boundary(assembly, boundary, loads, particles);
  const std::vector<AxesOfSides> owned = axes_held(pieces, loads, particles.count);
  std::vector<std::array<Vec2, 2>> arms(owned.size());       // (particle, axis) of what bears it, times the lengths
  std::vector<std::array<double, 2>> lengths(owned.size());  // likewise, m
  std::vector<int> normals(owned.size(), 0);                 // (particle) of the sides that hold it, bits as of axes
  for (const LoadedPiece& piece : pieces) {
    const auto i = static_cast<std::size_t>(piece.particle), side = static_cast<std::size_t>(piece.side);
    const SidePart* part = piece.part < 0 ? nullptr : &loads.parts[piece.part];
    Loaded loaded{piece, {}, piece.length * (part ? part->stiffness : loads.stiffness[side])};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double steady = loads.traction[side][axis];
      if (part) loaded.traction[axis] = part->traction[axis];
      // a servo's pressure is a force that holds
      else if (steady != 0 && !(support_of(piece, loads) == Support::servo && side % 2 == axis))
        loaded.traction[axis] = [steady](double) { return steady; };
      if (!piece.decides || (owned[i][side] & 1 << axis) == 0) continue;
      normals[i] |= 1 << side % 2;
      arms[i][axis] = arms[i][axis] + piece.length * piece.arm;
      lengths[i][axis] += piece.length;
    }
    if (loaded.traction[0] || loaded.traction[1] || loaded.stiffness != 0) loaded_.push_back(loaded);
  }
  for (std::size_t i = 0; i < owned.size(); ++i)
    for (std::size_t axis = 0; axis < 2; ++axis)
      if (lengths[i][axis] > 0)
        borne_.push_back({static_cast<int>(i), static_cast<int>(axis), (1 / lengths[i][axis]) * arms[i][axis]});
  for (std::size_t i = 0; i < owned.size(); ++i)
    if (normals[i] == 1 || normals[i] == 2) kept_.push_back({static_cast<int>(i), normals[i] == 1 ? 0.5 : -0.5});
}

ForceMoments OuterForces::moments(const Particles& particles, double time) const {
  const ForceMoments moments("vug::dem::outer_moments", particles.count);
  const HostWriter sum(moments);
  const auto u = on_host(particles.u), reference = on_host(particles.u_reference);
  const auto reaction = on_host(particles.reaction);
  const auto fraction = on_host(particles.solid_fraction);
  for (const auto& [i, share] : kept_)
    if (!is_gone(fraction(i))) sum(i, 3) = share;
  const auto add = [&](int i, Vec2 arm, Vec2 force) {
    if (is_gone(fraction(i))) return;
    sum(i, 0) += arm.x * force.x;
    sum(i, 1) += arm.y * force.y;
    sum(i, 2) += 0.5 * (arm.x * force.y + arm.y * force.x) + sum(i, 3) * cross(arm, force);
  };
  for (const auto& [piece, traction, stiffness] : loaded_) {
    Vec2 force{piece.length * value_at(traction[0], time), piece.length * value_at(traction[1], time)};
    const int axis = piece.side % 2;
    (axis == 0 ? force.x : force.y) -= stiffness * (u(piece.particle, axis) - reference(piece.particle, axis));
    add(piece.particle, piece.arm, force);
  }
  for (const auto& [i, axis, arm] : borne_) add(i, arm, axis == 0 ? Vec2{reaction(i, 0), 0} : Vec2{0, reaction(i, 1)});
  return moments;
}

}  // namespace vug
