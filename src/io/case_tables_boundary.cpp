// [boundary.left|right|bottom|top], [boundary.injection] and [boundary.shape.<name>]: the conditions on the sides of
// the lattice and on the openings inside it.
#include "io/detail/case_tables.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace vug {

void read_side(const TomlCursor& table, Side& side) {
  table.need_choice("side", side,
                    {{"left", Side::left}, {"right", Side::right}, {"bottom", Side::bottom}, {"top", Side::top}});
}

namespace {

enum class Place { side, opening };

/// Reads the flow rates, and checks that at most one of `velocity` (on an opening `speed`) and the two rates is given.
void read_velocity(const TomlCursor& table, FlowBoundary& boundary, Place place) {
  const char* const own = place == Place::side ? "velocity" : "speed";
  table.read("flow_rate", boundary.flow_rate, unit::square_metre_per_second);
  table.read("mass_flow_rate", boundary.mass_flow_rate, unit::kilogram_per_metre_second);
  if (table.describing()) return;
  for (const auto& [key, given] :
       {std::pair{"flow_rate", table.has("flow_rate")}, std::pair{"mass_flow_rate", table.has("mass_flow_rate")}})
    if (given && table.has(own))
      table.fail(key, fmt::format("stands beside {}; give one of the two", table.inside(own)));
  if (boundary.flow_rate && boundary.mass_flow_rate)
    table.fail("mass_flow_rate", fmt::format("stands beside {}; give one of the two", table.inside("flow_rate")));
}

void read_profile(const TomlCursor& table, FlowBoundary& boundary) {
  table.choose(
      "profile", boundary.profile,
      {{"uniform", VelocityShape::uniform}, {"parabolic", VelocityShape::parabolic}, {"table", VelocityShape::table}});
  table.read_curve("profile_table", boundary.profile_table, unit::metre, unit::none, range::any);
  if (table.describing()) return;
  if (boundary.profile == VelocityShape::table && boundary.profile_table.empty())
    table.fail("profile_table", "is missing; profile = \"table\" needs [[position in m, share of the velocity], ...]");
  if (boundary.profile != VelocityShape::table) table.refuse("profile_table", "is only for profile = \"table\"");
  const auto still = [](const Point& point) { return point[1] == 0; };
  if (!boundary.profile_table.empty() &&
      std::all_of(boundary.profile_table.begin(), boundary.profile_table.end(), still))
    table.fail("profile_table", "has no share but 0: nothing would flow");
}

FlowBoundary read_flow_boundary(const TomlCursor& table, Place place) {
  FlowBoundary boundary;
  using Kind = FlowBoundaryKind;
  table.need_choice("type", boundary.kind,
                    {{"wall", Kind::wall},
                     {"pressure", Kind::pressure},
                     {"velocity", Kind::velocity},
                     {"outflow", Kind::outflow},
                     {"periodic", Kind::periodic}});
  const bool all = table.describing(), driven = boundary.kind == Kind::velocity;
  table.need_if(boundary.kind == Kind::pressure, "pressure", "is only for type = \"pressure\"", boundary.pressure,
                unit::pascal, range::not_negative);
  table.read_if(boundary.kind == Kind::pressure || driven, "ramp_time",
                "is only for type = \"pressure\" or \"velocity\"", boundary.ramp_time, unit::second,
                range::not_negative);
  if (driven || all) {
    read_velocity(table, boundary, place);
  } else {
    for (const char* key : {"flow_rate", "mass_flow_rate"}) table.refuse(key, "is only for type = \"velocity\"");
  }
  const bool rate = boundary.flow_rate || boundary.mass_flow_rate;
  if (place == Place::opening) {
    table.need_if(driven && !rate, "speed", "is only for type = \"velocity\"", boundary.speed, unit::metre_per_second);
    table.read_if(boundary.kind == Kind::wall, "velocity",
                  "is only for a moving wall; fluid crosses the surface of a shape at the given speed",
                  boundary.velocity, unit::metre_per_second);
    return boundary;
  }
  if (driven || all) {
    read_profile(table, boundary);
  } else {
    for (const char* key : {"profile", "profile_table"}) table.refuse(key, "is only for type = \"velocity\"");
  }
  if (driven && !rate && !all) {
    table.need("velocity", boundary.velocity, unit::metre_per_second);
  } else if (boundary.kind == Kind::wall || all) {
    table.read("velocity", boundary.velocity, unit::metre_per_second);
  } else if (!rate) {
    table.refuse("velocity", "is only for type = \"velocity\" or a moving wall");
  }
  return boundary;
}

HeatBoundary read_heat_boundary(const TomlCursor& table) {
  HeatBoundary boundary;
  using Kind = HeatCondition;
  table.need_choice("type", boundary.kind,
                    {{"adiabatic", Kind::adiabatic},
                     {"temperature", Kind::temperature},
                     {"flux", Kind::flux},
                     {"convection", Kind::convection},
                     {"outflow", Kind::outflow},
                     {"periodic", Kind::periodic}});
  const bool convects = boundary.kind == Kind::convection;
  table.need_if(boundary.kind == Kind::temperature || convects, "temperature",
                "is only for type = \"temperature\" or \"convection\"", boundary.temperature, unit::kelvin,
                range::positive);
  table.need_if(convects, "coefficient", "is only for type = \"convection\"", boundary.coefficient,
                unit::watt_per_square_metre_kelvin, range::positive);
  table.need_if(boundary.kind == Kind::flux, "flux", "is only for type = \"flux\"", boundary.flux,
                unit::watt_per_square_metre);
  return boundary;
}

SoluteBoundary read_solute_boundary(const TomlCursor& table) {
  SoluteBoundary boundary;
  using Kind = SoluteBoundaryKind;
  table.need_choice("type", boundary.kind,
                    {{"no_flux", Kind::no_flux},
                     {"concentration", Kind::concentration},
                     {"flux", Kind::flux},
                     {"outflow", Kind::outflow},
                     {"periodic", Kind::periodic}});
  const auto read = [&](const char* key, Kind kind, Unit unit, Range range, std::map<std::string, TimeTable>& values) {
    if (boundary.kind != kind && !table.describing())
      return table.refuse(key, fmt::format("is only for type = \"{}\"", key));
    if (!table.describing() && !table.has(key))
      table.fail(key,
                 fmt::format("is missing; give one number ({}) per species, {{ L1 = 3000 }}, species left out are 0",
                             unit.symbol));
    for (const auto& [name, value] : table.named_numbers(key, "<species>", unit, range)) values[name] = value;
  };
  read("concentration", Kind::concentration, unit::mole_per_cubic_metre, range::not_negative, boundary.concentration);
  read("flux", Kind::flux, unit::mole_per_square_metre_second, range::any, boundary.flux);
  return boundary;
}

void read_lattice_conditions(const TomlCursor& table, BoundarySection& section, Place place = Place::side) {
  if (const TomlCursor flow = table.table("flow"); flow.given()) section.flow = read_flow_boundary(flow, place);
  if (const TomlCursor heat = table.table("heat"); heat.given()) section.heat = read_heat_boundary(heat);
  if (const TomlCursor solute = table.table("solute"); solute.given()) section.solute = read_solute_boundary(solute);
}

}  // namespace

