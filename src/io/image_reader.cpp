#include "io/image_reader.hpp"

#include "io/detail/image_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace vug {

namespace {

using detail::refuse_image;

struct Size {
  int columns, rows;
};

/// Size of the part of the page that the case uses. Throws InputError where it is not on the page or is not a whole
/// number of cells.
Size cropped_size(const ImageSection& image, const detail::ImageHeader& header) {
  constexpr std::int64_t most = 1 << 28;
  if (header.width < 1 || header.height < 1 || header.width > most || header.height > most)
    refuse_image(image.file,
                 fmt::format("the image has {} x {} pixels, which cannot be read", header.width, header.height));
  const auto [column, row] = image.crop_from;
  const std::int64_t columns = image.crop_size[0] > 0 ? image.crop_size[0] : header.width - column;
  const std::int64_t rows = image.crop_size[1] > 0 ? image.crop_size[1] : header.height - row;
  if (columns < 1 || rows < 1 || column + columns > header.width || row + rows > header.height)
    refuse_image(image.file, fmt::format("the crop{} from column {}, row {} leaves the image, which has {} x {} pixels",
                                         image.crop_size[0] > 0 ? fmt::format(" of {} x {} pixels", columns, rows) : "",
                                         column, row, header.width, header.height));
  if (columns < image.coarsen || rows < image.coarsen)
    refuse_image(image.file, fmt::format("{} x {} pixels are less than a cell of {} x {} (geometry.coarsen)", columns,
                                         rows, image.coarsen, image.coarsen));
  if (columns % image.coarsen != 0 || rows % image.coarsen != 0)
    refuse_image(image.file, fmt::format("{} x {} pixels make no whole number of cells of {} pixels; give "
                                         "geometry.crop_size = [{}, {}]",
                                         columns, rows, image.coarsen, columns - columns % image.coarsen,
                                         rows - rows % image.coarsen));
  return {static_cast<int>(columns), static_cast<int>(rows)};
}

bool turned_sideways(const ImageSection& image) {
  return image.rotate == ImageTurn::left || image.rotate == ImageTurn::right;
}

void require_lattice(const ImageSection& image, Size pixels, std::optional<double> pixel_size,
                     const LatticeSection& lattice) {
  const int across = (turned_sideways(image) ? pixels.rows : pixels.columns) / image.coarsen;
  const int up = (turned_sideways(image) ? pixels.columns : pixels.rows) / image.coarsen;
  if (across == lattice.nx && up == lattice.ny) return;
  const bool changed = image.coarsen > 1 || turned_sideways(image);
  const std::string cells = changed ? fmt::format(", coarsened and turned {} x {} cells", across, up) : "";
  const std::string of = pixel_size ? fmt::format(" of {:.6g} m", *pixel_size) : "";
  const double spacing = pixel_size ? *pixel_size * image.coarsen : lattice.spacing;
  const std::string printed = fmt::format("{:.10g}", spacing);  // the size must hold whole cells of what is printed
  const double cell = std::stod(printed);
  const std::string also = pixel_size ? "lattice.spacing = " + printed + " and " : "";
  refuse_image(
      image.file,
      fmt::format("the image has {} x {} pixels{}{}, the lattice {} x {} nodes; give {}lattice.size "
                  "= [{:.12g}, {:.12g}] (m), or use a part of the image (geometry.crop_size)",
                  pixels.columns, pixels.rows, of, cells, lattice.nx, lattice.ny, also, across * cell, up * cell));
}

void require_pixel_size(const ImageSection& image, std::optional<double> pixel_size, const LatticeSection& lattice) {
  constexpr double tolerance = 1e-3;
  if (!pixel_size || std::abs(*pixel_size * image.coarsen - lattice.spacing) <= tolerance * lattice.spacing) return;
  const std::string cell =
      image.coarsen > 1 ? fmt::format(", {} of them {:.6g} m", image.coarsen, *pixel_size * image.coarsen) : "";
  refuse_image(image.file,
               fmt::format("{} pixels of {:.6g} m{}, lattice.spacing is {:.6g} m; they must agree{}",
                           image.pixel_size ? "geometry.pixel_size says" : "the file says", *pixel_size, cell,
                           lattice.spacing, image.pixel_size ? "" : " (geometry.pixel_size goes before the file)"));
}

/// Distinguishes rock from pore, and collects the summary.
class Pixels {
 public:
  Pixels(const ImageSection& image, const detail::ImageHeader& header) : image_(image) {
    for (const std::int64_t label : image.solid_labels) labels_[static_cast<double>(label)].solid = true;
    for (const std::int64_t label : image.fluid_labels) labels_[static_cast<double>(label)].solid = false;
    for (const auto& [label, mineral] : image.minerals) labels_[static_cast<double>(label)].mineral = mineral;
    if (image.labelled()) {
      if (!header.stored) refuse_image(image.file, "holds colours; labels are grey values or indices of a palette");
      return;
    }
    if (image.grey_range[0] != image.grey_range[1]) {
      black_ = image.grey_range[0];
      white_ = image.grey_range[1];
    } else if (header.white > 0) {
      white_ = header.white;
      narrow_ = white_ > 255;
    } else {
      refuse_image(image.file, fmt::format("has values of the type {}, which say nothing of black and white; give "
                                           "geometry.grey_range = [black, white]",
                                           header.type));
    }
  }

