// [boundary.left|right|bottom|top], [boundary.injection] and [boundary.shape.<name>]: what holds on the sides of the
// lattice and on the openings inside it.
#include "io/detail/case_tables.hpp"
#include "kernels/side.hpp"

namespace vug {
namespace {

enum class Place { side, opening };

FlowBoundary read_flow_boundary(const TomlCursor& table, Place place) {
  FlowBoundary boundary;
  using Kind = FlowBoundaryKind;
  table.need_choice("type", boundary.kind,
                    {{"wall", Kind::wall},
                     {"pressure", Kind::pressure},
                     {"velocity", Kind::velocity},
                     {"outflow", Kind::outflow},
                     {"periodic", Kind::periodic}});
  if (boundary.kind == Kind::pressure || table.describing()) {
    table.need("pressure", boundary.pressure, unit::pascal, range::not_negative);
    table.read("ramp_time", boundary.ramp_time, unit::second, range::not_negative);
  } else {
    table.refuse("pressure", "is only for type = \"pressure\"");
    table.refuse("ramp_time", "is only for type = \"pressure\"");
  }
  if (place == Place::opening) {
    if (boundary.kind == Kind::velocity || table.describing())
      table.need("speed", boundary.speed, unit::metre_per_second);
    else
      table.refuse("speed", "is only for type = \"velocity\"");
    if (boundary.kind == Kind::wall || table.describing())
      table.read("velocity", boundary.velocity, unit::metre_per_second);
    else
      table.refuse("velocity", "is only for a moving wall; fluid crosses the surface of a shape at the given speed");
    return boundary;
  }
  if (boundary.kind == Kind::velocity && !table.describing()) {
    table.need("velocity", boundary.velocity, unit::metre_per_second);
  } else if (boundary.kind == Kind::wall || table.describing()) {
    table.read("velocity", boundary.velocity, unit::metre_per_second);
  } else {
    table.refuse("velocity", "is only for type = \"velocity\" or a moving wall");
  }
  return boundary;
}

HeatBoundary read_heat_boundary(const TomlCursor& table) {
  HeatBoundary boundary;
  using Kind = HeatBoundaryKind;
  table.need_choice("type", boundary.kind,
                    {{"adiabatic", Kind::adiabatic},
                     {"temperature", Kind::temperature},
                     {"flux", Kind::flux},
                     {"outflow", Kind::outflow},
                     {"periodic", Kind::periodic}});
  if (boundary.kind == Kind::temperature || table.describing()) {
    table.need("temperature", boundary.temperature, unit::kelvin, range::positive);
  } else {
    table.refuse("temperature", "is only for type = \"temperature\"");
  }
  if (boundary.kind == Kind::flux || table.describing()) {
    table.need("flux", boundary.flux, unit::watt_per_square_metre);
  } else {
    table.refuse("flux", "is only for type = \"flux\"");
  }
  return boundary;
}

SoluteBoundary read_solute_boundary(const TomlCursor& table) {
  SoluteBoundary boundary;
  using Kind = SoluteBoundaryKind;
  table.need_choice("type", boundary.kind,
                    {{"no_flux", Kind::no_flux},
                     {"concentration", Kind::concentration},
                     {"outflow", Kind::outflow},
                     {"periodic", Kind::periodic}});
  if (boundary.kind == Kind::concentration || table.describing()) {
    if (!table.describing() && !table.has("concentration")) {
      table.fail("concentration",
                 "is missing; give one number (mol/m3) per species, { L1 = 3000 }, species left out are 0");
    }
    for (const auto& [name, value] :
         table.named_numbers("concentration", "<species>", unit::mole_per_cubic_metre, range::not_negative)) {
      boundary.concentration[name] = value;
    }
  } else {
    table.refuse("concentration", "is only for type = \"concentration\"");
  }
  return boundary;
}

TractionBoundary read_traction_boundary(const TomlCursor& table) {
  TractionBoundary boundary;
  table.choose(
      "support", boundary.support,
      {{"free", Support::free}, {"roller", Support::roller}, {"fixed", Support::fixed}, {"servo", Support::servo}});
  table.read("normal_stress", boundary.normal_stress, unit::pascal);
  table.read("stiffness", boundary.stiffness, unit::pascal_per_metre, range::not_negative);
  const bool still = boundary.support == Support::roller || boundary.support == Support::fixed;
  if (still && boundary.normal_stress != 0) {
    table.fail("normal_stress",
               "acts on a side that its support holds still; use support = \"free\" or \"servo\", or leave it out");
  }
  if (boundary.support != Support::free && boundary.stiffness != 0) {
    table.fail("stiffness",
               "is that of the rock beyond a side that is free to move; use support = \"free\" or leave it out");
  }
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
  if (const TomlCursor traction = table.table("traction"); traction.given())
    section.traction = read_traction_boundary(traction);
  return section;
}

InjectionSection read_injection(const TomlCursor& table) {
  InjectionSection injection;
  Side side = Side::left;
  table.need_choice("side", side,
                    {{"left", Side::left}, {"right", Side::right}, {"bottom", Side::bottom}, {"top", Side::top}});
  injection.side = std::string(name_of(side));
  table.need("centre", injection.centre, unit::metre, range::not_negative);
  table.need("width", injection.width, unit::metre, range::positive);
  read_lattice_conditions(table, injection.conditions);
  return injection;
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
