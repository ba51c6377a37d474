#pragma once
// The processes, called ranks, that compute one case together. There is one without MPI, or when no more were started.
#include <string>
#include <utility>
#include <vector>

namespace vug {

/// Runs of consecutive items [first, last) of a list.
using Runs = std::vector<std::pair<int, int>>;

/// (rank) Items of a list that each rank computes, in ascending order. Every item has one owner.
using Owners = std::vector<Runs>;

/// Owners as runs, from `owner` (item).
Owners owners_of(const std::vector<int>& owner, int ranks);

/// One past the last item that any rank owns.
std::size_t end_of(const Owners& owners);

/// This rank among the others. Functions that need all ranks (`most`, `least`, `told`, `told_by_all`, `traded`,
/// `make_whole`, `bring`) must be called by all of them, in the same order. Valid as long as the Mpi object that made
/// it.
class Ranks {
 public:
  Ranks() = default;  ///< one rank, this process
  Ranks(int rank, int size) : rank_(rank), size_(size) {}

  int rank() const { return rank_; }
  int size() const { return size_; }
  bool alone() const { return size_ == 1; }
  /// The rank that writes the files.
  bool first() const { return rank_ == 0; }

  /// Largest and smallest of all ranks' values.
  int most(int value) const;
  double most(double value) const;
  int least(int value) const { return -most(-value); }
  double least(double value) const { return -most(-value); }
  /// The text of the first rank, on every rank.
  std::string told(const std::string& text) const;
  /// (rank) The texts of all ranks, on the first one; empty on the others.
  std::vector<std::string> told_by_all(const std::string& text) const;
  /// Sends lists[r] to rank r and returns the lists received, (rank).
  std::vector<std::vector<int>> traded(const std::vector<std::vector<int>>& lists) const;
  /// Fills in the items of `values` (item), in memory of Views, that other ranks own. Kernels that write them must have
  /// ended.
  template <class T>
  void make_whole(const Owners& owners, T* values) const {
    if (!alone()) complete(owners, values, sizeof(T));
  }
  /// Collects the items [first, last) of a list, `item` bytes each, on the first rank: `own` holds each rank's own
  /// items, and `whole` receives those of the others on the first rank. Both begin with the item `first`, in the host's
  /// memory.
  void bring(const Owners& owners, int first, int last, std::size_t item, const void* own, void* whole) const;

 private:
  void complete(const Owners& owners, void* values, std::size_t item) const;
  void complete_on_host(const Owners& owners, char* bytes, std::size_t item) const;

  int rank_ = 0, size_ = 1;
};

}  // namespace vug
