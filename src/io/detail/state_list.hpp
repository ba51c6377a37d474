#pragma once
// Bodies of StateList's templates.
#include "kernels/require.hpp"

#include <cstring>
#include <type_traits>

namespace vug {

namespace detail {
inline void require_size(const std::string& name, std::size_t found, std::size_t expected) {
  if (found != expected)
    throw FileError("checkpoint block '" + name + "' has " + std::to_string(found) + " bytes, expected " +
                    std::to_string(expected));
}
}  // namespace detail

template <class ViewType>
void StateList::add(std::string name, ViewType view) {
  using Value = typename ViewType::non_const_value_type;
  static_assert(std::is_trivially_copyable_v<Value>);
  const std::size_t bytes = view.span() * sizeof(Value);
  add(StateBlock{name,
                 [view, bytes] {
                   const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, view);
                   std::vector<std::byte> out(bytes);
                   if (bytes > 0) std::memcpy(out.data(), host.data(), bytes);
                   return out;
                 },
                 [view, bytes, name](std::span<const std::byte> in) {
                   detail::require_size(name, in.size(), bytes);
                   const auto host = Kokkos::create_mirror_view(view);
                   if (bytes > 0) std::memcpy(host.data(), in.data(), bytes);
                   Kokkos::deep_copy(view, host);
                 }});
}

template <class Value>
void StateList::add_value(std::string name, Value& value) {
  static_assert(std::is_trivially_copyable_v<Value>);
  add(StateBlock{name,
                 [&value] {
                   std::vector<std::byte> out(sizeof(Value));
                   std::memcpy(out.data(), &value, sizeof(Value));
                   return out;
                 },
                 [&value, name](std::span<const std::byte> in) {
                   detail::require_size(name, in.size(), sizeof(Value));
                   std::memcpy(&value, in.data(), sizeof(Value));
                 }});
}

}  // namespace vug
