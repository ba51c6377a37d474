#include "process.hpp"

#include "base/require.hpp"
#include "host/exit_code.hpp"
#include "host/interruption.hpp"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <string_view>
#include <sys/prctl.h>
#include <unistd.h>

namespace vug {

namespace {

/// Writes all of `text` by system calls only, so that a signal handler may use it. Returns false, with errno, on
/// failure.
bool write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

volatile std::sig_atomic_t silent = 0, code_of_end = interrupted;

extern "C" void on_stop_signal(int signal) {
  if (StopsInOrder::now()) return request_stop(signal);
  if (!silent)
    for (const char* part : {"vug: ", words_when_ended(), "\n"}) write_all(STDERR_FILENO, part);
  ::_exit(code_of_end);
}

}  // namespace

void occupy_standard_streams() {
  // open takes the lowest free number. The standard input cannot be read, the others cannot be written.
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(descriptor, F_GETFD) < 0 && errno == EBADF)
      ::open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

void leave_words_to_others() {
  silent = 1;
}

void end_with(ExitCode code) {
  code_of_end = code;
  silent = 1;
}

void listen_to_signals() {
  struct sigaction action {};
  action.sa_handler = on_stop_signal;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU, SIGUSR1}) {
    struct sigaction before {};
    if (::sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_IGN) continue;
    ::sigaction(signal, &action, nullptr);
  }
  action.sa_handler = SIG_IGN;
  for (const int signal : {SIGPIPE, SIGXFSZ}) ::sigaction(signal, &action, nullptr);
}

void end_with_parent() {
  if (!std::getenv("VUG_ENDS_WITH_PARENT")) return;
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  ::unsetenv("VUG_ENDS_WITH_PARENT");
}

void print(const std::string& text) {
  if (!write_all(STDOUT_FILENO, text))
    throw FileError(std::string("standard output: cannot write: ") + std::strerror(errno));
}

void complain(const std::string& line) {
  write_all(STDERR_FILENO, line + '\n');
}

}  // namespace vug
