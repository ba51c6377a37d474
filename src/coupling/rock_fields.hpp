#pragma once
// The output of bonded rock: fields of triangles and bonds, and the shape on which they are drawn.
#include "dem/mechanics.hpp"
#include "io/field_list.hpp"
#include "io/snapshot_writer.hpp"

#include <string>
#include <vector>

namespace vug {

/// Adds displacement, rotation, temperature, damage, ... of `rock`, and the stress of its triangles where `asked_for`
/// names a component of it.
void add_rock_fields(const Mechanics& rock, FieldList& list, const std::vector<std::string>& asked_for = {});

/// Triangles and bonds for particles.h5.
RockShape shape_of_rock(const Assembly& assembly, const Bonds& bonds);

}  // namespace vug
