#pragma once
// Pictures whose rows are uncompressed in the file: raw files, and other formats where they are not compressed.
#include "io/detail/image_rows.hpp"

#include <vector>

namespace vug::detail {

/// Where the rows of a page begin, with `rows` rows in each strip but the last.
struct PlainStrips {
  std::vector<std::uint64_t> begin;
  std::int64_t rows = 1;
};

/// Reads only the requested part of a row. `white_is_zero` inverts values of unsigned types.
class PlainRows : public ImageRows {
 public:
  PlainRows(const std::string& path, ImageHeader what, PlainStrips strips, SampleType type, bool swapped,
            bool white_is_zero = false);
  void read(int y, int first, std::span<double> values) override;

 private:
  BinaryFile file_;
  PlainStrips strips_;
  SampleType type_;
  bool swapped_, white_is_zero_;
  std::vector<unsigned char> bytes_;
};

/// Whether numbers of that byte order must be swapped on this machine.
bool is_swapped(bool big_endian);

/// Header of a page whose values are used as they are stored.
ImageHeader plain_header(std::int64_t width, std::int64_t height, SampleType type);

}  // namespace vug::detail
