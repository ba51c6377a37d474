#include "front/unexpected.hpp"

#include "front/commands_of.hpp"
#include "io/detail/nearest_name.hpp"
#include "io/message.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace vug {

namespace {

bool is_option(const std::string& word) {
  return word.starts_with("-");
}

std::string no_command(const CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* command : commands_of(app)) names.push_back(command->get_name());
  const bool draws = word == "plot" || word == "view" || word == "show" || word == "draw";
  return fmt::format(
      "there is no command \"{}\"{}", word,
      draws ? "; scripts/plot DIR draws the pictures of a run (installed: vug-plot DIR)" : likely_name(word, names));
}

std::string no_option(const CLI::App& command, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  const std::string name = word.substr(0, word.find('='));
  return fmt::format("not expected: {}{}", word, likely_name(name, names));
}

}  // namespace

std::string told_of_unexpected(const CLI::App& app, const std::vector<std::string>& words) {
  const auto given = app.get_subcommands();
  const auto command = std::find_if_not(words.begin(), words.end(), is_option);
  if (given.empty() && command != words.end()) return no_command(app, excerpt(*command, 60));
  const auto left = app.remaining(true);  // not always in their order
  const auto first = std::find_if(words.begin(), words.end(), [&](const auto& word) {
    return std::find(left.begin(), left.end(), word) != left.end();
  });
  if (first == words.end()) return "a word is not expected";
  const std::string word = excerpt(*first, 60);
  if (is_option(word)) return no_option(given.empty() ? app : *given.front(), word);
  const bool after_set =
      std::any_of(words.begin(), first, [](const auto& before) { return before.starts_with("--set"); });
  return fmt::format("not expected: {}{}", word,
                     after_set ? "; --set takes one word, in quotes where it has blanks: 'table.key=20 MPa'" : "");
}

}  // namespace vug
