#pragma once
// Everything that reads what a user or a disk hands to vug, each with a few sound inputs.
#include <functional>
#include <string>
#include <vector>

namespace vug::campaign {

struct Reader {
  std::string name;
  std::vector<std::string> corpus;
  std::function<void(const std::string&)> read;  ///< throws InputError or FileError, or accepts
  /// Makes the sums of a damaged input fit again, so that the damage is met behind them.
  std::function<void(std::string&)> repair = [](std::string&) {};
};

/// The reader called `name`: case, set, mesh, png, raw, checkpoint or repaired. Files are written into `folder`.
/// Throws std::invalid_argument for another name.
Reader make_reader(const std::string& name, const std::string& folder);

}  // namespace vug::campaign
