#include "host/exit_code.hpp"

#include "base/require.hpp"
#include "host/free_memory.hpp"
#include "host/interruption.hpp"

#include <filesystem>
#include <new>
#include <stdexcept>
#include <string_view>
#include <system_error>

namespace vug {

namespace {

template <class Error>
const Error* as(const std::exception& error) {
  return dynamic_cast<const Error*>(&error);
}

/// Recognised by its text: Kokkos has no type of its own for memory that a device does not have.
bool is_failed_allocation(const std::exception& error) {
  return as<std::runtime_error>(error) &&
         std::string_view(error.what()).find("failed to allocate") != std::string_view::npos;
}

}  // namespace

ExitCode exit_code_of(const std::exception& error) {
  if (as<InputError>(error)) return invalid_input;
  if (as<StabilityError>(error)) return diverged;
  if (const auto* refused = as<std::filesystem::filesystem_error>(error))
    return refused->code() == std::errc::not_enough_memory ? out_of_memory : file_failed;
  if (as<FileError>(error)) return file_failed;
  if (as<Interrupted>(error)) return interrupted;
  if (as<MemoryError>(error) || as<std::bad_alloc>(error) || is_failed_allocation(error)) return out_of_memory;
  return unforeseen;
}

std::string reason_of(const std::exception& error) {
  if (const auto* refused = as<std::filesystem::filesystem_error>(error)) {
    const std::string path = refused->path1().string(), to = refused->path2().string();
    if (!to.empty()) return path + ": cannot copy to " + to + ": " + refused->code().message();
    return (path.empty() ? "the current folder" : path) + ": " + refused->code().message();
  }
  const ExitCode code = exit_code_of(error);
  if (as<std::bad_alloc>(error)) return "out of memory: " + memory_taken();
  if (code == out_of_memory && !as<MemoryError>(error))
    return "out of memory: " + std::string(error.what()) + "; " + memory_taken();
  return code == unforeseen ? "an error of vug itself: " + std::string(error.what()) : error.what();
}

}  // namespace vug
