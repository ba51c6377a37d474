#include "study/pool.hpp"

#include "base/require.hpp"
#include "host/control_groups.hpp"
#include "host/interruption.hpp"
#include "host/openmp_places.hpp"
#include "host/this_process.hpp"
#include "io/message.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fcntl.h>
#include <map>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace vug {

namespace {

/// A job, prepared so that a child process can become it with calls that a signal handler may use, and nothing else.
struct Call {
  explicit Call(const Job& job) : words(job.words), log(job.log), complaint(one_line(words[0]) + ": cannot be run: ") {
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    for (int number = 0; number < 256; ++number) reasons.push_back(std::strerror(number) + std::string("\n"));
  }
  std::vector<std::string> words;
  std::vector<char*> pointers;
  std::string log, complaint;
  std::vector<std::string> reasons;  ///< (errno)
};

void say(const std::string& text) {
  if (::write(STDERR_FILENO, text.data(), text.size()) < 0) return;  // there is nowhere else to report it
}

/// The signals of listen_to_signals (process.cpp), held back while a child is no job yet: its handler, a copy of the
/// parent's, would only note them, and exec forgets notes.
sigset_t signals_to_stop() {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU, SIGUSR1}) sigaddset(&set, signal);
  return set;
}

/// Runs in the child, between fork and exec, with signals held back; `mask`: those of the parent.
[[noreturn]] void become(const Call& call, pid_t parent, const sigset_t& mask) {
  const int file = ::open(call.log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0666);
  if (file >= 0) {
    ::dup2(file, STDOUT_FILENO);
    ::dup2(file, STDERR_FILENO);
  }
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::_exit(127);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU, SIGUSR1}) {
    struct sigaction handled {};
    if (::sigaction(signal, nullptr, &handled) == 0 && handled.sa_handler != SIG_IGN) ::signal(signal, SIG_DFL);
  }
  ::sigprocmask(SIG_SETMASK, &mask, nullptr);
  ::execv(call.pointers[0], call.pointers.data());
  const auto why = static_cast<std::size_t>(errno);
  say(call.complaint);
  say(call.reasons[why % call.reasons.size()]);
  ::_exit(127);
}

pid_t begin(const Job& job) {
  const Call call(job);
  const sigset_t held = signals_to_stop();
  sigset_t mask;
  ::sigprocmask(SIG_BLOCK, &held, &mask);
  const pid_t self = ::getpid(), child = ::fork();
  if (child == 0) become(call, self, mask);
  ::sigprocmask(SIG_SETMASK, &mask, nullptr);
  if (child < 0) throw FileError(job.words[0] + ": cannot begin a process: " + std::strerror(errno));
  return child;
}

struct Running {
  std::size_t job;
  double since;
  bool seen = false;
};

}  // namespace

void run_jobs(const std::vector<Job>& jobs, int at_once, const std::function<void(const Ended&)>& tell,
              const std::function<bool(std::size_t)>& look) {
  const StopsInOrder in_order;
  leave_openmp_place();
  if (at_once > 1) ::setenv("OMP_PROC_BIND", "false", 1);  // else all would be bound to the first place
  std::map<pid_t, Running> running;
  std::size_t next = 0;
  bool stopped = false;
  std::exception_ptr wrong;
  const auto ending = [&] { return stop_requested() || wrong; };
  const auto look_at = [&](Running& one) {
    try {
      if (!one.seen && !wrong) one.seen = look(one.job);
    } catch (...) {
      wrong = std::current_exception();
    }
  };
  while (!running.empty() || (next < jobs.size() && !ending())) {
    if (next < jobs.size() && running.size() < static_cast<std::size_t>(at_once) && !ending()) {
      running[begin(jobs[next])] = {next, steady_seconds()};
      ++next;
      continue;
    }
    for (auto& [child, one] : running) look_at(one);
    const bool end = ending();  // read once, because a signal may come at any time
    if (end && !stopped)
      for (const auto& [child, one] : running) ::kill(child, SIGTERM);
    stopped = end;
    int status = 0;
    const pid_t child = ::waitpid(-1, &status, WNOHANG);
    const auto found = running.find(child);
    if (found == running.end()) {
      ::usleep(20000);  // short enough to notice a stop or the end of a child in time
      continue;
    }
    look_at(found->second);
    const Ended ended{found->second.job, WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status),
                      steady_seconds() - found->second.since};
    running.erase(found);
    tell(ended);
  }
  if (wrong) std::rethrow_exception(wrong);
}

int processors() {
  leave_openmp_place();
  cpu_set_t set;
  CPU_ZERO(&set);
  const int count = ::sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1, granted = granted_processors();
  return std::max(1, granted > 0 ? std::min(count, granted) : count);
}

}  // namespace vug
