#pragma once
// What dissolution takes from triangles and bonds.
#include "coupling/rock_map.hpp"

namespace vug {

/// share(g) = dissolved volume of the nodes of group g over its initial solid volume, between 0 and 1; 0 for a group
/// that held no solid. For bonds this is d_c = 1 - m_c / m_c0 (Eq. 25): solid that an opening crack hands to other
/// nodes is not dissolved and does not count. dissolved: (dense node), initial: (group), in pixels.
void dissolved_share(const Exec& exec, const Groups& groups, const ScalarField<double>& dissolved,
                     const ScalarField<double>& initial, const ScalarField<double>& share);

/// sum(g) = sum of `values` over the nodes of group g.
void sum_over_nodes(const Exec& exec, const Groups& groups, const ScalarField<double>& values,
                    const ScalarField<double>& sum);

/// remaining(g) = 1 - share(g).
void remaining_share(const Exec& exec, const ScalarField<double>& share, const ScalarField<double>& remaining);

}  // namespace vug
