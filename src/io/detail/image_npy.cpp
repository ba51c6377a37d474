// NumPy's .npy: a line of Python that says type, order and shape, then the values (NEP 1).
#include "io/detail/image_plain.hpp"
#include "io/detail/samples.hpp"

#include <fmt/format.h>

#include <charconv>
#include <regex>

namespace vug::detail {
namespace {

struct NpyType {
  SampleType type;
  bool big_endian, boolean;
};

/// '<u2' is little-endian, unsigned, two bytes.
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

std::vector<std::int64_t> numbers_in(const std::string& text) {
  std::vector<std::int64_t> numbers;
  static const std::regex number("[0-9]{1,12}");
  for (std::sregex_iterator match(text.begin(), text.end(), number), end; match != end; ++match)
    numbers.push_back(std::stoll(match->str()));
  return numbers;
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
  static const std::regex described("'descr': *'([^']{1,8})'"), ordered("'fortran_order': *(True|False)"),
      shaped("'shape': *\\(([0-9, ]{1,60})\\)");
  std::smatch descr, order, shape;
  if (!std::regex_search(text, descr, described) || !std::regex_search(text, order, ordered) ||
      !std::regex_search(text, shape, shaped))
    refuse_image(image.file, "its header is damaged, or its values are not plain numbers");
  if (order[1] == "True")
    refuse_image(image.file, "has its columns together (Fortran order); save np.ascontiguousarray of it");
  const std::vector<std::int64_t> size = numbers_in(shape[1]);
  if (size.size() != 2 && size.size() != 3)
    refuse_image(image.file,
                 fmt::format("has {} dimensions; 2 (rows, columns) or 3 (pages, rows, columns) are read", size.size()));
  const NpyType type = type_of(image.file, descr[1]);
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
