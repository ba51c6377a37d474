// Heat at openings, as heat_boundary.hpp says.
#include "kernels/heat/heat_boundary.hpp"
#include "kernels/heat/heat_conditions.hpp"
#include "kernels/launch/launch_lists.hpp"
#include "kernels/launch/row_launch.hpp"

#include <type_traits>

namespace vug {

/// Writes what arrives through one link out of an opening into the opening's node and books the energy it brings in.
template <class T, class Law, class Links>
struct FillOpening {
  using Set = typename Links::Set;
  Law law;
  OpeningEntry opening;
  Links links;
  Rows rows;
  KOKKOS_FUNCTION void operator()(int item) const {
    const int n = opening.node[item], q = opening.direction[item], plane = links.around.lattice.size();
    if (const int row = links.around.lattice.y(n) - rows.first; row < 0 || row >= rows.count) return;
    const T leaving = links.g(q * plane + n);
    const T arriving = links.arriving(law, n, q, leaving, static_cast<T>(opening.area[item]), false);
    links.g(Set::opposite(q) * plane + opening.beyond[item]) = arriving;
    opening.entered[item] += links.kinds.capacity(n) * (static_cast<double>(arriving) - static_cast<double>(leaving));
  }
};

/// All openings, each by its law.
template <class T, class Links>
struct FillOpenings {
  Links links;
  double capacity_ratio;
  Rows rows;

  using Entry = OpeningEntry;
  static int count(const HeatOpening& opening) { return opening.links.count; }
  Entry entry(const HeatOpening& opening) const {
    const DenseLinks& of = opening.links;
    return {condition_of(opening, capacity_ratio), of.node.data(), of.beyond.data(), of.direction.data(),
            of.area.data()};
  }
  template <class Run>
  KOKKOS_FUNCTION void operator()(const Entry& e, const Run& run) const {
    e.template visit<T>(links.rounding, [&](const auto& law) {
      run(FillOpening<T, std::decay_t<decltype(law)>, Links>{law, e, links, rows});
    });
  }
};

template <class T>
void fill_heat_openings(const Exec& exec, const HeatFields<T>& fields, std::span<const HeatOpening> openings,
                        const std::type_identity_t<HeatCrossing<T>>& crossing) {
  visit_links(fields, crossing, [&](const auto& links) {
    for_each_of_lists(exec, "vug::heat::fill_opening", openings,
                      FillOpenings<T, std::decay_t<decltype(links)>>{
                          links, fields.rates.capacity_ratio, {fields.first_row, fields.rows}});
  });
}

template <class T>
HeatOpening make_heat_opening(const Exec& exec, const HeatFields<T>& fields, const Kokkos::View<NodeType*>& type,
                              std::array<bool, 2> periodic, const Opening& opening, HeatCondition condition,
                              double value) {
  const int directions = visit_velocity_set(fields.velocity_set, [](auto set) { return decltype(set)::Q; });
  HeatOpening made{
      find_dense_opening_links(exec, fields.lattice, periodic, type, opening, directions), condition, value, {}, 0};
  made.energy_in = ScalarField<double>("vug::heat::energy_in", made.links.count);
  return made;
}

VUG_COMPILE_FOR_NUMBERS(fill_heat_openings)
VUG_COMPILE_FOR_NUMBERS(make_heat_opening)

}  // namespace vug
