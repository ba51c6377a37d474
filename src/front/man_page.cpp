#include "front/man_page.hpp"

#include "front/commands_of.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace vug {

namespace {

/// Escapes text of a page: a line must not begin with a dot, and a backslash is written by its name.
std::string roff(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '\\' ? std::string("\\e") : std::string(1, c);
  return out.starts_with('.') || out.starts_with('\'') ? "\\&" + out : out;
}

}  // namespace

std::string man_page(const CLI::App& app, const std::string& version) {
  std::string text = fmt::format(
      ".Dd $Mdocdate$\n.Dt VUG 1\n.Os vug {}\n.Sh NAME\n.Nm vug\n.Nd rock that dissolves and fractures while hot and "
      "cold fluid is pushed through it\n.Sh SYNOPSIS\n.Nm\n.Ar command\n.Op Ar options\n.Sh COMMANDS\n",
      version);
  for (const CLI::App* command : commands_of(app)) {
    text += fmt::format(".Ss {}\n{}\n.Bl -tag -width Ds\n", command->get_name(), roff(command->get_description()));
    for (const CLI::Option* option : command->get_options())
      text += fmt::format(".It {}\n{}\n", roff(option->get_name(false, true)), roff(option->get_description()));
    text += ".El\n";
  }
  return text +
         ".Sh EXIT STATUS\n0 done, 1 an error of vug itself, 2 invalid case or command line, 3 the run diverged, 4 "
         "reading or writing failed, 5 "
         "the memory does not suffice, 130 interrupted.\n.Sh SEE ALSO\nThe keys of the case file: docs/case-file.md of "
         "the project, and\n.Nm\n.Cm schema .\n";
}

}  // namespace vug
