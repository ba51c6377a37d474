#pragma once
// A file system without locks, for what runs in the process of a test. Included by one file of an executable.
#include <cerrno>
#include <sys/file.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace vug::test {

inline bool no_locks = false;

/// While one lives, flock fails as on a file system that has no locks.
struct NoLocks {
  NoLocks() { no_locks = true; }
  NoLocks(const NoLocks&) = delete;
  NoLocks& operator=(const NoLocks&) = delete;
  ~NoLocks() { no_locks = false; }
};

}  // namespace vug::test

/// In place of the C library's.
extern "C" int flock(int descriptor, int operation) noexcept {
  if (!vug::test::no_locks) return static_cast<int>(::syscall(SYS_flock, descriptor, operation));
  errno = ENOSYS;
  return -1;
}
