// Threads wait for each other awake only briefly, unless the user wants otherwise.
#include "support/background_vug.hpp"

#include <gmock/gmock.h>

#include <cstdlib>
#include <optional>

namespace vug {
namespace {

/// A variable of the environment that is another one, or none, while this exists.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    put(value);
  }
  ~Variable() { put(before_ ? before_->c_str() : nullptr); }

 private:
  void put(const char* value) const { value ? setenv(name_, value, 1) : unsetenv(name_); }
  const char* name_;
  std::optional<std::string> before_;
};

/// The environment that a run has got, its variables between zeros.
std::string environment_of_a_run() {
  const test::TemporaryFolder folder;
  const std::string out = folder / "out";
  const test::BackgroundVug vug("run " + test::small_rock + " --quiet --threads 2 -o " + out, folder / "log");
  EXPECT_TRUE(vug.wait_for_file(out + "/run.json")) << vug.log();
  return test::contents("/proc/" + std::to_string(vug.pid()) + "/environ");
}

TEST(Waits, AreShort) {
  const Variable policy("OMP_WAIT_POLICY", nullptr), spin("GOMP_SPINCOUNT", nullptr), block("KMP_BLOCKTIME", nullptr);
  const std::string environment = environment_of_a_run() + '\0';
  EXPECT_THAT(environment, testing::HasSubstr("GOMP_SPINCOUNT=10000"));
  EXPECT_THAT(environment, testing::HasSubstr(std::string("\0KMP_BLOCKTIME=1\0", 17)));
}

TEST(Waits, AreAsTheUserSays) {
  const Variable spin("GOMP_SPINCOUNT", nullptr);
  {
    const Variable policy("OMP_WAIT_POLICY", "active");
    EXPECT_THAT(environment_of_a_run(), testing::Not(testing::HasSubstr("GOMP_SPINCOUNT")));
  }
  const Variable policy("OMP_WAIT_POLICY", nullptr), mine("GOMP_SPINCOUNT", "77");
  EXPECT_THAT(environment_of_a_run(), testing::HasSubstr("GOMP_SPINCOUNT=77"));
  const Variable none("GOMP_SPINCOUNT", nullptr), my_block("KMP_BLOCKTIME", "33");
  EXPECT_THAT(environment_of_a_run(), testing::HasSubstr("KMP_BLOCKTIME=33"));
}

}  // namespace
}  // namespace vug
