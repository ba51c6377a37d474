#include "dem/servo.hpp"

#include "base/require.hpp"
#include "kernels/launch/launch.hpp"

#include <cmath>
#include <limits>
#include <set>

namespace vug {

namespace {

/// Moves one platen, in one thread: it holds some tens of particles.
struct FollowPressure {
  ServoPlaten platen;
  double speed_per_stress;  ///< G, m/(s Pa)
  double wanted;            ///< Pa
  Particles p;

  KOKKOS_FUNCTION void operator()(int) const {
    const auto count = static_cast<int>(platen.held.extent(0));
    double force = 0;
    for (int k = 0; k < count; ++k) force += p.reaction(platen.held(k), platen.axis);
    const double pressure = -platen.outward * force / platen.length;
    const double velocity = platen.outward * speed_per_stress * (pressure - wanted);
    for (int k = 0; k < count; ++k) p.drive(platen.held(k), platen.axis) = velocity;
  }
};

/// What the bonds that join the particles in `held` to others answer along the axis, per m of thickness.
struct Behind {
  double stiffness = 0;  ///< N/m
  double damping = 0;    ///< N s/m
};

Behind behind(const std::set<int>& held, int axis, const BondParameters& rock, const Bonds& bonds) {
  const auto own_normal = on_host(bonds.elasticity.normal_modulus),
             own_tangential = on_host(bonds.elasticity.tangential_modulus),
             own_damping = on_host(bonds.elasticity.damping);
  const auto pair = on_host(bonds.pair);
  const auto length = on_host(bonds.length);
  const auto spacing = on_host(bonds.spacing);
  const auto normal = on_host(bonds.normal);
  Behind sum;
  for (int k = 0; k < bonds.count; ++k) {
    if (held.contains(pair(k, 0)) == held.contains(pair(k, 1))) continue;
    const double n2 = normal(k, axis) * normal(k, axis);
    const double m_n = bonds.elasticity.given() ? own_normal(k) : rock.normal_modulus;
    const double m_t = bonds.elasticity.given() ? own_tangential(k) : rock.tangential_modulus;
    const double eta = bonds.elasticity.given() ? own_damping(k) : rock.damping;
    sum.stiffness += length(k) / (rock.length_factor * spacing(k)) * (m_n * n2 + m_t * (1 - n2));
    sum.damping += length(k) * eta * (m_n * n2 + m_t * (1 - n2));
  }
  return sum;
}

}  // namespace

std::vector<ServoPlaten> make_servo_platens(const std::vector<BoundaryEdge>& boundary, const Assembly& assembly,
                                            const Loads& loads, const BondParameters& law, const Bonds& bonds) {
  std::vector<ServoPlaten> platens;
  for (int side = 0; side < rock_side_count; ++side) {
    if (loads.support[side] != Support::servo) continue;
    ServoPlaten platen;
    platen.axis = side % 2;
    platen.outward = side < 2 ? 1 : -1;
    platen.pressure = -platen.outward * loads.traction[side][platen.axis];
    std::set<int> held;  // a corner's triangle may have two edges on one side
    for (const BoundaryEdge& edge : boundary) {
      if (edge.side != side) continue;
      const auto &p = assembly.vertices[edge.vertex[0]], &q = assembly.vertices[edge.vertex[1]];
      const int along = 1 - platen.axis;
      platen.length += std::abs(q[along] - p[along]);
      held.insert(edge.particle);
    }
    const auto [stiffness, damping] = behind(held, platen.axis, law, bonds);
    if (!(stiffness > 0))
      throw InputError(loads.name[side] + ": a servo needs a bond between the triangles it holds and others");
    platen.compliance = servo_gain * platen.length / stiffness;
    platen.fluidity = damping > 0 ? servo_gain * platen.length / damping : std::numeric_limits<double>::infinity();
    platen.held = to_device<IndexList>("vug::dem::servo_held", {held.begin(), held.end()});
    platens.push_back(platen);
  }
  return platens;
}

void follow_pressure(const Exec& exec, const ServoPlaten& platen, double dt, double load_factor,
                     const Particles& particles) {
  for_each_node(exec, "vug::dem::follow_pressure", 1,
                FollowPressure{platen, platen.speed_per_stress(dt), load_factor * platen.pressure, particles});
}

}  // namespace vug
