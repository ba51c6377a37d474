#pragma once
// The forms that a case draws: what lies in them, and their outlines.
#include "io/scene.hpp"

namespace vug {

// Whether a form holds a point. One that lies on the outline of a rectangle or polygon belongs to what lies above or to
// the right of it; of a disc, to the disc. `tie` is a length within which a point is taken to be on the outline.
bool holds(const Rectangle& rectangle, const std::array<double, 2>& point, double tie);
bool holds(const Disc& disc, const std::array<double, 2>& point, double tie);
/// By the even-odd rule.
bool holds(const Polygon& polygon, const std::array<double, 2>& point, double tie);
bool holds(const Form& form, const std::array<double, 2>& point, double tie);

/// What a form reaches to along the axes.
struct Box {
  double x0, y0, x1, y1;
};
Box box_of(const Form& form);

/// Length of the outline of a form.
double outline_length(const Form& form);

/// The corners of a form, in order around it; of a disc those of a regular polygon on its circle, which is a multiple
/// of four and has sides of about `edge`: points by the rational parametrisation of the circle, no sines, the same bits
/// everywhere.
std::vector<std::array<double, 2>> outline_of(const Form& form, double edge);

}  // namespace vug
