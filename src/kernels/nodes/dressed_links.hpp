#pragma once
// The links of a boundary whose outgoing populations a condition overwrites; the same for flow and solutes.
#include "kernels/nodes/fluid_nodes.hpp"

namespace vug {

/// The links in the form that kernels take. Holds pointers instead of Views: the Views that it was made from must
/// outlive it.
struct DressedLinks {
  int count = 0;                            ///< links
  int own_count = 0;                        ///< links that this process dresses
  const int* own = nullptr;                 ///< (own) numbers of these links; null: all
  const int* fluid = nullptr;               ///< (link) fluid index
  const std::uint8_t* direction = nullptr;  ///< (link)
  double* gain = nullptr;                   ///< (link) what entered minus what left is added to it

  DressedLinks() = default;
  DressedLinks(const BoundaryLinks& links, const ScalarField<double>& gain_)
      : count(links.count),
        own_count(links.own_count < 0 ? count : links.own_count),
        own(links.own_count < 0 ? nullptr : links.own.data()),
        fluid(links.fluid.data()),
        direction(links.direction.data()),
        gain(gain_.data()) {}
  /// Makes this process dress all links.
  void take_all() {
    own_count = count;
    own = nullptr;
  }
  /// Number of the link of an own item.
  KOKKOS_FORCEINLINE_FUNCTION int link(int item) const { return own ? own[item] : item; }
};

/// Overwrites the outgoing population of each link with the incoming one, which follows from a rule. Touches one
/// population and 21 bytes of lists and ledger per link.
template <class T, class Rule>
struct DressLinks {
  DressedLinks links;
  T* f;  ///< populations
  int capacity;
  Rule rule;
  KOKKOS_FUNCTION void operator()(int item) const {
    const int link = links.link(item), i = links.fluid[link], q = links.direction[link];
    const T outgoing = f[q * capacity + i];
    const T incoming = rule(link, i, q, outgoing);
    f[q * capacity + i] = incoming;
    links.gain[link] += double(incoming) - double(outgoing);
  }
};

}  // namespace vug
