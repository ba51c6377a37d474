#pragma once
// Memory that this process may still take on the host, and what limits it.
#include <stdexcept>
#include <string>

namespace vug {

/// The memory is not sufficient (exit code 5); the message says what is needed and what there is.
struct MemoryError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct FreeMemory {
  double bytes = 0;      ///< infinity where the system does not say
  std::string bound_by;  ///< "the machine", "the control group", "ulimit -v", "ulimit -d"
};

/// The smallest of: what the machine has free (including swap), the limits of the control groups of the process (caches
/// that can be dropped count as free), and the limits of its address space and data. Linux; elsewhere infinite.
FreeMemory free_memory();

/// For messages after a failed allocation: "1.2 GiB had been taken; that given back, the control group leaves 1.5 GiB".
std::string memory_taken();

/// Throws MemoryError when `bytes` more than what is held do not fit: `what` needs at least so much, so much is free.
void require_memory(double bytes, const std::string& what);

/// Throws MemoryError: `what` needs at least `bytes`, which it cannot have for the given reason.
[[noreturn]] void refuse_memory(double bytes, const std::string& what, const std::string& reason);

}  // namespace vug
