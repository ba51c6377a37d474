#pragma once
// The links of a boundary whose outgoing populations a condition overwrites, of flow and solutes alike.
#include "kernels/nodes/fluid_nodes.hpp"

namespace vug {

/// As kernels see them; holds no View: what it was made from must outlive its use.
struct DressedLinks {
  int count = 0;                            ///< links
  int own_count = 0;                        ///< of them, that this process dresses
  const int* own = nullptr;                 ///< (own) their numbers; null: all
  const int* fluid = nullptr;               ///< (link) fluid index
  const std::uint8_t* direction = nullptr;  ///< (link)
  double* gain = nullptr;                   ///< (link) gains what entered minus what left

  DressedLinks() = default;
  DressedLinks(const BoundaryLinks& links, const ScalarField<double>& gain_)
      : count(links.count),
        own_count(links.own_count < 0 ? count : links.own_count),
        own(links.own_count < 0 ? nullptr : links.own.data()),
        fluid(links.fluid.data()),
        direction(links.direction.data()),
        gain(gain_.data()) {}
  /// This process dresses all links.
  void take_all() {
    own_count = count;
    own = nullptr;
  }
  /// The number of an own link.
  KOKKOS_FORCEINLINE_FUNCTION int link(int item) const { return own ? own[item] : item; }
};

/// What comes in by a rule, in the slot of the outgoing population of each link. Touches one population and 21 bytes of
/// lists and ledger per link.
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