  /// The grey value, 0 for black and 1 for white; 0 for a label.
  double grey(double value) const { return image_.labelled() ? 0 : (value - black_) / (white_ - black_); }
  bool dark(double grey) const { return (grey < image_.threshold) != image_.invert; }

  /// Whether the pixel is rock. Throws InputError for one that is neither rock nor pore.
  bool solid(double value, int column, int row) {
    if (!std::isfinite(value))
      refuse_image(image_.file,
                   fmt::format("the pixel in column {}, row {} is {}, no finite number", column, row, value));
    least_ = std::min(least_, value);
    largest_ = std::max(largest_, value);
    if (!image_.labelled()) return dark(grey(value));
    if (last_ == nullptr || value != last_value_) {
      const auto found = labels_.find(value);
      if (found == labels_.end())
        refuse_image(image_.file, fmt::format("the pixel in column {}, row {} has the label {}, which is neither in "
                                              "geometry.solid_labels nor in geometry.fluid_labels",
                                              column, row, value));
      last_ = &found->second;
      last_value_ = value;
    }
    ++last_->count;
    return last_->solid;
  }

  /// Number of the mineral of the pixel for which `solid` was called last.
  std::uint8_t mineral() const { return last_->mineral; }

  void summarise(double pixels, ImageSummary& summary) const {
    if (narrow_ && largest_ <= 255)
      refuse_image(image_.file, fmt::format("no value is above {:g} of {:g}: values of 8 bits in a wider type; give "
                                            "geometry.grey_range = [0, 255]",
                                            largest_, white_));
    summary.least = least_;
    summary.largest = largest_;
    const bool below = image_.invert != (white_ > black_);
    if (!image_.labelled())
      summary.rock =
          fmt::format("rock {} {:g}", below ? "below" : "from", black_ + image_.threshold * (white_ - black_));
    for (const auto& [label, seen] : labels_)
      summary.labels.emplace_back(static_cast<std::int64_t>(label), static_cast<double>(seen.count) / pixels);
  }

 private:
  struct Label {
    bool solid = false;
    std::uint8_t mineral = 0;
    std::int64_t count = 0;
  };
  const ImageSection& image_;
  double black_ = 0, white_ = 1;
  bool narrow_ = false;  ///< a type of more than 8 bits, whose values may be 8-bit ones all the same
  std::map<double, Label> labels_;
  Label* last_ = nullptr;
  double last_value_ = 0;
  double least_ = std::numeric_limits<double>::infinity(), largest_ = -std::numeric_limits<double>::infinity();
};

/// Counts the pixels of each mineral in a row of cells; does nothing where no label has a mineral.
class MineralCounts {
 public:
  MineralCounts(const ImageSection& image, int across) {
    for (const auto& [label, mineral] : image.minerals) kinds_ = std::max<std::size_t>(kinds_, mineral + 1u);
    count_.assign(kinds_ * static_cast<std::size_t>(across), 0);
  }
  bool any() const { return kinds_ > 0; }
  void add(int cell, std::uint8_t mineral) { ++count_[kinds_ * static_cast<std::size_t>(cell) + mineral]; }
  /// Gives every cell the mineral of most of its pixels, and sets the counts to zero.
  void take(std::vector<std::uint8_t>& cells) {
    for (auto first = count_.begin(); first != count_.end(); first += static_cast<std::ptrdiff_t>(kinds_))
      cells.push_back(
          static_cast<std::uint8_t>(std::max_element(first, first + static_cast<std::ptrdiff_t>(kinds_)) - first));
    std::fill(count_.begin(), count_.end(), 0);
  }

