#pragma once
// The processes, called ranks, that compute one case together. Without MPI, and where nobody started more, there is
// one.
#include <string>
#include <utility>
#include <vector>

namespace vug {

/// Items [first, last) of a list, one after the other.
using Runs = std::vector<std::pair<int, int>>;

/// Who computes which items of a list: (rank) in ascending order. Every item has one owner.
using Owners = std::vector<Runs>;

/// owner(item) of [0, count) as runs.
Owners owners_of(const std::vector<int>& owner, int ranks);

/// One beyond the last item that anybody has.
std::size_t end_of(const Owners& owners);

/// This rank among the others. What needs all of them (`most`, `told`, `traded`, `make_whole`, `bring`) must be called
/// by all, in the same order. Ends with the Mpi that gave it.
class Ranks {
 public:
  Ranks() = default;  ///< one rank, this process
  Ranks(int rank, int size) : rank_(rank), size_(size) {}

  int rank() const { return rank_; }
  int size() const { return size_; }
  bool alone() const { return size_ == 1; }
  /// The rank that writes the files.
  bool first() const { return rank_ == 0; }

  /// The largest and the smallest of all ranks' values.
  int most(int value) const;
  double most(double value) const;
  int least(int value) const { return -most(-value); }
  double least(double value) const { return -most(-value); }
  /// What the first rank says.
  std::string told(const std::string& text) const;
  /// What every rank says, on the first one; empty on the others.
  std::vector<std::string> told_by_all(const std::string& text) const;
  /// lists[r] goes to rank r; returns what came from each.
  std::vector<std::vector<int>> traded(const std::vector<std::vector<int>>& lists) const;
  /// Fills in the items of `values` (item), memory of Views, that other ranks own. Kernels that write them must have
  /// ended.
  template <class T>
  void make_whole(const Owners& owners, T* values) const {
    if (!alone()) complete(owners, values, sizeof(T));
  }
  /// Of items [first, last) of a list, `item` bytes each, `own` holds on every rank its own, `whole` on the first one
  /// takes those of others; both begin with the item `first`, in the host's memory.
  void bring(const Owners& owners, int first, int last, std::size_t item, const void* own, void* whole) const;

 private:
  void complete(const Owners& owners, void* values, std::size_t item) const;
  void complete_on_host(const Owners& owners, char* bytes, std::size_t item) const;

  int rank_ = 0, size_ = 1;
};

}  // namespace vug
