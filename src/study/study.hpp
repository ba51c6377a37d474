#pragma once
// A study, parsed: many runs of one case that differ in some keys.
#include <cstdint>
#include <string>
#include <vector>

namespace vug {

enum class Sampling { grid, list, latin_hypercube };

/// A key of the case that differs between runs.
struct StudyKey {
  std::string key;                  ///< "reaction.damkohler", as for --set
  std::vector<std::string> values;  ///< in TOML's syntax; empty where a range is given
  double from = 0, to = 0;          ///< of a range
  bool logarithmic = false;         ///< values of the range are evenly spaced in their logarithm
};

struct Study {
  std::string path, case_path;
  std::string text;  ///< as read
  Sampling sampling = Sampling::grid;
  int samples = 0;  ///< of the Latin hypercube
  std::uint64_t seed = 1;
  std::vector<std::string> overrides;  ///< of all runs, applied before those of their keys
  std::vector<StudyKey> keys;
  std::vector<std::string> results;  ///< columns of the history that go into the table; empty: all
};

/// Reads a study. Throws InputError `file:line:column: what is wrong`, FileError.
Study read_study(const std::string& path);

/// The values of the keys in every run, [run][key], in TOML's syntax: for a grid all combinations, the last key
/// fastest; for a list the n-th values; for a Latin hypercube one value of every key in each of `samples` equal parts
/// of its range (McKay, Beckman & Conover 1979). Depends on the study alone.
std::vector<std::vector<std::string>> sample(const Study& study);

}  // namespace vug
