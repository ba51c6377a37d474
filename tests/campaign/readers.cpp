#include "readers.hpp"

#include "io/checkpoint.hpp"
#include "io/detail/digest.hpp"
#include "io/image_reader.hpp"
#include "io/mesh_reader.hpp"
#include "io/scene.hpp"
#include "support/temporary_folder.hpp"

#include <png.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <zlib.h>

namespace vug::campaign {

namespace {

namespace fs = std::filesystem;

const std::string cases = "tests/cases/complete/";

std::vector<std::string> files_of(std::initializer_list<std::string> folders, const std::string& extension) {
  std::vector<std::string> paths;
  for (const std::string& folder : folders)
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.path().extension() == extension) paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> texts;
  for (const std::string& path : paths) texts.push_back(test::contents(path));
  return texts;
}

/// The keys of the complete cases as --set takes them.
std::vector<std::string> overrides() {
  std::vector<std::string> found;
  for (const std::string& text : files_of({cases}, ".toml")) {
    std::istringstream lines(text);
    for (std::string line, table; std::getline(lines, line);) {
      const auto equals = line.find(" = ");
      if (line.starts_with("[") && !line.starts_with("[[")) table = line.substr(1, line.find(']') - 1) + ".";
      if (line.starts_with("[["))
        table = "";  // of lists no key can be named
      else if (equals != std::string::npos && !table.empty() && line[0] != '#')
        found.push_back(table + line.substr(0, equals) + "=" + line.substr(equals + 3));
    }
  }
  return found;
}

constexpr int width = 8, height = 6;

/// Pictures of every kind that libpng writes by itself.
std::vector<std::string> pictures() {
  std::vector<std::string> found;
  std::vector<png_byte> pixels(width * height * 8);
  for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = static_cast<png_byte>(37 * i);
  std::array<png_byte, 256 * 4> colours{};
  for (std::size_t i = 0; i < colours.size(); ++i) colours[i] = static_cast<png_byte>(91 * i);
  for (const png_uint_32 format :
       std::initializer_list<png_uint_32>{PNG_FORMAT_GRAY, PNG_FORMAT_RGB, PNG_FORMAT_RGBA, PNG_FORMAT_LINEAR_Y,
                                          PNG_FORMAT_LINEAR_RGB_ALPHA, PNG_FORMAT_RGBA_COLORMAP}) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = width;
    image.height = height;
    image.format = format;
    image.colormap_entries = 16;
    std::vector<png_byte> data = pixels;
    if ((format & PNG_FORMAT_FLAG_COLORMAP) != 0)
      for (png_byte& index : data) index %= 16;
    std::string file(4096, '\0');
    png_alloc_size_t size = file.size();
    if (png_image_write_to_memory(&image, file.data(), &size, 0, data.data(), 0, colours.data()) == 0)
      throw std::logic_error(image.message);
    file.resize(size);
    found.push_back(file);
  }
  return found;
}

/// The checksums of a PNG's chunks, as far as its lengths lead.
void repair_png(std::string& file) {
  const auto* bytes = reinterpret_cast<const unsigned char*>(file.data());
  const auto word = [&](std::size_t at) {
    return std::uint32_t{bytes[at]} << 24 | bytes[at + 1] << 16 | bytes[at + 2] << 8 | bytes[at + 3];
  };
  for (std::size_t at = 8; at + 12 <= file.size();) {
    const std::size_t length = word(at);
    if (length > file.size() - at - 12) return;
    const auto sum = crc32(0, bytes + at + 4, static_cast<uInt>(length + 4));
    for (std::size_t k = 0; k < 4; ++k) file[at + 8 + length + k] = static_cast<char>(sum >> (24 - 8 * k));
    at += length + 12;
  }
}

/// The image of a case in memory: `path` is overwritten by each input.
Reader image_reader(const std::string& name, const std::string& path, bool raw) {
  ImageSection image;
  image.file = path;
  if (raw) image.raw_size = {width, height};
  LatticeSection lattice;
  lattice.nx = width;
  lattice.ny = height;
  lattice.spacing = 1;
  return {name, raw ? std::vector<std::string>{std::string(width * height, '\x55')} : pictures(),
          [image, lattice, path](const std::string& input) {
            test::write_text(path, input);
            read_solid_image(image, lattice);
          },
          raw ? [](std::string&) {} : repair_png};
}

/// A state with every kind of block.
struct State {
  std::int64_t step = 12;
  double time = 0.5;
  int count = 3;
  Kokkos::View<double*> field{"field", 5};
  Kokkos::View<std::int32_t*> index{"index", 3};

  StateList list() {
    StateList state;
    state.add_value("clock/step", step, {0, 1e15});
    state.add_value("clock/time", time);
    state.add_value("geometry/count", count, {0, 100});
    state.add("flow/field", field);
    state.add("geometry/index", index, {0, 99});
    return state;
  }
};

const CheckpointOwner owner{"0123456789abcdef", "a run"};

void repair_digest(std::string& file) {
  if (file.size() < 16) return;
  file.resize(file.size() / 8 * 8);
  detail::DataDigest digest;
  digest.add(std::string_view(file).substr(0, file.size() - 8));
  const std::uint64_t value = digest.value();
  std::memcpy(file.data() + file.size() - 8, &value, sizeof value);
}

Reader checkpoint_reader(const std::string& name, const std::string& folder, bool repaired) {
  State state;
  const std::string path = folder + "/step_000000000012.checkpoint";
  write_checkpoint(folder, state.list(), state.step, state.time, owner);
  return {name,
          {test::contents(path)},
          [folder, path](const std::string& input) {
            test::write_text(path, input);
            State read;
            Checkpoint::latest(folder, owner)->load(read.list());
          },
          repaired ? repair_digest : [](std::string&) {}};
}

}  // namespace

Reader make_reader(const std::string& name, const std::string& folder) {
  if (name == "case")
    return {name, files_of({cases, "tests/cases/coupled", "cases", "cases/laboratory"}, ".toml"),
            [](const std::string& input) { parse_scene(input, cases + "case.toml"); }};
  if (name == "set")
    return {name, overrides(), [text = test::contents(cases + "rock.toml")](const std::string& input) {
              parse_scene(text, cases + "rock.toml", {input});
            }};
  if (name == "mesh")
    return {name, files_of({cases, "tests/campaign/meshes"}, ".msh"),
            [](const std::string& input) { parse_mesh(input, "rock.msh"); }};
  if (name == "png" || name == "raw") return image_reader(name, folder + "/image", name == "raw");
  if (name == "checkpoint" || name == "repaired") return checkpoint_reader(name, folder, name == "repaired");
  throw std::invalid_argument("no reader " + name);
}

}  // namespace vug::campaign
