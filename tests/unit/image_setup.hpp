#pragma once
// Pictures for the tests of their readers.
#include "base/require.hpp"
#include "io/detail/image_rows.hpp"
#include "io/image_reader.hpp"
#include "support/temporary_folder.hpp"

#include <cstdlib>

namespace vug::test {

// Pictures from Python's own zlib, Pillow and numpy: encoders that share nothing with the readers.
inline int make(const std::string& script, const std::string& path, const std::string& kind) {
  const auto command =
      std::string(VUG_PYTHON) + " " + VUG_SOURCE_DIR + "/tests/unit/" + script + " " + path + " " + kind;
  return std::system(command.c_str());
}
inline int make_png(const std::string& path, const std::string& kind) {
  return make("make_png.py", path, kind);
}

inline ImageSection image(const std::string& path) {
  ImageSection image;
  image.file = path;
  return image;
}

inline LatticeSection lattice(int nx, int ny, double spacing = 1e-6) {
  LatticeSection lattice;
  lattice.nx = nx;
  lattice.ny = ny;
  lattice.spacing = spacing;
  return lattice;
}

inline std::vector<double> values_of(const ImageSection& image) {
  const auto rows = detail::open_image(image);
  std::vector<double> values;
  std::vector<double> row(static_cast<std::size_t>(rows->header.width));
  for (int y = 0; y < rows->header.height; ++y) {
    rows->read(y, 0, row);
    values.insert(values.end(), row.begin(), row.end());
  }
  return values;
}

inline std::vector<bool> solid_of(const ImageSection& image, int nx, int ny) {
  return read_solid_image(image, lattice(nx, ny)).solid;
}

inline std::string refusal(const ImageSection& image, const LatticeSection& lattice) {
  try {
    read_solid_image(image, lattice);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace vug::test
