#pragma once
// Lines that the generated mesh of a disc must contain: its circle, cut off by flats.
#include "io/detail/rock_outline.hpp"

namespace vug::detail {

/// A disc between flats of `flat_width` (over the diameter) at the top and bottom of its bounding rectangle, with edges
/// of length about `edge`.
struct DiscOutline {
  Point length;  ///< of the rectangle around it
  Outline outline;
};
DiscOutline disc_outline(double diameter, double flat_width, double edge);

}  // namespace vug::detail
