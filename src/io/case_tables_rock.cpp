// [rock], [mechanics], [damage]: the assembly of triangles, how it moves and how it breaks.
#include "dem/paper_reading.hpp"
#include "dem/runaway_speed.hpp"
#include "io/detail/case_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vug {
namespace {

/// Internal cohesion that gives the measured uniaxial strength of 91.1 MPa within 3 %, five specimens each of elements
/// of 2 and 3 mm (`vug lab --fit-cohesion 91.1` finds 57.6 and 57.3); Table 1 as printed gives about 137 MPa.
constexpr double calibrated_cohesion = 58e6;

/// Reads the straight pieces of a notch, from its ends or from the points along it.
void read_notch(const TomlCursor& table, int entry, bool in_metres, std::vector<Notch>& notches) {
  Notch notch{};
  std::vector<Point> points;
  table.read("points", points, unit::metre);
  const bool row = table.has("points");
  if (row) {
    for (const char* key : {"from", "to"}) table.refuse(key, "is of a straight notch; this one has points");
    if (points.size() < 2) table.fail("points", "must hold two points or more");
  } else {
    table.need("from", notch.from, unit::metre);
    table.need("to", notch.to, unit::metre);
    points = {notch.from, notch.to};
  }
  table.read_if(!in_metres, "aperture",
                "is in cells, and rock.pathway_width says that widths are in metres; give width", notch.aperture,
                unit::cells, range::between(0, 1000));
  table.read_if(in_metres, "width", "is of rock.pathway_width", notch.width, unit::metre, range::not_negative);
  if (notch.aperture > 0 && notch.aperture < 1) table.fail("aperture", "must be 0, a closed crack, or 1 cell or more");
  notch.entry = entry;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    notch.from = points[i];
    notch.to = points[i + 1];
    if (!table.describing() && notch.from == notch.to)
      table.fail(row ? "points" : "to", "makes a notch without length");
    notches.push_back(notch);
  }
}

InjectionHole read_hole(const TomlCursor& table) {
  InjectionHole hole{};
  table.need("from", hole.from, unit::metre);
  table.need("to", hole.to, unit::metre);
  if (!table.describing() && (hole.from[0] == hole.to[0] || hole.from[1] == hole.to[1])) {
    table.fail("to", "makes a hole without area; from and to are opposite corners");
  }
  return hole;
}

void read_contact(const TomlCursor& table, ContactParameters& contact) {
  table.read("normal_stiffness", contact.normal_stiffness, unit::newton_per_metre, range::positive);
  table.read("tangential_stiffness", contact.tangential_stiffness, unit::newton_per_metre, range::not_negative);
  table.read("friction", contact.friction, unit::none, range::between(0, 10));
  table.read("normal_damping", contact.normal_damping, unit::newton_second_per_metre, range::not_negative);
  table.read("tangential_damping", contact.tangential_damping, unit::newton_second_per_metre, range::not_negative);
  table.read("radius_factor", contact.radius_factor, unit::none,
             {.low = 0, .high = 1, .low_open = true, .high_open = true});
}

}  // namespace

RockSection read_rock(const TomlCursor& table) {
  RockSection rock;
  table.read("mesh", rock.mesh);
  const bool meshed = rock.mesh.has_value();
  const char* const replaced = "is for the generator; rock.mesh replaces it";
  table.need_if(!meshed, "element_size", replaced, rock.element_size, unit::metre, range::positive);
  table.read_if(!meshed, "grading", replaced, rock.grading, unit::none, range::between(1, 100));
  table.read_if(!meshed, "seed", replaced, rock.seed);
  table.read("porosity", rock.porosity, unit::none, {.low = 0, .high = 1, .high_open = true});
  table.read("pathway_width", rock.pathway_width, unit::metre, range::positive);
  const bool in_metres = rock.pathway_width.has_value();
  table.read_if(!in_metres, "pathway_aperture", "is the same in cells as pathway_width in metres; give one of them",
                rock.pathway_aperture, unit::cells, range::between(1, 1000));
  int entry = 0;
  for (const TomlCursor& notch : table.tables("notches")) read_notch(notch, entry++, in_metres, rock.notches);
  if (const TomlCursor hole = table.table("hole"); hole.given()) rock.hole = read_hole(hole);
  for (const TomlCursor& hole : table.tables("holes")) rock.holes.push_back(*read_form(hole, FormOf::geometry));
  if (meshed) table.refuse("holes", "is for the generator; rock.mesh has its own");
  return rock;
}

