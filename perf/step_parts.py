"""The parts of a coupled step: their names in step_parts.hpp, and how the pages name them."""

PARTS = {
    "flow": "flow",
    "heat": "heat",
    "advective_form": "advective form of heat and solutes",
    "solutes": "two solutes and their reaction",
    "reaction": "rates of the reaction, its turnover",
    "fluid_force": "fluid's force on particles",
    "mechanics": "mechanics",
    "pores": "looks for new pores",
}