BoundarySection read_boundary(const TomlCursor& table) {
  BoundarySection section;
  read_lattice_conditions(table, section);
  if (const TomlCursor traction = table.table("traction"); traction.given()) section.traction = read_traction(traction);
  return section;
}

namespace {

InjectionSection read_injection(const TomlCursor& table) {
  InjectionSection injection;
  injection.key = table.path();
  std::optional<std::string> name;
  table.read("name", name);
  if (name && !is_plain_name(*name)) table.fail("name", plain_name_rule);
  if (name) injection.name += "_" + *name;
  read_side(table, injection.side);
  table.need("centre", injection.centre, unit::metre, range::not_negative);
  table.need("width", injection.width, unit::metre, range::positive);
  read_lattice_conditions(table, injection.conditions);
  return injection;
}

}  // namespace

std::vector<InjectionSection> read_injections(const TomlCursor& boundary) {
  std::vector<InjectionSection> injections;
  for (const TomlCursor& table : boundary.one_or_more("injection")) {
    InjectionSection injection = read_injection(table);
    for (const InjectionSection& other : injections)
      if (other.name == injection.name)
        table.fail("name", injection.name == "injection" ? "is missing; several injections need one each"
                                                         : "is the name of an earlier injection");
    injections.push_back(std::move(injection));
  }
  return injections;
}

std::vector<OpeningSection> read_openings(const TomlCursor& boundary, const GeometrySection& geometry) {
  std::vector<OpeningSection> openings;
  const TomlCursor shapes = boundary.table("shape");
  for (std::size_t i = 0; i < geometry.shapes.size(); ++i) {
    const std::string& name = geometry.shapes[i].name;
    if (name.empty() && !boundary.describing()) continue;
    const TomlCursor table = shapes.table(name, "<name>");
    OpeningSection& opening = openings.emplace_back(OpeningSection{static_cast<int>(i), {}});
    read_lattice_conditions(table, opening.conditions, Place::opening);
  }
  return openings;
}

}  // namespace vug
