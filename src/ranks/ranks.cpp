#include "ranks/ranks.hpp"

#include "base/base.hpp"
#include "ranks/traffic.hpp"

#include <algorithm>
#include <cstring>

#ifdef VUG_MPI
#include <mpi.h>
#endif

namespace vug {

Owners owners_of(const std::vector<int>& owner, int ranks) {
  Owners owners(ranks);
  const int count = static_cast<int>(owner.size());
  for (int first = 0, last = 0; first < count; first = last) {
    while (last < count && owner[last] == owner[first]) ++last;
    owners[owner[first]].emplace_back(first, last);
  }
  return owners;
}

std::size_t end_of(const Owners& owners) {
  int end = 0;
  for (const Runs& runs : owners)
    if (!runs.empty()) end = std::max(end, runs.back().second);
  return end;
}

std::vector<std::string> Ranks::told_by_all(const std::string& text) const {
  std::vector<std::vector<int>> letters(size_);
  letters[0].assign(text.begin(), text.end());
  std::vector<std::string> heard;
  for (const std::vector<int>& words : traded(letters))
    if (first()) heard.emplace_back(words.begin(), words.end());
  return heard;
}

#ifdef VUG_MPI

int Ranks::most(int value) const {
  int found = value;
  if (alone()) return found;
  const Exchange counted = Exchange::of_all(sizeof(value));
  MPI_Allreduce(&value, &found, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  return found;
}

double Ranks::most(double value) const {
  double found = value;
  if (alone()) return found;
  const Exchange counted = Exchange::of_all(sizeof(value));
  MPI_Allreduce(&value, &found, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  return found;
}

std::string Ranks::told(const std::string& text) const {
  if (alone()) return text;
  int size = static_cast<int>(text.size());
  const Exchange counted = Exchange::of_all(first() ? 0 : size);
  MPI_Bcast(&size, 1, MPI_INT, 0, MPI_COMM_WORLD);
  std::string heard = text;
  heard.resize(size);
  MPI_Bcast(heard.data(), size, MPI_CHAR, 0, MPI_COMM_WORLD);
  return heard;
}

std::vector<std::vector<int>> Ranks::traded(const std::vector<std::vector<int>>& lists) const {
  if (alone()) return lists;
  std::vector<int> sent(size_), got(size_), sent_at(size_ + 1), got_at(size_ + 1), out;
  for (int r = 0; r < size_; ++r) {
    sent[r] = static_cast<int>(lists[r].size());
    sent_at[r + 1] = sent_at[r] + sent[r];
    out.insert(out.end(), lists[r].begin(), lists[r].end());
  }
  const Exchange counted = Exchange::of_all((size_ - 1) * sizeof(int));
  MPI_Alltoall(sent.data(), 1, MPI_INT, got.data(), 1, MPI_INT, MPI_COMM_WORLD);
  for (int r = 0; r < size_; ++r) got_at[r + 1] = got_at[r] + got[r];
  std::vector<int> in(got_at[size_]);
  const Exchange also = Exchange::of_all(in.size() * sizeof(int));
  MPI_Alltoallv(out.data(), sent.data(), sent_at.data(), MPI_INT, in.data(), got.data(), got_at.data(), MPI_INT,
                MPI_COMM_WORLD);
  std::vector<std::vector<int>> heard(size_);
  for (int r = 0; r < size_; ++r) heard[r].assign(in.begin() + got_at[r], in.begin() + got_at[r + 1]);
  return heard;
}

void Ranks::complete(const Owners& owners, void* values, std::size_t item) const {
  char* const bytes = static_cast<char*>(values);
  if constexpr (runs_on_host) return complete_on_host(owners, bytes, item);
  using Bytes = Kokkos::View<char*, Exec::memory_space, Kokkos::MemoryUnmanaged>;
  using BytesOnHost = Kokkos::View<char*, Kokkos::HostSpace, Kokkos::MemoryUnmanaged>;
  std::vector<char> copy(end_of(owners) * item);
  Kokkos::deep_copy(BytesOnHost(copy.data(), copy.size()), Bytes(bytes, copy.size()));
  complete_on_host(owners, copy.data(), item);
  Kokkos::deep_copy(Bytes(bytes, copy.size()), BytesOnHost(copy.data(), copy.size()));
}

namespace {

/// Calls visit(first, last) for the parts of ascending runs that lie in [first, last).
template <class Visit>
void visit_within(const Runs& runs, int first, int last, const Visit& visit) {
  auto run = std::partition_point(runs.begin(), runs.end(), [&](const auto& r) { return r.second <= first; });
  for (; run != runs.end() && run->first < last; ++run) visit(std::max(run->first, first), std::min(run->second, last));
}

int count_within(const Runs& runs, int first, int last) {
  int count = 0;
  visit_within(runs, first, last, [&](int from, int to) { count += to - from; });
  return count;
}

/// The items of runs within [first, last), one after the other.
std::vector<char> packed(const Runs& runs, int first, int last, std::size_t item, const char* items) {
  std::vector<char> out(count_within(runs, first, last) * item);
  char* to = out.data();
  visit_within(runs, first, last, [&](int from, int end) {
    std::memcpy(to, items + (from - first) * item, (end - from) * item);
    to += (end - from) * item;
  });
  return out;
}

void unpack(const char* from, const Runs& runs, int first, int last, std::size_t item, char* items) {
  visit_within(runs, first, last, [&](int at, int end) {
    std::memcpy(items + (at - first) * item, from, (end - at) * item);
    from += (end - at) * item;
  });
}

constexpr int tag_of_pieces = 1;  // halos use another

/// So many bytes as one: an int counts items, of whose bytes there may be more.
class ItemType {
 public:
  explicit ItemType(std::size_t bytes) {
    MPI_Type_contiguous(static_cast<int>(bytes), MPI_BYTE, &type_);
    MPI_Type_commit(&type_);
  }
  ItemType(const ItemType&) = delete;
  ItemType& operator=(const ItemType&) = delete;
  ~ItemType() { MPI_Type_free(&type_); }
  MPI_Datatype get() const { return type_; }

 private:
  MPI_Datatype type_;
};

}  // namespace

void Ranks::complete_on_host(const Owners& owners, char* bytes, std::size_t item) const {
  const int end = static_cast<int>(end_of(owners));
  std::vector<int> count(size_), at(size_ + 1);
  for (int r = 0; r < size_; ++r) {
    count[r] = count_within(owners[r], 0, end);
    at[r + 1] = at[r] + count[r];
  }
  const std::vector<char> own = packed(owners[rank_], 0, end, item, bytes);
  std::vector<char> whole(at[size_] * item);
  const Exchange counted = Exchange::of_all((at[size_] - count[rank_]) * item);
  const ItemType type(item);
  MPI_Allgatherv(own.data(), count[rank_], type.get(), whole.data(), count.data(), at.data(), type.get(),
                 MPI_COMM_WORLD);
  for (int r = 0; r < size_; ++r)
    if (r != rank_) unpack(whole.data() + at[r] * item, owners[r], 0, end, item, bytes);
}

void Ranks::bring(const Owners& owners, int first, int last, std::size_t item, const void* own, void* whole) const {
  if (alone()) return;
  const ItemType type(item);
  if (rank_ > 0) {
    const std::vector<char> sent = packed(owners[rank_], first, last, item, static_cast<const char*>(own));
    const Exchange counted = Exchange::of_neighbours(0, 0);
    const int items = static_cast<int>(sent.size() / item);
    if (items > 0) MPI_Send(sent.data(), items, type.get(), 0, tag_of_pieces, MPI_COMM_WORLD);
    return;
  }
  for (int r = 1; r < size_; ++r) {
    const int items = count_within(owners[r], first, last);
    if (items == 0) continue;
    std::vector<char> got(items * item);
    const Exchange counted = Exchange::of_neighbours(1, static_cast<std::int64_t>(got.size()));
    MPI_Recv(got.data(), items, type.get(), r, tag_of_pieces, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    unpack(got.data(), owners[r], first, last, item, static_cast<char*>(whole));
  }
}

#else

int Ranks::most(int value) const {
  return value;
}
double Ranks::most(double value) const {
  return value;
}
std::string Ranks::told(const std::string& text) const {
  return text;
}
std::vector<std::vector<int>> Ranks::traded(const std::vector<std::vector<int>>& lists) const {
  return lists;
}
void Ranks::complete(const Owners&, void*, std::size_t) const {}
void Ranks::bring(const Owners&, int, int, std::size_t, const void*, void*) const {}

#endif

}  // namespace vug
