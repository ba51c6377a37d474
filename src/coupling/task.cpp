#include "coupling/task.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace vug {

std::string to_text(const std::vector<Task>& schedule) {
  const auto words = [](const std::vector<std::string>& names) {
    return names.empty() ? std::string("-") : fmt::format("{}", fmt::join(names, ", "));
  };
  std::size_t name = 4, reads = 5;
  for (const Task& task : schedule) {
    name = std::max(name, task.name.size());
    reads = std::max(reads, words(task.reads).size());
  }
  std::string text = fmt::format("{:<{}}  {:>6}  {:<{}}  {}\n", "task", name, "every", "reads", reads, "writes");
  for (const Task& task : schedule) {
    text += fmt::format("{:<{}}  {:>6}  {:<{}}  {}", task.name, name, task.interval, words(task.reads), reads,
                        words(task.writes));
    if (!task.takes.empty()) text += fmt::format("; takes {}", words(task.takes));
    text += '\n';
  }
  return text;
}

}  // namespace vug
