#pragma once
// Fields with room for all nodes, of which every rank computes its own (docs/scaling.md): what a rank holds of them,
// and how they are written to a checkpoint and read back, piece by piece.
#include "coupling/split.hpp"
#include "io/field_list.hpp"

#include <cstring>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace vug {

/// Which rank has what of a field: planes of items with the same owners, one plane after the other.
struct Shares {
  Owners owners;
  int planes = 1;
  std::vector<Halo> halos;      ///< those that bring a rank slots of others
  bool halos_of_plane = false;  ///< halos number the items of one plane and apply to every plane

  Shares(Owners owners_, int planes_, std::vector<Halo> halos_)
      : owners(std::move(owners_)), planes(planes_), halos(std::move(halos_)) {}
  /// For both components of a vector.
  static Shares of_vector(Owners owners, std::vector<Halo> halos) {
    Shares shares(std::move(owners), 2, std::move(halos));
    shares.halos_of_plane = true;
    return shares;
  }
};

namespace detail {

/// The slots of a View as bytes: their number and size; `look` reads those from `at` on in the host's memory (into
/// `room` where they are elsewhere), `put` writes new ones, `check` checks those to be written.
struct Slots {
  std::size_t count, bytes;
  std::function<const std::byte*(std::size_t at, std::size_t count, std::vector<std::byte>& room)> look;
  std::function<void(std::size_t at, std::span<std::byte>)> put;
  std::function<void(std::span<const std::byte>)> check;
};

void save_shared(const Ranks& ranks, const Shares& shares, const Slots& slots, const TakeBytes& take);
void load_shared(const Ranks& ranks, const Shares& shares, const Slots& slots, const GiveBytes& give);
void let_go(const Ranks& ranks, const Shares& shares, void* values, std::size_t bytes, std::size_t count);

template <class ViewType>
Slots slots_of(const std::string& name, const ViewType& view, StateRange range) {
  using Value = typename ViewType::non_const_value_type;
  using Slice = Kokkos::View<Value*, typename Exec::memory_space, Kokkos::MemoryUnmanaged>;
  using SliceOnHost = Kokkos::View<Value*, Kokkos::HostSpace, Kokkos::MemoryUnmanaged>;
  const auto look = [view](std::size_t at, std::size_t count, std::vector<std::byte>& room) {
    if constexpr (runs_on_host) {
      return reinterpret_cast<const std::byte*>(view.data() + at);
    } else {
      room.resize(count * sizeof(Value));
      Kokkos::deep_copy(SliceOnHost(reinterpret_cast<Value*>(room.data()), count), Slice(view.data() + at, count));
      return static_cast<const std::byte*>(room.data());
    }
  };
  const auto put = [view](std::size_t at, std::span<std::byte> bytes) {
    if constexpr (runs_on_host) {
      std::memcpy(view.data() + at, bytes.data(), bytes.size());
    } else {
      const std::size_t count = bytes.size() / sizeof(Value);
      Kokkos::deep_copy(Slice(view.data() + at, count), SliceOnHost(reinterpret_cast<Value*>(bytes.data()), count));
    }
  };
  const auto check = [name, range](std::span<const std::byte> bytes) { require_range<Value>(name, bytes, range); };
  return {view.span(), sizeof(Value), look, put, check};
}

}  // namespace detail

/// Adds a field to a checkpoint. The file gets the same bytes as from a single rank; each rank takes from it what it
/// holds.
template <class ViewType>
void add_shared(StateList& list, const Ranks& ranks, const std::string& name, const ViewType& view,
                const Shares& shares, StateRange range = {}) {
  if (ranks.alone()) return list.add(name, view, range);
  const detail::Slots slots = detail::slots_of(name, view, range);
  list.add(StateBlock{name, slots.count * slots.bytes,
                      [=](const TakeBytes& take) {
                        Exec().fence("vug::save_shared");
                        detail::save_shared(ranks, shares, slots, take);
                      },
                      [=](const GiveBytes& give) { detail::load_shared(ranks, shares, slots, give); }});
}

/// Applied to the fields that modules share out, each with its name in checkpoints. With a `list` it adds them to a
/// checkpoint. Otherwise, on a host, it gives the memory back of items that neither belong to this rank nor come to it.
class SharedFields {
 public:
  explicit SharedFields(const Ranks& ranks, StateList* list = nullptr) : ranks_(ranks), list_(list) {}
  template <class ViewType>
  void operator()(const std::string& name, const ViewType& view, const Shares& shares) const {
    if (list_)
      add_shared(*list_, ranks_, name, view, shares);
    else if (!ranks_.alone() && runs_on_host)
      detail::let_go(ranks_, shares, view.data(), sizeof(typename ViewType::value_type), view.span());
  }

 private:
  const Ranks& ranks_;
  StateList* list_;
};

}  // namespace vug
