// [boundary.<side>.traction]: supports and loads of the rock, on a side or on parts of it.
#include "io/detail/case_tables.hpp"

#include <cmath>

namespace vug {
namespace {

bool is_still(const TimeTable& table) {
  return table.peak() == 0;
}

TractionLoad read_load(const TomlCursor& table) {
  TractionLoad load;
  table.choose("support", load.support,
               {{"free", Support::free},
                {"roller", Support::roller},
                {"fixed", Support::fixed},
                {"pin", Support::pin},
                {"pin_roller", Support::pin_roller},
                {"servo", Support::servo}});
  table.read("normal_stress", load.normal_stress, unit::pascal);
  table.read("shear_stress", load.shear_stress, unit::pascal);
  table.read("stiffness", load.stiffness, unit::pascal_per_metre, range::not_negative);
  table.read("velocity", load.velocity, unit::metre_per_second);
  const bool free = load.support == Support::free, servo = load.support == Support::servo;
  if (!free && !servo && !is_still(load.normal_stress))
    table.fail("normal_stress",
               "acts on a side that its support holds still; use support = \"free\" or \"servo\", or leave it out");
  if (!free && !is_still(load.shear_stress))
    table.fail("shear_stress", "acts on a side that is held; use support = \"free\" or leave it out");
  if (servo && !load.normal_stress.constant())
    table.fail("normal_stress", "of a servo is one number; its platen cannot follow a table");
  if (!free && load.stiffness != 0)
    table.fail("stiffness",
               "is that of the rock beyond a side that is free to move; use support = \"free\" or leave it out");
  if ((free || servo) && (!is_still(load.velocity[0]) || !is_still(load.velocity[1])))
    table.fail("velocity", "is that of a side that is held; use support = \"roller\", \"fixed\" or a pin");
  return load;
}

}  // namespace

TractionBoundary read_traction(const TomlCursor& table) {
  TractionBoundary boundary{read_load(table), {}};
  for (const TomlCursor& element : table.tables("parts")) {
    TractionPart part;
    element.need("from", part.from, unit::metre, range::not_negative);
    element.need("to", part.to, unit::metre, range::not_negative);
    if (!table.describing() && part.to < part.from) element.fail("to", "lies before from");
    part.load = read_load(element);
    if (!table.describing() && part.from == part.to &&
        (!is_still(part.load.normal_stress) || !is_still(part.load.shear_stress) || part.load.stiffness != 0))
      element.fail("to", "is from: a stress, and rock beyond, needs a stretch to act on");
    if (part.load.support == Support::servo) element.fail("support", "is of a whole side");
    boundary.parts.push_back(part);
  }
  if (boundary.load.support == Support::servo && !boundary.parts.empty() && !table.describing())
    table.fail("support", "is a servo, whose platen is the whole side; it has no parts");
  return boundary;
}

}  // namespace vug
