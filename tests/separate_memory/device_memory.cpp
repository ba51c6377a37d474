// Memory for Views that the host may not touch outside kernels and copies, on a machine without a device: where vug's
// code would read or write a GPU's memory from the host, a build with VUG_SEPARATE_MEMORY ends with SIGSEGV and says
// where. It comes full of ones, which are NaN: nor may anybody count on zeros that nobody wrote.
//
// Kokkos allocates with one form of operator new, which nobody else here uses, and tells tools when kernels and copies
// begin and end; between them the memory is locked, by a protection key where the processor has them. Elsewhere that
// takes two calls of the system for every View and kernel: of many kernels every so many are followed by a lock, which
// finds what a host does again and again.
#include "mirrors.hpp"

#include <atomic>
#include <cstring>
#include <execinfo.h>
#include <map>
#include <mutex>
#include <new>
#include <signal.h>
#include <string_view>
#include <sys/mman.h>
#include <unistd.h>
#include <vector>

namespace {

constexpr std::size_t reserved = std::size_t{1} << 40, page = 4096;
constexpr std::size_t header = 128;      // of Kokkos, before what a View holds; the host may read it
constexpr int always = 1000, some = 61;  // without keys: after so many kernels, and of those that follow one in so many

thread_local int on_host = 0;  // AllocatesOnHost

class DeviceMemory {
 public:
  DeviceMemory() {
    void* const found =
        mmap(nullptr, reserved, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (found == MAP_FAILED) std::abort();
    begin_ = end_ = static_cast<char*>(found);
    key_ = pkey_alloc(0, 0);
  }

  bool has(const void* address) const { return begin_ <= address && address < begin_ + reserved; }

  void* take(std::size_t size) {
    const std::scoped_lock lock(mutex_);
    const std::size_t length = (size + page - 1) / page * page + page;  // of which the first ends with the header
    std::vector<char*>& old = free_[length];
    char* block = end_;
    if (old.empty()) {
      end_ += length;
    } else {
      block = old.back();
      old.pop_back();
    }
    guard(block + page, length - page, true);
    if (key_ >= 0) pkey_set(key_, 0);
    std::memset(block + page, 0xff, length - page);
    length_[block + page - header] = length;
    if (locked_) lock_all();
    return block + page - header;
  }

  void give(void* pointer) {
    const std::scoped_lock lock(mutex_);
    const std::size_t length = length_.at(pointer);
    char* const block = static_cast<char*>(pointer) + header - page;
    madvise(block, length, MADV_DONTNEED);
    length_.erase(pointer);
    free_[length].push_back(block);
  }

  /// The host waits for kernels and copies: they never overlap.
  void open() {
    const std::scoped_lock lock(mutex_);
    if (open_++ == 0 && locked_) unlock_all();
  }
  void close() {
    const std::scoped_lock lock(mutex_);
    if (--open_ == 0 && (key_ >= 0 || ++closed_ <= always || closed_ % some == 0)) lock_all();
  }

 private:
  void guard(char* block, std::size_t length, bool open) {
    if (key_ >= 0)
      pkey_mprotect(block, length, PROT_READ | PROT_WRITE, key_);
    else
      mprotect(block, length, open ? PROT_READ | PROT_WRITE : PROT_NONE);
  }
  void lock_all() {
    locked_ = true;
    if (key_ >= 0)
      pkey_set(key_, PKEY_DISABLE_ACCESS);
    else
      for (const auto& [pointer, length] : length_) guard(static_cast<char*>(pointer) + header, length - page, false);
  }
  void unlock_all() {
    locked_ = false;
    if (key_ >= 0)
      pkey_set(key_, 0);
    else
      for (const auto& [pointer, length] : length_) guard(static_cast<char*>(pointer) + header, length - page, true);
  }

  std::mutex mutex_;
  char *begin_, *end_;
  int key_, open_ = 0;
  long closed_ = 0;
  bool locked_ = true;
  std::map<std::size_t, std::vector<char*>> free_;
  std::map<void*, std::size_t> length_;
};

DeviceMemory& device() {
  static DeviceMemory* const memory = new DeviceMemory;  // outlives all Views
  return *memory;
}

void say_where(int, siginfo_t* info, void*) {
  if (device().has(info->si_addr)) {
    constexpr std::string_view what = "the host touches a device's memory (tests/separate_memory):\n";
    [[maybe_unused]] const auto written = write(2, what.data(), what.size());
    void* frames[24];
    backtrace_symbols_fd(frames, backtrace(frames, 24), 2);
  }
  signal(SIGSEGV, SIG_DFL);
  raise(SIGSEGV);
}

/// Before main: Kokkos keeps what tools have asked for when it starts, and threads have the keys of who made them.
const bool watching = [] {
  device();
  using namespace Kokkos::Tools::Experimental;
  const auto open = [](const char*, std::uint32_t, std::uint64_t*) { device().open(); };
  const auto close = [](std::uint64_t) { device().close(); };
  set_begin_parallel_for_callback(open);
  set_end_parallel_for_callback(close);
  set_begin_parallel_reduce_callback(open);
  set_end_parallel_reduce_callback(close);
  set_begin_parallel_scan_callback(open);
  set_end_parallel_scan_callback(close);
  set_begin_deep_copy_callback([](Kokkos_Profiling_SpaceHandle, const char*, const void*, Kokkos_Profiling_SpaceHandle,
                                  const char*, const void*, std::uint64_t) { device().open(); });
  set_end_deep_copy_callback([] { device().close(); });
  // a recording's kernels (recording.hpp)
  set_push_region_callback([](const char*) { device().open(); });
  set_pop_region_callback([] { device().close(); });
  struct sigaction action {};
  action.sa_sigaction = say_where;
  action.sa_flags = SA_SIGINFO;
  sigaction(SIGSEGV, &action, nullptr);
  return true;
}();

}  // namespace

vug::test::AllocatesOnHost::AllocatesOnHost() {
  ++on_host;
}
vug::test::AllocatesOnHost::~AllocatesOnHost() {
  --on_host;
}

void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  // what Kokkos' threads share is set up before, and the host's
  if (on_host > 0 || !watching || !Kokkos::is_initialized())
    return std::aligned_alloc(static_cast<std::size_t>(alignment), (size + 63) / 64 * 64);
  return device().take(size);
}

void operator delete(void* pointer, std::align_val_t, const std::nothrow_t&) noexcept {
  if (device().has(pointer))
    device().give(pointer);
  else
    std::free(pointer);
}