MechanicsSection read_mechanics(const TomlCursor& table, const MechanicsSection& fallback) {
  MechanicsSection mechanics = fallback;
  MechanicsParameters& parameters = mechanics.parameters;
  enum class Profile { paper_literal, calibrated, weibull_scale };
  Profile profile = Profile::paper_literal;
  table.choose("profile", profile,
               {{"paper-literal", Profile::paper_literal},
                {"calibrated", Profile::calibrated},
                {"weibull-scale", Profile::weibull_scale}});
  if (profile == Profile::calibrated) {
    mechanics.profile = "calibrated";
    parameters.bond.cohesion = calibrated_cohesion;
  }
  if (profile == Profile::weibull_scale) {
    mechanics.profile = "weibull-scale";
    read_weibull_shape(table.table("bond"), parameters.bond);
    parameters = weibull_scale_reading(parameters);
  }
  table.read("density", parameters.density, unit::kilogram_per_cubic_metre, range::positive);
  table.read("thermal_expansion", parameters.thermal_expansion, unit::per_kelvin, range::between(0, 1e-2));
  table.read("local_damping", parameters.local_damping, unit::none, {.low = 0, .high = 1, .high_open = true});
  table.read("mass_scaling", parameters.mass_scaling, unit::none, range::between(1, 1e12));
  table.read("rest_tolerance", parameters.rest_tolerance, unit::none, range::between(0, 1));
  table.read("substeps", mechanics.substeps, range::between(1, 1e6));
  table.read("critical_fraction", mechanics.critical_fraction, unit::none, range::positive_to(1));
  table.read("force_unstable", mechanics.force_unstable);
  table.choose("preload", mechanics.static_preload, {{"static", true}, {"dynamic", false}});
  table.choose("displacement_from", parameters.output_from_unloaded, {{"preload", false}, {"unloaded", true}});
  table.read("preload_time", mechanics.preload_time, unit::second, range::not_negative);
  table.read("preload_damping", mechanics.preload_damping, unit::none,
             {.low = 0, .high = 1, .low_open = true, .high_open = true});
  table.choose("fragments", mechanics.lets_fragments_go, {{"end_run", false}, {"let_go", true}});
  table.read("gravity", mechanics.gravity, unit::metre_per_square_second);
  for (const TomlCursor& element : table.tables("initial_velocity")) {
    InitialVelocity& start =
        mechanics.initial_velocities.emplace_back(InitialVelocity{read_region(element, FormOf::rock), {0, 0}});
    element.need("velocity", start.velocity, unit::metre_per_second);
    if (const double speed = std::hypot(start.velocity[0], start.velocity[1]); speed > runaway_speed)
      element.fail("velocity", fmt::format("moves the rock at {:g} m/s; at most {:g} m/s, about the speed of sound in "
                                           "rock, is possible",
                                           speed, runaway_speed));
  }
  read_materials(table, mechanics);
  read_contact(table.table("contact"), parameters.contact);
  return mechanics;
}

namespace {

/// Reads the coefficients of f1 or f2. Throws InputError where nothing would be left already below d_c = 1.
void read_fit(const TomlCursor& table, const char* key, QuadraticFit& fit) {
  std::array<double, 3> given{fit.square, fit.linear, fit.constant};
  table.read(key, given, unit::none);
  fit = {given[0], given[1], given[2]};
  const double turning = fit.square > 0 ? std::clamp(-fit.linear / (2 * fit.square), 0.0, 1.0) : 0;
  for (const double d : {0.0, turning, 1.0}) {  // one of these is where the fit is lowest
    const double value = (fit.square * d + fit.linear) * d + fit.constant;
    if (value < 0 || (d < 1 && value == 0))
      table.fail(key, fmt::format("gives {:.3g} at d_c = {:.3g}, and must be positive from 0 to 1", value, d));
  }
}

}  // namespace

DamageSection read_damage(const TomlCursor& table, bool in_metres, ChemicalDamageLaw& chemical) {
  DamageSection damage;
  table.read("pathway_factor", damage.pathway_factor, unit::none, range::between(0, 10));
  table.read_if(!in_metres, "minimum_aperture",
                "is in cells, and rock.pathway_width says that widths are in metres; give minimum_width",
                damage.minimum_aperture, unit::cells, range::between(1, 1000));
  table.read_if(in_metres, "minimum_width", "is of rock.pathway_width", damage.minimum_width, unit::metre,
                range::not_negative);
  table.choose("aperture", damage.aperture, {{"damage", ApertureLaw::damage}, {"opening", ApertureLaw::opening}});
  table.read_if(damage.aperture == ApertureLaw::opening, "residual_aperture", "is of damage.aperture = \"opening\"",
                damage.residual_aperture, unit::metre, range::not_negative);
  table.choose("pathway_widening", damage.widening,
               {{"largest", PathwayWidening::largest}, {"added", PathwayWidening::added}});
  read_fit(table, "strength_fit", chemical.strength);
  read_fit(table, "energy_fit", chemical.energy);
  if (chemical.energy.linear > 0)
    table.fail("energy_fit", "rises from d_c = 0 (its second number is positive): dissolved rock would be tougher");
  table.read("normalised", chemical.normalised);
  table.read("failure_at", chemical.failure_at, unit::none, range::positive_to(1));
  return damage;
}

}  // namespace vug
