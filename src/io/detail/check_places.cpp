// Checks that everything a case draws lies on its lattice, and that its triangles are not too many.
#include "io/detail/case_checks.hpp"
#include "io/detail/toml_cursor.hpp"
#include "io/form.hpp"
#include "io/triangle_count.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug {
namespace {

/// Where what a case draws may lie: [0, length_x] x [0, length_y].
struct Room {
  const char* name;
  double length_x, length_y;
  double slack;  ///< m, for decimal fractions of points

  std::string outside() const {
    return fmt::format("lies outside the {}, [0, {:g}] x [0, {:g}] m", name, length_x, length_y);
  }
};

/// A point must be in the room, its edge included.
void check_point(const TomlDocument& document, const Room& room, const std::string& key, const Point& point) {
  const bool inside = point[0] >= -room.slack && point[0] <= room.length_x + room.slack && point[1] >= -room.slack &&
                      point[1] <= room.length_y + room.slack;
  if (!inside) document.fail(key, "m " + room.outside());
}

/// At least a part of a form must be in the room.
void require_part_inside(const TomlDocument& document, const Room& room, const std::string& key, const Form& form) {
  const Box box = box_of(form);
  if (box.x1 > 0 && box.y1 > 0 && box.x0 < room.length_x && box.y0 < room.length_y) return;
  document.fail(key, room.outside());
}

void check_gauge(const TomlDocument& document, const Room& room, const std::string& key, const Gauge& gauge) {
  const bool stress = gauge.kind == GaugeKind::stress, opening = gauge.kind == GaugeKind::opening;
  if (gauge.kind == GaugeKind::displacement || (stress && !gauge.region))
    check_point(document, room, key + ".at", gauge.at);
  if (gauge.region) require_part_inside(document, room, key + ".shape", *gauge.region);
  if (gauge.kind == GaugeKind::crack_tip) check_point(document, room, key + ".from", gauge.from);
  if (!opening) return;
  check_point(document, room, key + ".points", gauge.from);
  check_point(document, room, key + ".points", gauge.to);
}

/// What is drawn of the rock.
void check_rock(const TomlDocument& document, const Room& room, const Scene& scene) {
  const RockSection& rock = *scene.rock;
  for (const Notch& notch : rock.notches) {
    const std::string key = fmt::format("rock.notches.{}", notch.entry);
    const bool row = document.find(key + ".points") != nullptr;
    check_point(document, room, key + (row ? ".points" : ".from"), notch.from);
    check_point(document, room, key + (row ? ".points" : ".to"), notch.to);
  }
  for (std::size_t i = 0; i < rock.holes.size(); ++i)
    require_part_inside(document, room, fmt::format("rock.holes.{}", i), rock.holes[i]);
  if (rock.hole) {
    check_point(document, room, "rock.hole.from", rock.hole->from);
    check_point(document, room, "rock.hole.to", rock.hole->to);
  }
  if (!scene.mechanics) return;
  for (std::size_t i = 0; i < scene.mechanics->regions.size(); ++i)
    if (const auto& form = scene.mechanics->regions[i].form)
      require_part_inside(document, room, fmt::format("mechanics.material.{}", i), *form);
}

}  // namespace

void check_places_of_specimen(const TomlDocument& document, const Scene& scene) {
  const LaboratorySection& laboratory = *scene.laboratory;
  if (scene.rock->mesh) return;  // which has its own size
  if (laboratory.test == LaboratoryTest::brazilian)
    return check_rock(document, {"disc", laboratory.diameter, laboratory.diameter, 0}, scene);
  const auto [width, height] = laboratory.size;
  check_rock(document, {"specimen", width, height, 1e-6 * scene.rock->element_size}, scene);
}

void check_places(const TomlDocument& document, Scene& scene) {
  const LatticeSection& lattice = scene.lattice;
  const Room room{"lattice", lattice.length_x, lattice.length_y, 1e-6 * lattice.spacing};
  for (std::size_t i = 0; i < scene.geometry.shapes.size(); ++i) {
    const Form& form = scene.geometry.shapes[i].form;
    require_part_inside(document, room, fmt::format("geometry.shapes.{}", i), form);
    const Box box = box_of(form);
    const auto between_centres = [&](double low, double high) {
      return std::floor(high / lattice.spacing - 0.5) < std::ceil(low / lattice.spacing - 0.5);
    };
    if (scene.geometry.shapes[i].name.empty() && (between_centres(box.x0, box.x1) || between_centres(box.y0, box.y1)))
      scene.warnings.push_back(
          fmt::format("geometry.shapes.{} holds the centre of no cell and leaves no trace on the lattice", i));
  }
  for (std::size_t i = 0; i < scene.output.probes.size(); ++i) {
    check_point(document, room, fmt::format("output.probes.{}.at", i), scene.output.probes[i].at);
  }
  for (std::size_t g = 0; g < scene.output.gauges.size(); ++g)
    check_gauge(document, room, fmt::format("output.gauges.{}", g), scene.output.gauges[g]);
  for (std::size_t i = 0; i < scene.minerals.size(); ++i)
    for (std::size_t r = 0; r < scene.minerals[i].regions.size(); ++r)
      if (const auto& form = scene.minerals[i].regions[r].form)
        require_part_inside(document, room, fmt::format("mineral.{}.shapes.{}", i, r), *form);
  if (!scene.rock) return;
  check_rock(document, room, scene);
  const RockSection& rock = *scene.rock;
  const double largest = std::min(lattice.length_x, lattice.length_y);
  if (!rock.mesh && rock.element_size > largest) {
    document.fail("rock.element_size",
                  fmt::format("is larger than the rock itself; use less than {:g} m", largest / 2));
  }
  check_triangles(document, rock, lattice.length_x * lattice.length_y);
}

void check_triangles(const TomlDocument& document, const RockSection& rock, double area) {
  if (rock.mesh) return;
  const double triangles = triangles_in(area, rock.element_size);
  if (triangles > most_triangles)
    document.fail("rock.element_size",
                  fmt::format("m makes {:.3g} triangles, at most 2^22 are accepted; use {:.3g} m or more", triangles,
                              rock.element_size * std::sqrt(triangles / most_triangles)));
}

}  // namespace vug
