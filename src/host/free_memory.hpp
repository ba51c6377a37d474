#pragma once
// How much memory this process may still take on the host, and who says so.
#include <stdexcept>
#include <string>

namespace vug {

/// The memory does not suffice (exit code 5): what is needed and what there is.
struct MemoryError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct FreeMemory {
  double bytes = 0;      ///< infinity where the system does not say
  std::string bound_by;  ///< "the machine", "the control group", "ulimit -v", "ulimit -d"
};

/// The tightest of what the machine has free (swap with it), the limits of the control groups that hold the process
/// (caches that can be dropped count as free), and the limits of its address space and data. Linux; elsewhere infinite.
FreeMemory free_memory();

/// "1.2 GiB had been taken; that given back, the control group leaves 1.5 GiB", for messages after an allocation
/// failed.
std::string memory_taken();

/// Throws MemoryError when `bytes` more than what is held do not fit: `what` needs at least so much, so much is free.
void require_memory(double bytes, const std::string& what);

/// Throws MemoryError: `what` needs `bytes` at least, which it cannot have for that reason.
[[noreturn]] void refuse_memory(double bytes, const std::string& what, const std::string& reason);

}  // namespace vug
