// NRRD: a text header (teem.sourceforge.net/nrrd/format.html), an empty line, then the values, raw or in gzip format.
#include "io/detail/image_plain.hpp"
#include "io/detail/samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <zlib.h>

namespace vug::detail {
namespace {

/// The fields of a header by name, and the position where the values begin.
struct NrrdHeader {
  std::string path;
  std::map<std::string, std::string> fields;
  std::uint64_t end = 0;

  std::string need(const char* field) const {
    const auto found = fields.find(field);
    if (found == fields.end()) refuse_image(path, fmt::format("its header has no field \"{}\"", field));
    return found->second;
  }
  std::string get(const char* field) const {
    const auto found = fields.find(field);
    return found == fields.end() ? "" : found->second;
  }
};

NrrdHeader read_header(const BinaryFile& file) {
  std::string text(1 << 16, '\0');
  text.resize(file.read(0, text.data(), text.size()));
  if (!text.starts_with("NRRD000")) refuse_image(file.path(), "is no NRRD file");
  NrrdHeader header{file.path(), {}, 0};
  for (std::size_t at = 0; header.end == 0;) {
    const std::size_t next = text.find('\n', at);
    if (next == std::string::npos) refuse_image(file.path(), "its header does not end");
    std::string line = text.substr(at, next - at);
    if (line.ends_with('\r')) line.pop_back();
    at = next + 1;
    if (line.empty()) header.end = at;
    const std::size_t colon = line.find(": ");
    if (!line.starts_with('#') && colon != std::string::npos)
      header.fields[line.substr(0, colon)] = line.substr(colon + 2);
  }
  return header;
}

SampleType type_of(const NrrdHeader& header) {
  static const std::pair<SampleType, std::vector<std::string>> types[] = {
      {SampleType::uint8, {"uchar", "unsigned char", "uint8", "uint8_t"}},
      {SampleType::int8, {"signed char", "int8", "int8_t"}},
      {SampleType::uint16, {"ushort", "unsigned short", "unsigned short int", "uint16", "uint16_t"}},
      {SampleType::int16, {"short", "short int", "int16", "int16_t"}},
      {SampleType::uint32, {"uint", "unsigned int", "uint32", "uint32_t"}},
      {SampleType::int32, {"int", "signed int", "int32", "int32_t"}},
      {SampleType::float32, {"float"}},
      {SampleType::float64, {"double"}}};
  const std::string name = header.need("type");
  for (const auto& [type, names] : types)
    if (std::find(names.begin(), names.end(), name) != names.end()) return type;
  refuse_image(header.path, fmt::format("has values of the type \"{}\", which is not read", name));
}

std::vector<std::int64_t> sizes_of(const NrrdHeader& header) {
  std::istringstream text(header.need("sizes"));
  std::vector<std::int64_t> sizes;
  for (std::int64_t size = 0; text >> size;) {
    if (size < 1 || size > 1 << 28) refuse_image(header.path, fmt::format("its header has a size of {}", size));
    sizes.push_back(size);
  }
  if (sizes.size() != 2 && sizes.size() != 3)
    refuse_image(header.path, fmt::format("has {} dimensions; 2 (columns, rows) or 3 (columns, rows, pages) are read",
                                          sizes.size()));
  if (header.get("kinds").find("color") != std::string::npos || header.get("kinds").find("vector") != std::string::npos)
    refuse_image(header.path, "holds colours or vectors; a grey picture or labels are read");
  return sizes;
}

/// Pixel size, m, from "space directions" with "space units", or from "spacings" with "units"; empty where one of the
/// two is missing.
std::optional<std::array<double, 2>> pixel_of(const NrrdHeader& header) {
  const bool oriented = header.fields.contains("space directions");
  std::istringstream units(header.get(oriented ? "space units" : "units"));
  std::istringstream edges(header.get(oriented ? "space directions" : "spacings"));
  std::array<double, 2> size;
  for (double& edge : size) {
    std::string unit, text;
    const bool named = static_cast<bool>(std::getline(units, text, '"')) && std::getline(units, unit, '"');
    const std::optional<double> metres = named ? metres_in(unit) : std::nullopt;
    if (!metres) return std::nullopt;
    double sum = 0;
    if (oriented) {
      if (!std::getline(edges, text, '(') || !std::getline(edges, text, ')')) return std::nullopt;
      std::replace(text.begin(), text.end(), ',', ' ');
      std::istringstream parts(text);
      for (double part = 0; parts >> part;) sum += part * part;
    } else {
      double part = 0;
      if (!(edges >> part)) return std::nullopt;
      sum = part * part;
    }
    edge = std::sqrt(sum) * *metres;
    if (!(edge > 0) || !std::isfinite(edge)) return std::nullopt;
  }
  return size;
}

/// Rows of a gzip stream, which must be read one after the other.
class GzipRows : public ImageRows {
 public:
  GzipRows(const std::string& path, ImageHeader what, std::uint64_t begin, std::uint64_t skip, SampleType type,
           bool swapped)
      : file_(path), at_(begin), to_skip_(skip), type_(type), swapped_(swapped) {
    header = std::move(what);
    if (inflateInit2(&stream_, 15 + 32) != Z_OK) throw std::bad_alloc();
  }
  GzipRows(const GzipRows&) = delete;
  GzipRows& operator=(const GzipRows&) = delete;
  ~GzipRows() override { inflateEnd(&stream_); }

