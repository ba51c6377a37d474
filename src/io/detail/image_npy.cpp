// NumPy's .npy: a line of Python with type, order and shape, then the values (NEP 1).
#include "io/detail/image_plain.hpp"
#include "io/detail/samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>
#include <vector>

namespace vug::detail {
namespace {

struct NpyType {
  SampleType type;
  bool big_endian, boolean;
};

/// Type of a name such as '<u2': little-endian, unsigned, two bytes.
NpyType type_of(const std::string& path, const std::string& text) {
  constexpr std::pair<const char*, SampleType> types[] = {
      {"u1", SampleType::uint8}, {"u2", SampleType::uint16},  {"u4", SampleType::uint32}, {"u8", SampleType::uint64},
      {"i1", SampleType::int8},  {"i2", SampleType::int16},   {"i4", SampleType::int32},  {"i8", SampleType::int64},
      {"b1", SampleType::uint8}, {"f4", SampleType::float32}, {"f8", SampleType::float64}};
  for (const auto& [name, type] : types)
    if (text.size() == 3 && text.substr(1) == name) return {type, text[0] == '>', text[1] == 'b'};
  refuse_image(path,
               fmt::format("has values of the type '{}'; integers, booleans, float32 and float64 are read", text));
}

/// Text after `'key':` and blanks in the header; empty where it has no such key.
std::string_view value_of(std::string_view header, const std::string& key) {
  const std::size_t at = header.find("'" + key + "':");
  if (at == std::string_view::npos) return {};
  header.remove_prefix(at + key.size() + 3);
  header.remove_prefix(std::min(header.find_first_not_of(' '), header.size()));
  return header;
}

/// Text between `open`, with which `value` begins, and the next `close`; empty where it is longer than `most`.
std::string_view enclosed(std::string_view value, char open, char close, std::size_t most) {
  if (!value.starts_with(open)) return {};
  const std::size_t end = value.find(close, 1);
  return end == std::string_view::npos || end > most + 1 ? std::string_view{} : value.substr(1, end - 1);
}

/// Numbers of at most 12 digits, separated by commas and blanks; empty where there is anything else.
std::vector<std::int64_t> numbers_in(std::string_view text) {
  std::vector<std::int64_t> numbers;
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(", "), text.size()));
    if (text.empty()) return numbers;
    std::int64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const auto digits = static_cast<std::size_t>(end - text.data());
    if (error != std::errc() || digits > 12 || number < 0) return {};
    numbers.push_back(number);
    text.remove_prefix(digits);
  }
}

}  // namespace

std::unique_ptr<ImageRows> open_npy(const ImageSection& image) {
  const BinaryFile file(image.file);
  unsigned char start[12] = {};
  if (file.read(0, start, sizeof start) < 10 || std::string(start, start + 6) != "\x93NUMPY")
    refuse_image(image.file, "is no .npy file");
  const std::size_t begin = start[6] == 1 ? 10 : 12;
  const std::size_t length = start[6] == 1
                                 ? start[8] + 256u * start[9]
                                 : start[8] + 256u * start[9] + 65536u * start[10] + (std::size_t{start[11]} << 24);
  std::string text(std::min<std::size_t>(length, 1 << 16), '\0');
  if (length > text.size() || file.read(begin, text.data(), length) < length)
    refuse_image(image.file, "its header is damaged");
  // no std::regex: it recurses once for every blank, and a header may have 65,536 of them
  const std::string descr(enclosed(value_of(text, "descr"), '\'', '\'', 8));
  const std::string_view order = value_of(text, "fortran_order");
  const std::vector<std::int64_t> size = numbers_in(enclosed(value_of(text, "shape"), '(', ')', 60));
  if (descr.empty() || (!order.starts_with("True") && !order.starts_with("False")) || size.empty())
    refuse_image(image.file, "its header is damaged, or its values are not plain numbers");
  if (order.starts_with("True"))
    refuse_image(image.file, "has its columns together (Fortran order); save np.ascontiguousarray of it");
  if (size.size() != 2 && size.size() != 3)
    refuse_image(image.file,
                 fmt::format("has {} dimensions; 2 (rows, columns) or 3 (pages, rows, columns) are read", size.size()));
  if (size.size() == 3 && size[0] > 4 && (size[2] == 3 || size[2] == 4))
    refuse_image(image.file, fmt::format("is a colour picture (rows, columns, {}); save its grey values, an array of "
                                         "(rows, columns)",
                                         size[2]));
  const NpyType type = type_of(image.file, descr);
  const std::int64_t height = size[size.size() - 2], width = size.back(), pages = size.size() == 3 ? size[0] : 1;
  require_page(image, pages);
  ImageHeader header = plain_header(width, height, type.type);
  if (type.boolean) header.white = 1;
  const double bytes =
      static_cast<double>(bytes_of(type.type)) * static_cast<double>(width) * static_cast<double>(height);
  if (bytes * static_cast<double>(pages) > static_cast<double>(file.size()))
    refuse_image(image.file, "the file ends too early");
  return std::make_unique<PlainRows>(
      image.file, header, PlainStrips{{begin + length + static_cast<std::uint64_t>(bytes) * image.page}, height},
      type.type, is_swapped(type.big_endian));
}

}  // namespace vug::detail
