#pragma once
// `vug completion`: completion of commands and options in a shell.
#include <string>

namespace CLI {
class App;
}

namespace vug {

/// Script for bash, zsh (the script for bash, which zsh's bashcompinit understands) or fish, made from the commands and
/// options of the program. Throws InputError for another shell.
std::string completion_script(const CLI::App& app, const std::string& shell);

}  // namespace vug
