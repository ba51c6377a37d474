// Calls a reader with damaged inputs, one after the other, in one process:
//   vug_fuzz_readers READER SEED FIRST COUNT FINDINGS
// An input is accepted or refused with one line by InputError or FileError; one that does anything else is written to
// FINDINGS/READER-SEED-NUMBER. FINDINGS/at holds the number of the input being read (8 bytes), for one that ends the
// process; an input that takes longer than 10 s is ended by SIGALRM. Prints what it has counted, as JSON.
#include "base/require.hpp"
#include "io/message.hpp"
#include "mutator.hpp"
#include "readers.hpp"
#include "support/temporary_folder.hpp"

#include <Kokkos_Core.hpp>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fcntl.h>
#include <new>
#include <sys/mman.h>
#include <unistd.h>

namespace {

using namespace vug;

constexpr unsigned longest = 10;  // s

/// A number in a file, there also when the process has ended in whatever way.
volatile std::uint64_t& number_in(const std::string& path) {
  const int file = open(path.c_str(), O_RDWR | O_CREAT, 0644);
  if (file < 0 || ftruncate(file, sizeof(std::uint64_t)) != 0) std::abort();
  void* memory = mmap(nullptr, sizeof(std::uint64_t), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  if (memory == MAP_FAILED) std::abort();
  close(file);
  return *static_cast<volatile std::uint64_t*>(memory);
}

struct Counts {
  std::uint64_t accepted = 0, refused = 0, findings = 0;
};

/// What is wrong with a refusal; empty where nothing is.
std::string fault_of(const std::string& message) {
  if (message.empty()) return "an empty message";
  if (one_line(message) != message) return "a message that a terminal may not be shown";
  return "";
}

/// Reads the input; what was wrong with that, empty where nothing.
std::string attempt(const campaign::Reader& reader, const std::string& input, Counts& counts) {
  try {
    reader.read(input);
    ++counts.accepted;
    return "";
  } catch (const InputError& error) {
    ++counts.refused;
    return fault_of(error.what());
  } catch (const FileError& error) {
    ++counts.refused;
    return fault_of(error.what());
  } catch (const std::exception& error) {
    return std::string("an exception of another kind: ") + error.what();
  } catch (...) {
    return "an exception that is none";
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 6) {
    std::fprintf(stderr, "usage: %s READER SEED FIRST COUNT FINDINGS\n", argv[0]);
    return 2;
  }
  const Kokkos::ScopeGuard kokkos(Kokkos::InitializationSettings().set_num_threads(1).set_disable_warnings(true));
  const test::TemporaryFolder folder;
  const campaign::Reader reader = campaign::make_reader(argv[1], folder.path());
  const campaign::Mutator mutator(reader.corpus);
  const std::uint64_t seed = std::strtoull(argv[2], nullptr, 10), first = std::strtoull(argv[3], nullptr, 10),
                      count = std::strtoull(argv[4], nullptr, 10);
  const std::string findings = argv[5];
  volatile std::uint64_t& at = number_in(findings + "/at");
  Counts counts;
  for (std::uint64_t index = first; index < first + count; ++index) {
    at = index;
    std::string input = mutator.input(seed, index);
    if (index % 8 != 0) reader.repair(input);  // most of them: the sums refuse whatever is left as it is
    alarm(longest);
    const std::string fault = attempt(reader, input, counts);
    alarm(0);
    if (fault.empty()) continue;
    ++counts.findings;
    const std::string name = reader.name + "-" + argv[2] + "-" + std::to_string(index);
    test::write_text(findings + "/" + name, input);
    std::fprintf(stderr, "%s: %s\n", name.c_str(), one_line(fault).c_str());
  }
  std::printf("{\"accepted\": %llu, \"refused\": %llu, \"findings\": %llu}\n",
              static_cast<unsigned long long>(counts.accepted), static_cast<unsigned long long>(counts.refused),
              static_cast<unsigned long long>(counts.findings));
}
