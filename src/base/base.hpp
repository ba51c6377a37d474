#pragma once
// Types that every layer uses: where kernels run and how fields are stored.
#include <Kokkos_Core.hpp>

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace vug {

using Exec = Kokkos::DefaultExecutionSpace;

/// True where the host itself runs the kernels; false where it can only read what a GPU writes (unified memory).
inline constexpr bool shares_host_memory = std::is_same_v<Exec, Kokkos::DefaultHostExecutionSpace>;

/// True where kernels are compiled in their form for a host, whose loops over nodes must vectorise. A build with
/// VUG_DEVICE_PATH uses the form for a GPU everywhere, so that it can be tested on every machine.
#ifdef VUG_DEVICE_PATH
inline constexpr bool runs_on_host = false;
#else
inline constexpr bool runs_on_host = shares_host_memory;
#endif

template <class T>
using ScalarField = Kokkos::View<T*>;  ///< (item)
template <class T>
using VectorField = Kokkos::View<T* [2], Kokkos::LayoutLeft>;  ///< (item, axis), each component contiguous
using IndexList = Kokkos::View<int*>;                          ///< (item)

/// A new View (entry) on the device with the entries of `values`.
template <class ViewType>
ViewType to_device(const std::string& label, const std::vector<typename ViewType::non_const_value_type>& values) {
  using Host = Kokkos::View<const typename ViewType::non_const_value_type*, Kokkos::HostSpace, Kokkos::MemoryUnmanaged>;
  ViewType view(label, values.size());
  Kokkos::deep_copy(view, Host(values.data(), values.size()));
  return view;
}

/// The content of a View for reading on the host: the View itself where it is in host memory, else a copy made now.
template <class ViewType>
auto on_host(const ViewType& view) {
  return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, view);
}

/// The type of that.
template <class ViewType>
using OnHost = decltype(on_host(std::declval<const ViewType&>()));

/// Makes `view` one of so many items, all zero.
template <class ViewType>
void make_zeros(ViewType& view, const std::string& label, int count) {
  view = ViewType(label, count);
}

/// Writes the entries of a View on the host: those of the View itself where kernels run on the host, else those of a
/// mirror, zeros at first, which is copied to the View, after all kernels, when the writer goes out of scope. The
/// memory of a GPU that the host may touch has a mirror, too: kernels may be using it.
template <class ViewType>
class HostWriter {
 public:
  explicit HostWriter(const ViewType& view)
      : view_(view), host_(shares_host_memory ? Kokkos::create_mirror_view(view) : Kokkos::create_mirror(view)) {}
  HostWriter(const HostWriter&) = delete;
  ~HostWriter() { Kokkos::deep_copy(view_, host_); }
  template <class... Index>
  decltype(auto) operator()(Index... index) const {
    return host_(index...);
  }

 private:
  ViewType view_;
  typename ViewType::host_mirror_type host_;
};

/// Compiles a function template for these arguments.
#define VUG_COMPILE(...) template decltype(__VA_ARGS__) __VA_ARGS__;
/// The same for both numbers, or for both numbers and velocity sets: name<Set, T>.
#define VUG_COMPILE_FOR_NUMBERS(name) VUG_COMPILE(name<float>) VUG_COMPILE(name<double>)
#define VUG_COMPILE_FOR_SETS(name) \
  VUG_COMPILE(name<D2Q5, float>)   \
  VUG_COMPILE(name<D2Q9, float>) VUG_COMPILE(name<D2Q5, double>) VUG_COMPILE(name<D2Q9, double>)
/// Members of class templates are compiled for these numbers and velocity sets.
#define VUG_FOR_NUMBERS(INSTANTIATE) INSTANTIATE(float) INSTANTIATE(double)
#define VUG_FOR_NUMBERS_AND_SETS(INSTANTIATE) \
  INSTANTIATE(float, D2Q5) INSTANTIATE(float, D2Q9) INSTANTIATE(double, D2Q5) INSTANTIATE(double, D2Q9)

}  // namespace vug
