#include "dem/out_of_place.hpp"

namespace vug {

namespace {

struct CountOutOfPlace {
  Particles p;
  Bonds bonds;
  bool but_fragments;
  KOKKOS_FUNCTION void operator()(int i, int& count) const {
    if (is_gone(p.solid_fraction(i)) || !is_out_of_place(p, i)) return;
    if (!but_fragments || !nothing_holds(p, bonds, i)) ++count;
  }
};

}  // namespace

int count_out_of_place(const Exec& exec, const Particles& particles, const Bonds& bonds, bool but_fragments) {
  int count = 0;
  Kokkos::parallel_reduce("vug::dem::count_out_of_place", Kokkos::RangePolicy<Exec>(exec, 0, particles.count),
                          CountOutOfPlace{particles, bonds, but_fragments}, count);
  return count;
}

}  // namespace vug
