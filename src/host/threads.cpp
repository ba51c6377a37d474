#include "host/threads.hpp"

#include "base/require.hpp"
#include "host/control_groups.hpp"
#include "host/idle_processors.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <future>
#include <initializer_list>
#include <string_view>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <vector>

#if defined(_OPENMP)
#include <omp.h>
#endif

namespace vug {
namespace {

[[noreturn]] void refuse(const char* variable, std::string_view value, const std::string& wanted) {
  throw InputError("environment: " + std::string(variable) + " = " + std::string(value.substr(0, 60)) + " must be " +
                   wanted);
}

/// The whole number in an environment variable, at least `least`; `absent` where the variable is not set.
int whole_number(const char* variable, int least, int absent) {
  const char* text = std::getenv(variable);
  if (!text) return absent;
  const std::string_view value(text);
  int number = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
  if (error != std::errc() || end != value.data() + value.size() || number < least)
    refuse(variable, value, "a whole number, " + std::to_string(least) + " or more");
  return number;
}

void require_word(const char* variable, std::initializer_list<std::string_view> words, const char* wanted) {
  const char* text = std::getenv(variable);
  if (!text) return;
  std::string value(text);
  for (char& c : value) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (std::find(words.begin(), words.end(), value) == words.end()) refuse(variable, text, wanted);
}

/// Checks the variables of Kokkos, which aborts at one that it cannot read.
void check_environment() {
  whole_number("KOKKOS_NUM_THREADS", 1, 1);
  whole_number("KOKKOS_DEVICE_ID", 0, 0);
  for (const char* variable : {"KOKKOS_DISABLE_WARNINGS", "KOKKOS_PRINT_CONFIGURATION", "KOKKOS_TUNE_INTERNALS"})
    require_word(variable, {"yes", "no", "true", "false", "1", "0"}, "true or false");
  require_word("KOKKOS_MAP_DEVICE_ID_BY", {"random", "mpi_rank"}, "random or mpi_rank");
}

#if defined(_OPENMP)

/// Threads that do nothing until they are let end. Whatever is thrown meanwhile, they have ended when it is caught: a
/// thread that nobody has joined would end the program.
class IdleThreads {
 public:
  explicit IdleThreads(int most) { threads_.reserve(static_cast<std::size_t>(std::max(most, 0))); }
  IdleThreads(const IdleThreads&) = delete;
  IdleThreads& operator=(const IdleThreads&) = delete;
  ~IdleThreads() {
    end_.set_value();
    for (std::thread& thread : threads_) thread.join();
  }
  /// Throws std::system_error where the system refuses it, std::bad_alloc where there is no memory for it.
  void start_one() {
    threads_.emplace_back([over = over_] { over.wait(); });
  }
  int count() const { return static_cast<int>(threads_.size()); }

 private:
  std::promise<void> end_;
  std::shared_future<void> over_ = end_.get_future().share();
  std::vector<std::thread> threads_;
};

/// Throws where the system refuses a thread: OpenMP would end the program.
void require_startable(int count) {
  IdleThreads beside_this_one(count - 1);
  try {
    while (beside_this_one.count() < count - 1) beside_this_one.start_one();
  } catch (const std::system_error& error) {
    throw InputError("threads: the system grants " + std::to_string(beside_this_one.count() + 1) + " of " +
                     std::to_string(count) + " (" + error.what() + "); ask for fewer by --threads");
  }
}

/// Number of threads that a parallel region of `count` threads really has.
int threads_of_a_region(int count) {
  int found = 1;
#pragma omp parallel num_threads(count)
#pragma omp single
  found = omp_get_num_threads();
  return found;
}

/// Remark that there are more threads than processors that they may use, if a launcher, a batch system or `taskset` has
/// restricted these, a control group limits their time, or several processes share them. Too many threads of one
/// process on a whole machine are taken as intended.
std::string remark_on_processors(int count, int sharing, int granted) {
  const int bound_to = omp_get_num_procs(), processors = granted > 0 ? std::min(granted, bound_to) : bound_to;
  const bool bound = processors < sysconf(_SC_NPROCESSORS_ONLN);
  if (count * sharing <= processors || (!bound && sharing == 1)) return "";
  const std::string threads = (sharing > 1 ? std::to_string(sharing) + " processes of " : "") + std::to_string(count);
  return "threads: " + threads + " on " + std::to_string(processors) +
         (processors == 1 ? " processor" : " processors") +
         " that they may use, and they wait for each other: fewer by --threads, or more processors by the launcher "
         "(mpirun --map-by slot:PE=" +
         std::to_string(count) + " or --bind-to none, srun --cpus-per-task=" + std::to_string(count) + ")";
}

#endif

}  // namespace

ThreadChoice choose_threads(int wanted, bool looks_around, int sharing) {
  check_environment();
  ThreadChoice choice;
#if defined(_OPENMP)
  omp_set_dynamic(0);  // else OpenMP may give fewer from one parallel region to the next
  if (omp_get_max_active_levels() < 1) omp_set_max_active_levels(1);
  int usual = omp_get_max_threads();
  if (!std::getenv("OMP_NUM_THREADS")) usual = std::max(1, usual / sharing);
  const int asked = wanted > 0 ? wanted : whole_number("KOKKOS_NUM_THREADS", 1, usual);
  const auto fewer = [&](int count, const std::string& why) {
    choice.count = count;
    choice.remark = "threads: " + std::to_string(count) + " instead of " + std::to_string(asked) + ": " + why;
  };
  choice.count = asked;
  const bool said = wanted > 0 || std::getenv("KOKKOS_NUM_THREADS") || std::getenv("OMP_NUM_THREADS");
  const int granted = granted_processors();
  if (const int share = std::max(1, granted / sharing); granted > 0 && !said && share < asked)
    fewer(share, "the control group (of a container or a batch job) grants the time of " + std::to_string(granted) +
                     (granted == 1 ? " processor" : " processors") + (sharing > 1 ? " to all ranks" : "") +
                     "; --threads insists");
  if (choice.count > most_threads)
    fewer(std::min(omp_get_num_procs(), most_threads),
          "at most " + std::to_string(most_threads) + " are possible; this is one per processor");
  if (choice.count > omp_get_thread_limit()) fewer(omp_get_thread_limit(), "OMP_THREAD_LIMIT allows no more");
  constexpr double while_looking = 0.15;  // s
  if (looks_around && !said && choice.count > 1)
    if (const int idle = idle_processors(while_looking); idle > 0 && idle < choice.count)
      fewer(idle,
            "other programs keep processors busy, and threads that wait for those are slower than fewer threads; "
            "--threads insists");
  require_startable(choice.count);
  omp_set_num_threads(choice.count);
  if (const int given = threads_of_a_region(choice.count); given < choice.count) fewer(given, "OpenMP gives no more");
  omp_set_num_threads(choice.count);
  if (choice.remark.empty()) choice.remark = remark_on_processors(choice.count, sharing, granted);
#else
  (void)wanted;
  (void)looks_around;
  (void)sharing;
#endif
  return choice;
}

}  // namespace vug
