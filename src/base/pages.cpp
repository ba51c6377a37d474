#include "base/pages.hpp"

#include <cstdint>
#include <cstring>

#if defined(__linux__)
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace vug {

namespace {

/// The whole pages of [data, data + bytes).
struct Pages {
  std::uintptr_t first, last;

  Pages(void* data, std::size_t bytes) {
#if defined(__linux__)
    static const auto size = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
#else
    constexpr std::uintptr_t size = 4096;
#endif
    const auto begin = reinterpret_cast<std::uintptr_t>(data);
    first = (begin + size - 1) / size * size;
    last = (begin + bytes) / size * size;
  }
};

/// Gives the system advice on the use of pages (madvise). Returns whether it was accepted.
bool advise(const Pages& pages, int advice) {
#if defined(__linux__)
  return pages.first < pages.last &&
         madvise(reinterpret_cast<void*>(pages.first), pages.last - pages.first, advice) == 0;
#else
  (void)pages, (void)advice;
  return false;
#endif
}

}  // namespace

void give_back_pages(void* data, std::size_t bytes) {
#if defined(MADV_DONTNEED)
  const Pages pages(data, bytes);
  if (advise(pages, MADV_DONTNEED)) {
    const auto begin = reinterpret_cast<std::uintptr_t>(data);
    std::memset(data, 0, pages.first - begin);
    std::memset(reinterpret_cast<void*>(pages.last), 0, begin + bytes - pages.last);
    return;
  }
#endif
  std::memset(data, 0, bytes);
}

void keep_pages_small(void* data, std::size_t bytes) {
#if defined(MADV_NOHUGEPAGE)
  advise(Pages(data, bytes), MADV_NOHUGEPAGE);
#else
  (void)data, (void)bytes;
#endif
}

void take_large_pages(void* data, std::size_t bytes) {
#if defined(MADV_HUGEPAGE) && defined(MADV_DONTNEED)
  const Pages pages(data, bytes);
  if (advise(pages, MADV_HUGEPAGE)) advise(pages, MADV_DONTNEED);
#else
  (void)data, (void)bytes;
#endif
}

}  // namespace vug
