#pragma once
// `vug completion`: what a shell may offer after `vug`.
#include <string>

namespace CLI {
class App;
}

namespace vug {

/// A script for bash, zsh (that for bash, which zsh's bashcompinit understands) or fish, made from the commands and
/// options of the program. Throws InputError for another shell.
std::string completion_script(const CLI::App& app, const std::string& shell);

}  // namespace vug
