#pragma once
// Words of a command line that no command takes.
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace vug {

/// What is wrong with `words`, of which `app` has found that some are not expected: a command or an option that there
/// is none of, and which was probably meant.
std::string told_of_unexpected(const CLI::App& app, const std::vector<std::string>& words);

}  // namespace vug
