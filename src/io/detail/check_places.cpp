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

/// A point must be on the lattice, its edge included, with a millionth of a cell of slack for decimal fractions.
void check_point(const TomlDocument& document, const LatticeSection& lattice, const std::string& key,
                 const Point& point) {
  const double slack = 1e-6 * lattice.spacing;
  const bool inside = point[0] >= -slack && point[0] <= lattice.length_x + slack && point[1] >= -slack &&
                      point[1] <= lattice.length_y + slack;
  if (!inside) {
    document.fail(
        key, fmt::format("m lies outside the lattice, [0, {:g}] x [0, {:g}] m", lattice.length_x, lattice.length_y));
  }
}

/// At least a part of a form must be on the lattice.
void require_on_lattice(const TomlDocument& document, const LatticeSection& lattice, const std::string& key,
                        const Form& form) {
  const Box box = box_of(form);
  if (box.x1 > 0 && box.y1 > 0 && box.x0 < lattice.length_x && box.y0 < lattice.length_y) return;
  document.fail(key,
                fmt::format("lies outside the lattice, [0, {:g}] x [0, {:g}] m", lattice.length_x, lattice.length_y));
}

void check_gauge(const TomlDocument& document, const LatticeSection& lattice, const std::string& key,
                 const Gauge& gauge) {
  const bool stress = gauge.kind == GaugeKind::stress, opening = gauge.kind == GaugeKind::opening;
  if (gauge.kind == GaugeKind::displacement || (stress && !gauge.region))
    check_point(document, lattice, key + ".at", gauge.at);
  if (gauge.region) require_on_lattice(document, lattice, key + ".shape", *gauge.region);
  if (gauge.kind == GaugeKind::crack_tip) check_point(document, lattice, key + ".from", gauge.from);
  if (!opening) return;
  check_point(document, lattice, key + ".points", gauge.from);
  check_point(document, lattice, key + ".points", gauge.to);
}

}  // namespace

void check_places(const TomlDocument& document, Scene& scene) {
  const LatticeSection& lattice = scene.lattice;
  for (std::size_t i = 0; i < scene.geometry.shapes.size(); ++i) {
    const Form& form = scene.geometry.shapes[i].form;
    require_on_lattice(document, lattice, fmt::format("geometry.shapes.{}", i), form);
    const Box box = box_of(form);
    const auto between_centres = [&](double low, double high) {
      return std::floor(high / lattice.spacing - 0.5) < std::ceil(low / lattice.spacing - 0.5);
    };
    if (scene.geometry.shapes[i].name.empty() && (between_centres(box.x0, box.x1) || between_centres(box.y0, box.y1)))
      scene.warnings.push_back(
          fmt::format("geometry.shapes.{} holds the centre of no cell and leaves no trace on the lattice", i));
  }
  for (std::size_t i = 0; i < scene.output.probes.size(); ++i) {
    check_point(document, lattice, fmt::format("output.probes.{}.at", i), scene.output.probes[i].at);
  }
  for (std::size_t g = 0; g < scene.output.gauges.size(); ++g)
    check_gauge(document, lattice, fmt::format("output.gauges.{}", g), scene.output.gauges[g]);
  for (std::size_t i = 0; i < scene.minerals.size(); ++i)
    for (std::size_t r = 0; r < scene.minerals[i].regions.size(); ++r)
      if (const auto& form = scene.minerals[i].regions[r].form)
        require_on_lattice(document, lattice, fmt::format("mineral.{}.shapes.{}", i, r), *form);
  if (!scene.rock) return;
  const RockSection& rock = *scene.rock;
  for (const Notch& notch : rock.notches) {
    const std::string key = fmt::format("rock.notches.{}", notch.entry);
    const bool row = document.find(key + ".points") != nullptr;
    check_point(document, lattice, key + (row ? ".points" : ".from"), notch.from);
    check_point(document, lattice, key + (row ? ".points" : ".to"), notch.to);
  }
  for (std::size_t i = 0; i < rock.holes.size(); ++i)
    require_on_lattice(document, lattice, fmt::format("rock.holes.{}", i), rock.holes[i]);
  if (rock.hole) {
    check_point(document, lattice, "rock.hole.from", rock.hole->from);
    check_point(document, lattice, "rock.hole.to", rock.hole->to);
  }
  if (scene.mechanics)
    for (std::size_t i = 0; i < scene.mechanics->regions.size(); ++i)
      if (const auto& form = scene.mechanics->regions[i].form)
        require_on_lattice(document, lattice, fmt::format("mechanics.material.{}", i), *form);
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
