#pragma once
// The conditions of a case at its sides, their stretches and its openings, one after the other.
#include "io/scene.hpp"

namespace vug {

/// Calls visit(conditions) with the BoundarySection of every side, then of every injection, then of every opening.
template <class Visit>
void for_each_boundary(const Scene& scene, const Visit& visit) {
  for (const Side side : all_sides) visit(scene.side(side));
  for (const InjectionSection& injection : scene.injections) visit(injection.conditions);
  for (const OpeningSection& opening : scene.openings) visit(opening.conditions);
}

}  // namespace vug
