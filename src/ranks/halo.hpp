#pragma once
// Values that a rank reads of items that others compute.
#include "kernels/base/base.hpp"
#include "ranks/ranks.hpp"

#include <array>
#include <memory>
#include <vector>

namespace vug {

/// Who needs which slots of a list from whom. All ranks number the slots alike. Messages lie in a device's memory where
/// MPI takes them from there (takes_device_memory), else in the host's.
class Halo {
 public:
  Halo() = default;
  /// This rank needs `slots`, each from the rank that owns it. Called by all ranks.
  Halo(const Ranks& ranks, const std::vector<int>& slots, const std::vector<int>& owner);

  /// fields[k](slot) of every slot that a rank needs = that of its owner. One packing kernel, one message per
  /// neighbour, one unpacking kernel; buffers and requests are made at the first call and kept. Called by all ranks.
  template <class T, std::size_t n>
  void exchange(const Exec& exec, const std::array<ScalarField<T>, n>& fields) const;
  /// The other way: the owners get what the ranks hold that need the slots. No slot may be needed by two ranks.
  template <class T, std::size_t n>
  void exchange_back(const Exec& exec, const std::array<ScalarField<T>, n>& fields) const;

  /// Slots that come here.
  int taken() const;
  std::vector<int> taken_slots() const;

 private:
  struct Lists;
  std::shared_ptr<Lists> lists_;
};

}  // namespace vug
