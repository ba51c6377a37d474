#include "host/interruption.hpp"

#include <atomic>
#include <csignal>

namespace vug {

namespace {

std::atomic<int> signal_noted{0};
std::atomic<int> in_order{0};
std::atomic<const char*> last_words{"interrupted before anything was written"};
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<const char*>::is_always_lock_free,
              "a handler of signals may use no lock");

const char* name_of(int signal) {
  switch (signal) {
    case SIGINT:
      return "SIGINT";
    case SIGTERM:
      return "SIGTERM";
    case SIGHUP:
      return "SIGHUP";
    case SIGXCPU:
      return "SIGXCPU";
    case SIGUSR1:
      return "SIGUSR1";
    default:
      return "a signal";
  }
}

}  // namespace

void request_stop(int signal) {
  signal_noted = signal;
}

bool stop_requested() {
  return stop_signal() != 0;
}

int stop_signal() {
  return signal_noted;
}

std::string stop_reason() {
  return std::string("interrupted by ") + name_of(signal_noted);
}

void throw_if_stop_requested() {
  if (stop_requested()) throw Interrupted(stop_reason());
}

void say_when_ended(const char* words) {
  last_words = words;
}

const char* words_when_ended() {
  return last_words;
}

StopsInOrder::StopsInOrder() {
  ++in_order;
}

StopsInOrder::~StopsInOrder() {
  --in_order;
}

bool StopsInOrder::now() {
  return in_order > 0;
}

}  // namespace vug
