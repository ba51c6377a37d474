#pragma once
// Small cases of which error bars are made: a slab heated from one side, the same as a picture, intervals of a rock.
#include "io/scene.hpp"
#include "support/run_vug.hpp"

#include <fmt/format.h>

#include <fstream>
#include <string>
#include <vector>

namespace vug::test {

inline const std::string slab = R"(
[lattice]
size = [0.024, 0.012]
spacing = 1e-3
time_step = 1e-2
[time]
steps = 64
[geometry]
type = "open"
[heat]
fluid_diffusivity = 1e-6
solid_diffusivity = 1e-6
[boundary.left]
heat = { type = "temperature", temperature = 320 }
[output]
interval_steps = 16
)";

class CaseFile {
 public:
  explicit CaseFile(const std::string& text) { std::ofstream(path()) << text; }
  std::string path() const { return folder_ / "case.toml"; }
  Scene scene(const std::vector<std::string>& overrides = {}) const { return read_scene(path(), overrides); }
  const TemporaryFolder& folder() const { return folder_; }

 private:
  TemporaryFolder folder_;
};

/// The slab with a picture of `columns` x `rows` pixels whose middle third is rock.
inline Scene pictured(const CaseFile& file, int columns, int rows, const std::vector<std::string>& more = {}) {
  std::ofstream picture(file.folder() / "a.raw", std::ios::binary);
  for (int n = 0; n < columns * rows; ++n)
    picture.put(n % columns >= columns / 3 && n % columns < 2 * columns / 3 ? '\0' : '\xff');
  picture.close();
  std::vector<std::string> set{"geometry.type=image", "geometry.file=a.raw",
                               fmt::format("geometry.raw_size=[{}, {}]", columns, rows),
                               fmt::format("geometry.pixel_size={}", 0.024 / columns), "heat.solid_diffusivity=4e-6"};
  set.insert(set.end(), more.begin(), more.end());
  return file.scene(set);
}

inline const std::vector<std::string> rock_intervals{"accuracy.update_interval=6",   "accuracy.wall_interval=15",
                                                     "accuracy.heat_interval=4",     "accuracy.solute_interval=2",
                                                     "accuracy.exchange_interval=1", "accuracy.precision=single"};

}  // namespace vug::test
