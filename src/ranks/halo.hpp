#pragma once
// Exchange of values that a rank reads and others compute.
#include "base/base.hpp"
#include "ranks/ranks.hpp"

#include <array>
#include <memory>
#include <vector>

namespace vug {

/// Slots of a list that each rank needs from the others. All ranks use the same numbers of slots. Messages are in the
/// device's memory where MPI accepts that (takes_device_memory), else in the host's.
class Halo {
 public:
  Halo() = default;
  /// Makes the halo of a rank that needs `slots`, each from the rank that owns it. Called by all ranks.
  Halo(const Ranks& ranks, const std::vector<int>& slots, const std::vector<int>& owner);

  /// Sets fields[k](slot) of every slot that a rank needs to the owner's value. One packing kernel, one message per
  /// neighbour, one unpacking kernel; buffers and requests are made at the first call and kept. Called by all ranks.
  template <class T, std::size_t n>
  void exchange(const Exec& exec, const std::array<ScalarField<T>, n>& fields) const;
  /// The reverse: the owners receive the values of the ranks that need the slots. No slot may be needed by two ranks.
  template <class T, std::size_t n>
  void exchange_back(const Exec& exec, const std::array<ScalarField<T>, n>& fields) const;

  /// Number of slots that this rank receives.
  int taken() const;
  std::vector<int> taken_slots() const;

 private:
  struct Lists;
  std::shared_ptr<Lists> lists_;
};

}  // namespace vug
