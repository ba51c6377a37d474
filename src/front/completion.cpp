#include "front/completion.hpp"

#include "base/require.hpp"
#include "front/commands_of.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

namespace vug {

namespace {

/// "--steps", "-o": the names of all options of a command.
std::vector<std::string> options_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

std::string bash(const CLI::App& app) {
  std::vector<std::string> names;
  std::string cases;
  for (const CLI::App* command : commands_of(app)) {
    names.push_back(command->get_name());
    cases += fmt::format("    {}) words=\"{}\" ;;\n", command->get_name(), fmt::join(options_of(*command), " "));
  }
  return fmt::format(
      "# bash completion of vug: source it, or put it into /usr/share/bash-completion/completions/vug\n"
      "_vug() {{\n"
      "  local word=${{COMP_WORDS[COMP_CWORD]}} words\n"
      "  case ${{COMP_WORDS[1]}} in\n"
      "{}"
      "  esac\n"
      "  if ((COMP_CWORD == 1)); then words=\"{} {}\"; fi\n"
      "  if ((COMP_CWORD > 1)) && [[ $word != -* ]]; then\n"
      "    local IFS=$'\\n'\n"  // mapfile is unknown to zsh
      "    COMPREPLY=($(compgen -f -X '!*.toml' -- \"$word\"; compgen -d -- \"$word\"))\n"
      "  else\n"
      "    COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
      "  fi\n"
      "}}\n"
      "complete -o filenames -F _vug vug\n",
      cases, fmt::join(names, " "), fmt::join(options_of(app), " "));
}

std::string fish(const CLI::App& app) {
  std::string text = "# fish completion of vug: put it into ~/.config/fish/completions/vug.fish\n";
  for (const CLI::App* command : commands_of(app)) {
    text += fmt::format("complete -c vug -n __fish_use_subcommand -f -a {} -d '{}'\n", command->get_name(),
                        command->get_description());
    for (const CLI::Option* option : command->get_options())
      for (const std::string& name : option->get_lnames())
        text += fmt::format("complete -c vug -n '__fish_seen_subcommand_from {}' -l {} -d '{}'\n", command->get_name(),
                            name, option->get_description());
  }
  return text;
}

}  // namespace

std::string completion_script(const CLI::App& app, const std::string& shell) {
  if (shell == "bash") return bash(app);
  if (shell == "zsh") return "autoload -U +X bashcompinit && bashcompinit\n" + bash(app);
  if (shell == "fish") return fish(app);
  throw InputError(fmt::format("there is no completion for \"{}\"; there are bash, zsh and fish", shell));
}

}  // namespace vug
