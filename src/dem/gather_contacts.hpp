#pragma once
// Sum of the contacts of a particle.
#include "dem/contacts.hpp"

namespace vug {

/// Sums a particle's contacts in the order of its row, either the loads or the part of the dashpots in them.
struct GatherContacts {
  IndexList events;      ///< of Bonds
  IndexList row, entry;  ///< of Contacts
  Kokkos::View<double* [4], Kokkos::LayoutLeft> load;
  Kokkos::View<double* [3], Kokkos::LayoutLeft> push;
  KOKKOS_FUNCTION void operator()(int i) const {
    if (events(bond_has_failed) == 0) return;
    double x = 0, y = 0, torque = 0;
    for (int e = row(i); e < row(i + 1); ++e) {
      const int k = entry(e) / 2, end = entry(e) % 2;
      const double sign = end == 0 ? 1 : -1;
      x += sign * load(k, 0);
      y += sign * load(k, 1);
      torque += load(k, 2 + end);
    }
    push(i, 0) = x;
    push(i, 1) = y;
    push(i, 2) = torque;
  }
};

/// Functor that sums the loads themselves.
inline GatherContacts gather_loads(const Bonds& bonds, const Contacts& contacts) {
  return {bonds.events, contacts.row, contacts.entry, contacts.load, contacts.push};
}

}  // namespace vug
