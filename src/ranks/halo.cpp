#include "ranks/halo.hpp"

#include "kernels/launch/launch.hpp"
#include "ranks/mpi.hpp"
#include "ranks/traffic.hpp"

#include <map>

#ifdef VUG_MPI
#include <mpi.h>
#endif

namespace vug {

namespace {

/// Slots, ordered by the ranks that they go to or come from.
struct Slots {
  IndexList slot;
  std::vector<int> rank, first;  ///< (neighbour), (neighbour + 1)

  Slots() = default;
  explicit Slots(const std::vector<std::vector<int>>& lists) : first{0} {
    std::vector<int> all;
    for (std::size_t r = 0; r < lists.size(); ++r) {
      if (lists[r].empty()) continue;
      all.insert(all.end(), lists[r].begin(), lists[r].end());
      rank.push_back(static_cast<int>(r));
      first.push_back(static_cast<int>(all.size()));
    }
    slot = to_device<IndexList>("vug::halo::slots", all);
  }
  int count() const { return first.empty() ? 0 : first.back(); }
};

}  // namespace

template <class T, std::size_t n>
struct PackHalo {
  IndexList slot;
  ScalarField<T> field[n];
  T* buffer;
  KOKKOS_FUNCTION void operator()(int k) const {
    for (std::size_t c = 0; c < n; ++c) buffer[n * k + c] = field[c](slot(k));
  }
};

template <class T, std::size_t n>
struct UnpackHalo {
  IndexList slot;
  ScalarField<T> field[n];
  const T* buffer;
  KOKKOS_FUNCTION void operator()(int k) const {
    for (std::size_t c = 0; c < n; ++c) field[c](slot(k)) = buffer[n * k + c];
  }
};

#ifdef VUG_MPI

namespace {

/// Messages of one direction and one size of value, as persistent requests.
struct Channel {
  using Buffer = Kokkos::View<double*>;
  Buffer out, in;                           ///< buffers of the kernels
  Buffer::host_mirror_type sent, received;  ///< buffers of MPI, where it cannot use those
  bool direct = takes_device_memory();
  std::vector<MPI_Request> requests;

  Channel(const Slots& from, const Slots& to, std::size_t bytes) {
    const auto room = [&](const char* label, const Slots& slots) {
      return Buffer(label, (slots.count() * bytes + sizeof(double) - 1) / sizeof(double));
    };
    out = room("vug::halo::out", from);
    in = room("vug::halo::in", to);
    if (!direct) {
      sent = Kokkos::create_mirror_view(out);
      received = Kokkos::create_mirror_view(in);
    }
    const auto make = [&](const Slots& slots, double* buffer, auto init) {
      char* const begin = reinterpret_cast<char*>(buffer);
      for (std::size_t k = 0; k < slots.rank.size(); ++k) {
        requests.emplace_back();
        init(begin + slots.first[k] * bytes, static_cast<int>((slots.first[k + 1] - slots.first[k]) * bytes), MPI_BYTE,
             slots.rank[k], 0, MPI_COMM_WORLD, &requests.back());
      }
    };
    make(to, direct ? in.data() : received.data(), MPI_Recv_init);
    make(from, direct ? out.data() : sent.data(), MPI_Send_init);
  }
  /// The only fence of an exchange: MPI reads what the kernel and the copy write, and receives into the buffer from
  /// which the previous exchange has unpacked and copied.
  void make_ready(const Exec& exec) {
    if (!direct) Kokkos::deep_copy(exec, sent, out);
    exec.fence("vug::halo::packed");
  }
  void trade() {
    const int count = static_cast<int>(requests.size());
    MPI_Startall(count, requests.data());
    MPI_Waitall(count, requests.data(), MPI_STATUSES_IGNORE);
  }
  void take(const Exec& exec) {
    if (!direct) Kokkos::deep_copy(exec, in, received);
  }
  Channel(const Channel&) = delete;
  Channel& operator=(const Channel&) = delete;
  ~Channel() {
    if (!direct) Kokkos::fence("vug::halo::received");  // may still be copied from
    for (MPI_Request& request : requests) MPI_Request_free(&request);
  }
};

}  // namespace

struct Halo::Lists {
  Slots give, take;
  std::map<std::pair<bool, std::size_t>, std::unique_ptr<Channel>> channels;

  template <class T, std::size_t n>
  void exchange(const Exec& exec, const std::array<ScalarField<T>, n>& fields, bool back) {
    const Slots &from = back ? take : give, &to = back ? give : take;
    std::unique_ptr<Channel>& channel = channels[{back, n * sizeof(T)}];
    if (!channel) channel = std::make_unique<Channel>(from, to, n * sizeof(T));
    PackHalo<T, n> pack{from.slot, {}, reinterpret_cast<T*>(channel->out.data())};
    UnpackHalo<T, n> unpack{to.slot, {}, reinterpret_cast<const T*>(channel->in.data())};
    for (std::size_t c = 0; c < n; ++c) pack.field[c] = unpack.field[c] = fields[c];
    for_each_node<false>(exec, "vug::halo::pack", from.count(), pack);
    if (!channel->requests.empty()) {
      channel->make_ready(exec);
      const Exchange counted = Exchange::of_neighbours(to.rank.size(), to.count() * n * sizeof(T));
      channel->trade();
      channel->take(exec);
    }
    for_each_node<false>(exec, "vug::halo::unpack", to.count(), unpack);
  }
};

#else

struct Halo::Lists {
  Slots give, take;
  template <class T, std::size_t n>
  void exchange(const Exec&, const std::array<ScalarField<T>, n>&, bool) {}
};

#endif

Halo::Halo(const Ranks& ranks, const std::vector<int>& slots, const std::vector<int>& owner)
    : lists_(std::make_shared<Lists>()) {
  std::vector<std::vector<int>> needed(ranks.size());
  for (std::size_t k = 0; k < slots.size(); ++k) needed[owner[k]].push_back(slots[k]);
  lists_->take = Slots(needed);
  lists_->give = Slots(ranks.traded(needed));
}

template <class T, std::size_t n>
void Halo::exchange(const Exec& exec, const std::array<ScalarField<T>, n>& fields) const {
  if (lists_) lists_->exchange(exec, fields, false);
}
template <class T, std::size_t n>
void Halo::exchange_back(const Exec& exec, const std::array<ScalarField<T>, n>& fields) const {
  if (lists_) lists_->exchange(exec, fields, true);
}

int Halo::taken() const {
  return lists_ ? lists_->take.count() : 0;
}
std::vector<int> Halo::taken_slots() const {
  if (taken() == 0) return {};
  const auto slot = on_host(lists_->take.slot);
  return {slot.data(), slot.data() + slot.extent(0)};
}

#define VUG_INSTANTIATE(T, n)                                                            \
  template void Halo::exchange(const Exec&, const std::array<ScalarField<T>, n>&) const; \
  template void Halo::exchange_back(const Exec&, const std::array<ScalarField<T>, n>&) const;
VUG_INSTANTIATE(float, 1)
VUG_INSTANTIATE(double, 1)
VUG_INSTANTIATE(float, 2)
VUG_INSTANTIATE(double, 2)
VUG_INSTANTIATE(double, 3)
VUG_INSTANTIATE(double, 8)
#undef VUG_INSTANTIATE

}  // namespace vug
