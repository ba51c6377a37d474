// Files that are no valid case, each refused with one clear line; and damage at random, which never does worse than
// that.
#include "support/refused_in_child.hpp"
#include "support/temporary_folder.hpp"
#include "unit/case_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <sys/stat.h>

namespace vug {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string refusal_of_file(const std::filesystem::path& path) {
  try {
    read_scene(path.string());
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// What the first line says, "# expect: ..."; files that cannot hold it are listed here.
std::string expectation(const std::filesystem::path& path) {
  const std::map<std::string, std::string> unreadable = {{"empty", "is empty"},
                                                         {"blank", "is empty"},
                                                         {"byte_order_mark", "is empty"},
                                                         {"binary", "is not a text file"},
                                                         {"utf16", "is UTF-16 text"}};
  const auto listed = unreadable.find(path.stem().string());
  if (listed != unreadable.end()) return listed->second;
  const std::string text = testing_cases::bytes_of(path);
  const std::string mark = "# expect: ";
  EXPECT_THAT(text, StartsWith(mark)) << path;
  return text.substr(mark.size(), text.find('\n') - mark.size());
}

TEST(BrokenCases, EachIsRefusedWithOneLineThatNamesFileAndFault) {
  const auto paths = testing_cases::cases_in("tests/cases/broken");
  EXPECT_GE(paths.size(), 200u);
  for (const auto& path : paths) {
    const std::string message = refusal_of_file(path);
    EXPECT_THAT(message, StartsWith(path.string() + ":"));
    EXPECT_THAT(message, HasSubstr(expectation(path)));
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_LT(message.size(), path.string().size() + 400) << message;
  }
}

TEST(BrokenCases, AFileThatMayNotBeReadIsAFileError) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "case.toml";
  test::write_text(path, "[lattice]\n");
  std::filesystem::permissions(folder.path(), std::filesystem::perms::others_exec, std::filesystem::perm_options::add);
  std::filesystem::permissions(path, std::filesystem::perms::none);
  EXPECT_TRUE(test::refused_without_rights([&] { read_scene(path); }, path + ": cannot open"));
}

TEST(BrokenCases, AHugeFileIsRefusedUnread) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "case.toml";
  test::write_text(path, "[lattice]\n");
  std::filesystem::resize_file(path, std::uintmax_t{1} << 40);
  EXPECT_THAT(refusal_of_file(path), HasSubstr("is larger than"));
}

TEST(BrokenCases, WhatIsNoFileIsNotWaitedFor) {
  const test::TemporaryFolder folder;
  const std::string pipe = folder / "pipe.toml";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THAT(refusal_of_file(pipe), HasSubstr("is a pipe, not a file"));
  EXPECT_THAT(refusal_of_file("/dev/zero"), HasSubstr("is a device, not a file"));
  const std::string rock =
      "[lattice]\nsize = [0.01, 0.02]\nspacing = 1e-3\ntime_step = 1e-4\n[time]\nsteps = 10\n"
      "[geometry]\ntype = \"rock\"\n[mechanics]\n[rock]\nmesh = \"";
  EXPECT_THAT(testing_cases::refusal(rock + pipe + "\"\n", "a.toml"),
              HasSubstr("a.toml:11:8: rock.mesh = \"" + pipe + "\" is a pipe, not a file"));
}

// TOML 1.0 has letters beyond ASCII in strings and comments only; toml++ 3.3 reads beyond a table's end for some.
TEST(BrokenCases, LettersBeyondAsciiStandBetweenQuotesOnly) {
  for (const char* text :
       {"ҏ = 1\n", "[ҏ]\n", "[lattice]\nҏ.x = 1\n", "a = ҏ\n", "a = { ҏ = 1 }\n", "\xEF\xBB\xBFҏ = 1\n"})
    EXPECT_THAT(testing_cases::refusal(text, "a.toml"), HasSubstr("not valid TOML")) << text;
  const std::string good =
      "[case] # ҏ\nname = \"ҏ\"\ndescription = \"\"\"\nҏ\n\"\"\"\n[lattice]\nsize = [1, 1]\nspacing = 0.1\n"
      "time_step = 0.001\n[time]\nsteps = 1\n[flow]\nviscosity = 1\n";
  EXPECT_EQ(testing_cases::refusal(good, "a.toml"), "");
  EXPECT_EQ(parse_scene(good, "a.toml", {"case.name=Größe ҏ"}).name, "Größe ҏ");
  EXPECT_THAT(testing_cases::refusal(good, "a.toml", {"case.name=[ҏ]"}), HasSubstr("not valid TOML"));
  EXPECT_THAT(testing_cases::refusal(good, "a.toml", {"case.name=\xff"}), HasSubstr("is no UTF-8 text"));
}

TEST(BrokenCases, LongNamesAreNotRepeatedAtLength) {
  const std::string million(1000000, 'y');
  const std::string head =
      "[lattice]\nsize = [1, 1]\nspacing = 0.1\ntime_step = 0.001\n[time]\nsteps = 1\n[solute]\n"
      "[[solute.species]]\nname = \"A\"\ndiffusivity = 1\n";
  for (const std::string& text :
       {head + "[boundary.left.solute]\ntype = \"concentration\"\nconcentration = { " + million + " = 1 }\n",
        head + "[boundary.shape." + million + "]\n",
        head + "[output]\nfields = [\"" + million + "\", \"" + million + "\"]\n", head + "[" + million + "]\n"}) {
    const std::string message = testing_cases::refusal(text, "a.toml");
    EXPECT_THAT(message, StartsWith("a.toml:"));
    EXPECT_LT(message.size(), 500u);
  }
}

// A search that is quadratic in the length of the file would run into the time limit of the test.
TEST(BrokenCases, AwkwardTextsTakeNoTimeAndNoStack) {
  const auto repeated = [](std::string before, const std::string& text, int count, const std::string& after) {
    for (int i = 0; i < count; ++i) before.append(text);
    return before.append(after);
  };
  const std::vector<std::string> texts = {
      repeated("", "[", 1000000, ""),
      repeated("", "a.", 1000000, "b = 1"),
      repeated("[", "\"a\".", 100000, "b]"),
      repeated("a = ", "{a=", 100000, ""),
      repeated("a = ", "[", 100000, ""),
      repeated("", "[[solute.species]]\nname = \"A\"\n", 50000, ""),
      repeated(
          "[lattice]\nsize = [0.01, 0.02]\nspacing = 1e-3\ntime_step = 1e-4\n[time]\nsteps = 10\n[output]\nfields = [",
          "\"x\", ", 500000, "]\n"),
      repeated("x = \"", "y", 3000000, "\"\n"),
      repeated("", "y", 3000000, " = 1\n"),
      repeated("[case]\nname = '''", "...... ", 100000, "'''\n")};
  for (const std::string& text : texts) {
    const std::string message = testing_cases::refusal(text, "a.toml");
    EXPECT_THAT(message, StartsWith("a.toml"));
    EXPECT_LT(message.size(), 1000u);
  }
}

/// One random change: of a byte, a stretch, a line, or a value.
std::string mutated(std::string text, std::mt19937& random) {
  const auto below = [&](std::size_t n) { return n == 0 ? 0 : random() % n; };
  const std::vector<std::string> values = {
      "nan",        "-inf", "1e400",       "-0",    "0x7fffffffffffffff",  "[]",  "{}", "\"\"", "true",
      "1979-05-27", "'''",  "\"\\u0000\"", "[[1]]", "9223372036854775808", "\xff"};
  const std::size_t at = below(text.size());
  switch (below(7)) {
    case 0:
      text[at] = static_cast<char>(below(256));
      break;
    case 1:
      text.erase(at, 1 + below(40));
      break;
    case 2:
      text.insert(at, 1, static_cast<char>(below(256)));
      break;
    case 3:
      text.resize(at);
      break;
    case 4:
      text.insert(at, text.substr(below(text.size()), below(200)));
      break;
    case 5: {  // another value after some equals sign
      const auto equals = text.find('=', at);
      if (equals == std::string::npos) break;
      const auto end = text.find_first_of(",}\n", equals);
      text.replace(equals + 1, (end == std::string::npos ? text.size() : end) - equals - 1,
                   values[below(values.size())]);
      break;
    }
    default: {  // two lines change places
      const auto line = text.find('\n', at);
      const auto other = text.find('\n', below(text.size()));
      if (line == std::string::npos || other == std::string::npos) break;
      const std::string moved = text.substr(line, text.find('\n', line + 1) - line);
      text.insert(other, moved);
    }
  }
  return text;
}

TEST(BrokenCases, TwoThousandMutationsAreAcceptedOrRefusedInOneLine) {
  const std::string path = std::string(VUG_SOURCE_DIR) + "/cases/quickstart.toml";
  const std::string text = testing_cases::bytes_of(path);
  ASSERT_GT(text.size(), 1000u);
  std::mt19937 random(20261121);
  int refused = 0;
  for (int i = 0; i < 2000; ++i) {
    std::string changed = text;
    for (unsigned change = 0; change <= random() % 4; ++change) changed = mutated(changed, random);
    try {
      parse_scene(changed, path);
    } catch (const InputError& error) {
      ++refused;
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      EXPECT_THAT(error.what(), StartsWith(path));
    } catch (const FileError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 1000);  // most changes break something; comments and texts may change freely
}

TEST(BrokenCases, MutatedOverridesAreAcceptedOrRefusedInOneLine) {
  const std::string path = std::string(VUG_SOURCE_DIR) + "/cases/quickstart.toml";
  const std::string text = testing_cases::bytes_of(path);
  const std::vector<std::string> seeds = {"solute.species.0.diffusivity=1e-9", "rock.notches.0.to=[0.03, 0.035]",
                                          "boundary.left.flow={ type = \"wall\" }", "case.name=some text"};
  std::mt19937 random(7);
  for (int i = 0; i < 2000; ++i) {
    const std::string changed = mutated(seeds[random() % seeds.size()], random);
    try {
      parse_scene(text, path, {changed});
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace vug
