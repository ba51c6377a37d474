#pragma once
// Definitions of StateList's templates.
#include "base/require.hpp"
#include "io/field_list.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace vug {

namespace detail {
inline void require_size(const std::string& name, std::size_t found, std::size_t expected) {
  if (found != expected)
    throw FileError("checkpoint block '" + name + "' has " + std::to_string(found) + " bytes, expected " +
                    std::to_string(expected));
}

/// The type as which a value is read: an integer for bool and enumerations, for which not every byte is valid.
template <class Value>
struct NumberOf {
  using Type = Value;
};
template <>
struct NumberOf<bool> {
  using Type = std::uint8_t;
};
template <class Value>
requires std::is_enum_v<Value>
struct NumberOf<Value> {
  using Type = std::underlying_type_t<Value>;
};

/// Throws FileError unless all numbers of `in` are finite and in `range`.
template <class Value>
void require_range(const std::string& name, std::span<const std::byte> in, StateRange range) {
  if constexpr (std::is_same_v<Value, bool>) range = {0, 1};
  typename NumberOf<Value>::Type number;
  for (std::size_t at = 0; at < in.size(); at += sizeof(number)) {
    std::memcpy(&number, in.data() + at, sizeof(number));
    const auto value = static_cast<double>(number);
    if (!(value >= range.least && value <= range.most))
      throw FileError("checkpoint block '" + name + "' has the number " + std::to_string(value) + " at place " +
                      std::to_string(at / sizeof(number)) + ", which it cannot have");
  }
}
}  // namespace detail

inline std::vector<std::byte> StateBlock::saved() const {
  std::vector<std::byte> all;
  save([&](std::span<const std::byte> piece) { all.insert(all.end(), piece.begin(), piece.end()); });
  return all;
}

inline void StateBlock::load_all(std::span<const std::byte> all) const {
  detail::require_size(name, all.size(), bytes);
  load([&](std::size_t at, std::span<std::byte> to) { std::copy_n(all.begin() + at, to.size(), to.begin()); });
}

template <class ViewType>
void StateList::add(std::string name, ViewType view, StateRange range) {
  using Value = typename ViewType::non_const_value_type;
  static_assert(std::is_trivially_copyable_v<Value>);
  const auto bytes_of = [](const auto& host) {
    return std::span(reinterpret_cast<std::byte*>(host.data()), host.span() * sizeof(Value));
  };
  add(StateBlock{name, view.span() * sizeof(Value), [=](const TakeBytes& take) { take(bytes_of(on_host(view))); },
                 [=](const GiveBytes& give) {
                   const auto host = Kokkos::create_mirror_view(view);
                   give(0, bytes_of(host));
                   detail::require_range<Value>(name, bytes_of(host), range);
                   Kokkos::deep_copy(view, host);
                 }});
}

template <class Value>
void StateList::add_value(std::string name, Value& value, StateRange range) {
  static_assert(std::is_trivially_copyable_v<Value>);
  add(StateBlock{name, sizeof(Value), [&value](const TakeBytes& take) { take(std::as_bytes(std::span(&value, 1))); },
                 [&value, name, range](const GiveBytes& give) {
                   std::array<std::byte, sizeof(Value)> bytes;
                   give(0, bytes);
                   detail::require_range<Value>(name, bytes, range);
                   std::memcpy(&value, bytes.data(), sizeof(Value));
                 }});
}

}  // namespace vug
