#pragma once
// The passages that fluid crosses between a mouth and an outlet, on the host.
#include "coupling/mouths.hpp"
#include "coupling/pore_width.hpp"

#include <vector>

namespace vug {

/// The largest speed in passages of so many nodes side by side, over the volume that crosses them all in a step,
/// 2 max(n^2)/sum(n^3), 1/cells. Between the same two pressures a slit of n cells carries a volume in proportion to n^3
/// (Poiseuille). Its largest speed is 1.5 times its mean; behind a sharp edge that of a free jet is (pi + 2)/pi = 1.64
/// times the mean in the opening (Kirchhoff), and more with a parabola before it: 2 is above all of them.
double peak_of_passages(const std::vector<int>& nodes);

/// What is given at the nodes, and where fluid passes as the pressure wants it.
struct Ways {
  std::vector<double> given;  ///< (node) volume that enters per step, cells
  std::vector<bool> yields;   ///< (node)
};

/// What fluid meets on its way through the passages behind a mouth, lattice units.
struct Passage {
  double speed = 0;     ///< largest mean in a front
  double peak = 0;      ///< upper bound, of most flows, of the largest
  double pressure = 0;  ///< that it needs, over the viscosity; a lower bound
  double delay = 0;     ///< steps in which pressure spreads along it, over viscosity
};

/// Goes through the fronts of nodes at one distance after the other from `begin`, up to the first with a node that
/// yields; where none does, up to the last at which something is given. Beside nodes that yield, `beyond` is what is
/// given in all of their piece of pore space, and the way goes on to the last of these.
///
/// By continuity all that is given within a front, and nothing else, crosses it (less `beyond`). The nodes of a front
/// that are neighbours are one passage (`peak`; where no no-slip wall is beside a front, its speed is the same
/// everywhere). Passages that lead nowhere else are dead ends and only store. A passage of n nodes carries what a slit
/// of n cells does, n^3/12 per pressure gradient; where only one of its nodes is beside a no-slip wall, what a layer
/// with one wall does, n^3/3; without such nodes, all. The drag of a front is that of its passages side by side, and a
/// lower bound, because they may be wound or share what they carry otherwise. Each node stores 1/c_s^2 of the pressure;
/// the delay ends where the way does, or at the first front where the other sign is given.
Passage find_passage(const NoSlipWalls& walls, const FluidPicture& picture, const std::vector<std::size_t>& begin,
                     const Ways& ways, double beyond = 0);

}  // namespace vug
