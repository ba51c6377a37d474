#pragma once
// What the system says of this process.
#include <cstdint>
#include <string>

namespace vug {

/// The machine that it runs on.
std::string machine_name();

/// The program that it runs. Throws std::filesystem::filesystem_error where the system does not say.
std::string this_program();

/// The most memory that it has held until now, bytes.
std::int64_t peak_memory_bytes();

/// Time of a clock that is never set, s.
double steady_seconds();

}  // namespace vug
