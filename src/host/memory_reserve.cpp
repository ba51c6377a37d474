#include "host/memory_reserve.hpp"

#include "host/exit_code.hpp"

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <new>
#include <string_view>
#include <unistd.h>

namespace vug {

namespace {

constexpr std::size_t reserve_size = 256u << 10;
std::atomic<void*> reserve{nullptr};
std::terminate_handler usual_end = nullptr;

bool has_spare() {
  void* volatile room = std::malloc(reserve_size);  // volatile, because a compiler may leave out both calls
  std::free(room);
  return room != nullptr;
}

/// Called by operator new when it has found no memory.
void give_reserve_back() {
  std::free(reserve.exchange(nullptr));
  std::set_new_handler(nullptr);
  throw std::bad_alloc();
}

void on_terminate() {
  if (!has_spare()) end_out_of_memory();
  usual_end();
}

}  // namespace

bool reserve_memory() {
  reserve = std::malloc(reserve_size);
  if (!reserve) return false;
  std::set_new_handler(give_reserve_back);
  usual_end = std::set_terminate(on_terminate);
  return true;
}

void require_spare_memory() {
  if (!has_spare()) throw std::bad_alloc();
}

void end_out_of_memory() {
  constexpr std::string_view words = "vug: out of memory: there is none left to start with, or to say more\n";
  if (::write(STDERR_FILENO, words.data(), words.size()) < 0) ::_exit(out_of_memory);
  ::_exit(out_of_memory);
}

}  // namespace vug
