#pragma once
// What modules offer for output, and what a checkpoint must hold. Both hide the type of the Views behind a function
// that copies to the host, called only when something is written.
#include "kernels/base/base.hpp"

#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace vug {

/// A named array in SI for output: `read` fills items × components values, components fastest.
struct Field {
  std::string name;  ///< lower case with underscores, for instance "solid_fraction"
  std::string unit;  ///< SI, "1" where there is none
  int components = 1;
  std::function<void(std::span<double>)> read;
};

/// Fields of one kind of item (lattice nodes row by row without halo, particles, or bonds).
struct FieldList {
  std::vector<Field> lattice;
  std::vector<Field> particles;
  std::vector<Field> bonds;
};

/// A named block of raw bytes that a restart needs.
struct StateBlock {
  std::string name;
  std::function<std::vector<std::byte>()> save;
  std::function<void(std::span<const std::byte>)> load;  ///< throws FileError when the size does not fit
};

/// What the numbers of a block may be. No file can be trusted, and a number out of range may be an index, or the length
/// of a loop.
struct StateRange {
  double least = std::numeric_limits<double>::lowest(), most = std::numeric_limits<double>::max();
};

/// Everything a checkpoint must hold so that a restart continues with the same bits.
struct StateList {
  std::vector<StateBlock> blocks;

  /// A View of numbers that keeps its extent from here on. Loading throws FileError for one that is not finite or out
  /// of range.
  template <class ViewType>
  void add(std::string name, ViewType view, StateRange range = {});
  /// A plain number on the host, likewise.
  template <class Value>
  void add_value(std::string name, Value& value, StateRange range = {});
  void add(StateBlock block) { blocks.push_back(std::move(block)); }
};

}  // namespace vug

#include "io/detail/state_list.hpp"
