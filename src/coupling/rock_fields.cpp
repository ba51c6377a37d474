#include "coupling/rock_fields.hpp"

#include "dem/dissolved_rock.hpp"
#include "dem/mean_stress.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <utility>

namespace vug {

void add_rock_fields(const Mechanics& rock, FieldList& list, const std::vector<std::string>& asked_for) {
  const Particles& particles = rock.particles();
  const Bonds& bonds = rock.bonds();
  // The copies on the host are made when a field is opened; value(item, component) reads them.
  const auto add = [](std::vector<Field>& group, std::string name, std::string unit, int components, auto open) {
    group.push_back({std::move(name), std::move(unit), components, [components, open = std::move(open)] {
                       return [components, value = open()](std::size_t first, std::span<double> out) {
                         for (std::size_t k = 0; k < out.size(); ++k)
                           out[k] =
                               static_cast<double>(value(first + k / components, static_cast<int>(k % components)));
                       };
                     }});
  };
  const auto scalar = [&add](std::vector<Field>& group, std::string name, std::string unit, auto view) {
    add(group, std::move(name), std::move(unit), 1,
        [view] { return [host = on_host(view)](std::size_t i, int) { return host(i); }; });
  };
  const auto vector = [&add](std::vector<Field>& group, std::string name, std::string unit, auto view) {
    add(group, std::move(name), std::move(unit), 2,
        [view] { return [host = on_host(view)](std::size_t i, int axis) { return host(i, axis); }; });
  };
  add(list.particles, "displacement", "m", 2, [particles] {
    return [u = on_host(particles.u), origin = on_host(particles.u_origin)](std::size_t i, int axis) {
      return u(i, axis) - origin(i, axis);
    };
  });
  add(list.particles, "rotation", "rad", 1, [particles] {
    return [angle = on_host(particles.angle), origin = on_host(particles.angle_origin)](std::size_t i, int) {
      return angle(i) - origin(i);
    };
  });
  scalar(list.particles, "temperature_change", "K", particles.temperature_change);
  scalar(list.particles, "solid_fraction", "1", particles.solid_fraction);
  add(list.particles, "gone", "1", 1, [particles] {
    return [fraction = on_host(particles.solid_fraction)](std::size_t i, int) { return is_gone(fraction(i)) ? 1 : 0; };
  });
  add(list.particles, "force", "N/m", 2, [particles] {  // of what is gone: handed on (handed_push.hpp)
    return [force = on_host(particles.force), fraction = on_host(particles.solid_fraction)](std::size_t i, int axis) {
      return is_gone(fraction(i)) ? 0 : force(i, axis);
    };
  });
  const auto is_asked_for = [&](const std::string& name) {
    return std::find(asked_for.begin(), asked_for.end(), name) != asked_for.end();
  };
  if (is_asked_for("mass"))
    add(list.particles, "mass", "kg/m", 1, [particles] {
      return [mass = on_host(particles.mass), fraction = on_host(particles.solid_fraction)](std::size_t i, int) {
        return is_gone(fraction(i)) ? 0 : mass(i) * mass_fraction(fraction(i));
      };
    });
  constexpr std::array stress_components{"stress_xx", "stress_yy", "stress_xy"};
  for (int c = 0; c < 3; ++c) {
    const std::string name = stress_components[static_cast<std::size_t>(c)];
    if (!is_asked_for(name)) continue;
    add(list.particles, name, "Pa", 1, [&rock, c] {
      return [stress = on_host(stress_of_triangles(Exec(), rock.particles(), rock.bonds(), rock.outer_moments())), c](
                 std::size_t i, int) { return stress(i, c); };
    });
  }
  scalar(list.bonds, "d_m", "1", bonds.d_m);
  scalar(list.bonds, "d_c", "1", bonds.d_c);
  scalar(list.bonds, "state", "1", bonds.state);
  vector(list.bonds, "stress", "Pa", bonds.stress);
}

RockShape shape_of_rock(const Assembly& assembly, const Bonds& bonds) {
  RockShape shape{assembly, {}};
  const auto pair = on_host(bonds.pair);
  const auto vertex = on_host(bonds.vertex);
  for (int b = 0; b < bonds.count; ++b) shape.bonds.push_back({{pair(b, 0), pair(b, 1)}, {vertex(b, 0), vertex(b, 1)}});
  return shape;
}

}  // namespace vug
