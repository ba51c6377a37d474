#pragma once
// The lattice and what is drawn on it: shapes, pictures of rock.
#include "base/side.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace vug {

struct LatticeSection {
  double length_x = 0, length_y = 0;  ///< size = [Lx, Ly], m
  double spacing = 0;                 ///< m
  double time_step = 0;               ///< s
  int nx = 0, ny = 0;                 ///< derived: nodes

  double length_of(Side side) const { return is_upright(side) ? length_y : length_x; }  ///< m
};

struct Rectangle {
  std::array<double, 2> from, to;
};
struct Disc {
  std::array<double, 2> centre;
  double radius;
};
struct Polygon {
  std::vector<std::array<double, 2>> points;
};
using Form = std::variant<Rectangle, Disc, Polygon>;
/// A shape drawn on the lattice. Where shapes overlap, the later one in the file counts. Coordinates in m.
struct Shape {
  Form form;
  bool solid = true;
  std::string name;  ///< of an opening, which has conditions on its surface instead of a material; empty: none
};

/// Type of the values of a picture without a header.
enum class SampleType { uint8, uint16, uint32, uint64, int8, int16, int32, int64, float32, float64 };
enum class CoarsenRule { majority, mean };
enum class ImageTurn { none, left, half, right };
enum class ImageMirror { none, left_right, top_bottom };

/// A picture of rock. Columns and rows count from 0 at its upper left corner.
struct ImageSection {
  std::string file;        ///< path, resolved against the folder of the case
  double threshold = 0.5;  ///< grey value, 0 is black and 1 white; darker is solid
  bool invert = false;
  std::array<double, 2> grey_range{0, 0};  ///< values that are black and white; equal: 0 and the largest of the type
  std::vector<std::int64_t> solid_labels, fluid_labels;  ///< if given: a label map instead of a threshold
  int page = 0;                                          ///< of a stack
  std::optional<double> pixel_size;                      ///< m; absent: that of the file, if it has one
  std::array<int, 2> crop_from{0, 0};                    ///< column, row
  std::array<int, 2> crop_size{0, 0};                    ///< columns, rows; 0: to the far edge
  ImageTurn rotate = ImageTurn::none;      ///< a quarter turn to the left is counter-clockwise; after cropping
  ImageMirror mirror = ImageMirror::none;  ///< after turning
  int coarsen = 1;                         ///< pixels along the edge of a cell
  CoarsenRule coarsen_rule = CoarsenRule::majority;
  std::array<int, 2> raw_size{0, 0};  ///< columns and rows of a file without a header
  SampleType raw_type = SampleType::uint8;
  bool raw_big_endian = false;
  int raw_pages = 1;
  std::map<std::int64_t, std::uint8_t> minerals;  ///< number of the mineral of a label, from 1; 0 for labels not listed

  bool labelled() const { return !solid_labels.empty() || !fluid_labels.empty(); }
};

enum class GeometryKind { open, image, shapes, rock };
struct GeometrySection {
  GeometryKind kind = GeometryKind::open;
  std::string background = "fluid";  ///< of "shapes": what is there before the first shape
  std::vector<Shape> shapes;         ///< if the kind is not "shapes": openings only
  ImageSection image;
};

}  // namespace vug
