#pragma once
// Pictures whose rows lie in the file as they are: raw files, and what other formats hold uncompressed.
#include "io/detail/image_rows.hpp"

#include <vector>

namespace vug::detail {

/// Where the rows of a page begin: `rows` to a strip, but for the last.
struct PlainStrips {
  std::vector<std::uint64_t> begin;
  std::int64_t rows = 1;
};

/// Reads the part of a row that is asked for and nothing else. `white_is_zero` turns values of unsigned types round.
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

/// Whether numbers of that order are not in this machine's.
bool is_swapped(bool big_endian);

/// Header of a page of values as they are stored.
ImageHeader plain_header(std::int64_t width, std::int64_t height, SampleType type);

}  // namespace vug::detail
