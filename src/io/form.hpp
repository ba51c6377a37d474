#pragma once
// The forms that a case draws: which points they hold, and their outlines.
#include "io/scene.hpp"

namespace vug {

// Whether a form holds a point. A point on the outline of a rectangle or polygon belongs to what is above or to the
// right of it; on that of a disc, to the disc. Within the distance `tie` a point counts as on the outline.
bool holds(const Rectangle& rectangle, const std::array<double, 2>& point, double tie);
bool holds(const Disc& disc, const std::array<double, 2>& point, double tie);
/// By the even-odd rule.
bool holds(const Polygon& polygon, const std::array<double, 2>& point, double tie);
bool holds(const Form& form, const std::array<double, 2>& point, double tie);

/// Extent of a form along the axes.
struct Box {
  double x0, y0, x1, y1;
};
Box box_of(const Form& form);

/// Length of the outline of a form.
double outline_length(const Form& form);

/// The corners of a form, in order around it. For a disc: of a polygon on its circle, whose number of corners is a
/// multiple of four, with sides of about `edge`; they are found by the rational parametrisation of the circle, without
/// sines, so that they have the same bits on every machine.
std::vector<std::array<double, 2>> outline_of(const Form& form, double edge);

}  // namespace vug