 private:
  std::size_t kinds_ = 0;
  std::vector<int> count_;  ///< (cell, mineral)
};

struct Cells {
  std::vector<bool> solid;
  std::vector<std::uint8_t> mineral;
};

/// Reads the cells of a picture, row by row from its top.
Cells cells_of(const ImageSection& image, detail::ImageRows& rows, Size size, Pixels& pixels) {
  const int n = image.coarsen, across = size.columns / n;
  Cells cells;
  MineralCounts minerals(image, across);
  cells.solid.reserve(static_cast<std::size_t>(across) * (size.rows / n));
  std::vector<double> values(static_cast<std::size_t>(size.columns)), grey(across);
  std::vector<int> solid(across);
  const double area = static_cast<double>(n) * n;
  for (int y = 0; y < size.rows; ++y) {
    rows.read(image.crop_from[1] + y, image.crop_from[0], values);
    for (int x = 0; x < size.columns; ++x) {
      const bool rock = pixels.solid(values[x], image.crop_from[0] + x, image.crop_from[1] + y);
      solid[x / n] += rock;
      if (rock && minerals.any()) minerals.add(x / n, pixels.mineral());
      grey[x / n] += pixels.grey(values[x]);
    }
    if ((y + 1) % n != 0) continue;
    for (int x = 0; x < across; ++x)
      cells.solid.push_back(image.coarsen_rule == CoarsenRule::mean ? pixels.dark(grey[x] / area)
                                                                    : 2 * solid[x] >= area);
    if (minerals.any()) minerals.take(cells.mineral);
    std::fill(solid.begin(), solid.end(), 0);
    std::fill(grey.begin(), grey.end(), 0);
  }
  return cells;
}

/// Converts the cells to the lattice: turned, mirrored, row by row from the bottom.
template <class Value>
std::vector<Value> placed(const std::vector<Value>& cells, const ImageSection& image, int across,
                          const LatticeSection& lattice) {
  const int nx = lattice.nx, ny = lattice.ny;
  std::vector<Value> placed(cells.size());
  if (cells.empty()) return placed;
  for (int y = 0; y < ny; ++y) {
    for (int x = 0; x < nx; ++x) {
      int column = image.mirror == ImageMirror::left_right ? nx - 1 - x : x;
      int row = image.mirror == ImageMirror::top_bottom ? y : ny - 1 - y;  // the picture begins at the top
      if (image.rotate == ImageTurn::half) {
        column = nx - 1 - column;
        row = ny - 1 - row;
      } else if (image.rotate == ImageTurn::left) {  // its right edge becomes the top
        std::swap(column, row);
        column = ny - 1 - column;
      } else if (image.rotate == ImageTurn::right) {  // its left edge becomes the top
        std::swap(column, row);
        row = nx - 1 - row;
      }
      placed[static_cast<std::size_t>(nx) * y + x] = cells[static_cast<std::size_t>(across) * row + column];
    }
  }
  return placed;
}

}  // namespace

SolidImage read_solid_image(const ImageSection& image, const LatticeSection& lattice) {
  const auto rows = detail::open_image(image);
  const detail::ImageHeader& header = rows->header;
  const std::optional<double> pixel_size =
      image.pixel_size ? image.pixel_size : detail::square_pixel(image.file, header);
  const Size size = cropped_size(image, header);
  require_lattice(image, size, pixel_size, lattice);
  require_pixel_size(image, pixel_size, lattice);
  SolidImage read{{}, {}, {header.width, header.height, header.type, pixel_size, 0, 0, {}, {}}};
  Pixels pixels(image, header);
  const Cells cells = cells_of(image, *rows, size, pixels);
  read.solid = placed(cells.solid, image, size.columns / image.coarsen, lattice);
  read.mineral = placed(cells.mineral, image, size.columns / image.coarsen, lattice);
  pixels.summarise(static_cast<double>(size.columns) * size.rows, read.summary);
  return read;
}

}  // namespace vug
