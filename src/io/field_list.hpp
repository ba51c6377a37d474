#pragma once
// The fields that modules offer for output, and the blocks that a checkpoint must contain. Both hide the type of the
// Views behind functions that copy to the host, piece by piece, and are called only when something is written. Where
// several ranks share a field, all of them make the same calls, and rank 0 gets the values.
#include "base/base.hpp"

#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace vug {

/// Fills items × components values, components fastest, from the item `first` on.
using ReadItems = std::function<void(std::size_t first, std::span<double> values)>;

/// A named array in SI for output.
struct Field {
  std::string name;  ///< lower case with underscores, for instance "solid_fraction"
  std::string unit;  ///< SI, "1" where there is none
  int components = 1;
  std::function<ReadItems()> open;  ///< computes the values as they are now, for reading

  /// Reads all items at once.
  void read(std::span<double> values) const { open()(0, values); }
};

/// Fields of one kind of item (lattice nodes row by row without halo, particles, or bonds).
struct FieldList {
  std::vector<Field> lattice;
  std::vector<Field> particles;
  std::vector<Field> bonds;
};

/// Takes bytes in their order, in pieces.
using TakeBytes = std::function<void(std::span<const std::byte>)>;
/// Fills in the bytes from `at` on.
using GiveBytes = std::function<void(std::size_t at, std::span<std::byte>)>;

/// A named block of raw bytes that a restart needs.
struct StateBlock {
  std::string name;
  std::size_t bytes;
  std::function<void(const TakeBytes&)> save;
  std::function<void(const GiveBytes&)> load;  ///< throws FileError for invalid numbers

  /// Returns all bytes.
  std::vector<std::byte> saved() const;
  void load_all(std::span<const std::byte> bytes) const;  ///< throws FileError also when the size does not fit
};

/// Range of the numbers of a block. A file cannot be trusted, and a number out of range may be an index or the length
/// of a loop.
struct StateRange {
  double least = std::numeric_limits<double>::lowest(), most = std::numeric_limits<double>::max();
};

/// Everything a checkpoint must contain so that a restart continues with the same bits.
struct StateList {
  std::vector<StateBlock> blocks;

  /// Adds a View of numbers, whose extent must not change afterwards. Loading throws FileError for a number that is not
  /// finite or out of range.
  template <class ViewType>
  void add(std::string name, ViewType view, StateRange range = {});
  /// The same for a single number on the host.
  template <class Value>
  void add_value(std::string name, Value& value, StateRange range = {});
  void add(StateBlock block) { blocks.push_back(std::move(block)); }
};

}  // namespace vug

#include "io/detail/state_list.hpp"
