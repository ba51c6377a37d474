#pragma once
// `vug man`: the manual page.
#include <string>

namespace CLI {
class App;
}

namespace vug {

/// A page for man(1), in mdoc, made from the commands and options of the program.
std::string man_page(const CLI::App& app, const std::string& version);

}  // namespace vug
