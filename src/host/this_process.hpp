#pragma once
// Information from the system about this process.
#include <cstdint>
#include <string>

namespace vug {

/// Name of the machine that it runs on.
std::string machine_name();

/// Path of the program that it runs. Throws std::filesystem::filesystem_error where the system does not say.
std::string this_program();

/// Largest memory that it has held so far, bytes.
std::int64_t peak_memory_bytes();

/// Time of a clock that is never adjusted, s.
double steady_seconds();

}  // namespace vug