  void read(int y, int first, std::span<double> values) override {
    const std::size_t size = bytes_of(type_);
    row_.resize(std::max<std::size_t>(size * header.width, 1));
    for (; to_skip_ > 0; to_skip_ -= std::min<std::uint64_t>(to_skip_, row_.size()))
      inflate_into(std::min<std::uint64_t>(to_skip_, row_.size()));
    for (; next_ <= y; ++next_) inflate_into(row_.size());
    decode(row_.data() + size * first, type_, swapped_, values);
  }

 private:
  void inflate_into(std::size_t count) {
    stream_.next_out = row_.data();
    stream_.avail_out = static_cast<uInt>(count);
    while (stream_.avail_out > 0) {
      if (stream_.avail_in == 0) {
        stream_.avail_in = static_cast<uInt>(file_.read(at_, block_, sizeof block_));
        stream_.next_in = block_;
        at_ += stream_.avail_in;
        if (stream_.avail_in == 0) refuse_image(file_.path(), "the file ends too early");
      }
      const int state = inflate(&stream_, Z_NO_FLUSH);
      if (state != Z_OK && !(state == Z_STREAM_END && stream_.avail_out == 0))
        refuse_image(file_.path(),
                     state == Z_STREAM_END ? "the file ends too early" : "its compressed values are damaged");
    }
  }

  BinaryFile file_;
  std::uint64_t at_, to_skip_;
  SampleType type_;
  bool swapped_;
  int next_ = 0;  ///< row that inflate_into returns next
  z_stream stream_{};
  std::vector<unsigned char> row_;
  unsigned char block_[1 << 16];
};

}  // namespace

std::unique_ptr<ImageRows> open_nrrd(const ImageSection& image) {
  const BinaryFile file(image.file);
  const NrrdHeader nrrd = read_header(file);
  for (const char* field : {"data file", "datafile", "line skip", "lineskip", "byte skip", "byteskip"})
    if (!nrrd.get(field).empty() && nrrd.get(field) != "0")
      refuse_image(image.file,
                   fmt::format("its header has the field \"{}\"; one file with header and values is read", field));
  const std::vector<std::int64_t> sizes = sizes_of(nrrd);
  const SampleType type = type_of(nrrd);
  const bool swapped = bytes_of(type) > 1 && is_swapped(nrrd.need("endian") == "big");
  require_page(image, sizes.size() == 3 ? sizes[2] : 1);
  ImageHeader header = plain_header(sizes[0], sizes[1], type);
  header.pixel = pixel_of(nrrd);
  const std::uint64_t page = bytes_of(type) * static_cast<std::uint64_t>(sizes[0]) * sizes[1] * image.page;
  const std::string encoding = nrrd.need("encoding");
  if (encoding == "raw")
    return std::make_unique<PlainRows>(image.file, header, PlainStrips{{nrrd.end + page}, sizes[1]}, type, swapped);
  if (encoding == "gzip" || encoding == "gz")
    return std::make_unique<GzipRows>(image.file, header, nrrd.end, page, type, swapped);
  refuse_image(image.file, fmt::format("has the encoding \"{}\"; raw and gzip are read", encoding));
}

}  // namespace vug::detail
