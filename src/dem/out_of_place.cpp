#include "dem/out_of_place.hpp"

namespace vug {

namespace {

struct CountOutOfPlace {
  Particles p;
  IndexList loose;
  KOKKOS_FUNCTION void operator()(int i, int& count) const {
    const bool stays = loose.extent(0) == 0 || loose(i) < 0;
    count += stays && !is_gone(p.solid_fraction(i)) && is_out_of_place(p, i);
  }
};

}  // namespace

int count_out_of_place(const Exec& exec, const Particles& particles, const IndexList& loose) {
  int count = 0;
  Kokkos::parallel_reduce("vug::dem::count_out_of_place", Kokkos::RangePolicy<Exec>(exec, 0, particles.count),
                          CountOutOfPlace{particles, loose}, count);
  return count;
}

}  // namespace vug
