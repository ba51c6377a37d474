#include "dem/static_equilibrium.hpp"

#include "dem/bond_elasticity.hpp"
#include "dem/bond_kinematics.hpp"
#include "dem/forces.hpp"
#include "dem/gather_contacts.hpp"
#include "dem/linear_rock.hpp"
#include "dem/monitors.hpp"
#include "dem/push.hpp"
#include "kernels/launch/launch.hpp"
#include "ranks/stop.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace vug {

namespace {

constexpr double balanced = 1e-11;         // largest force left over the largest load
constexpr int most_solves = 40;            // per increment; without sliding it takes three
constexpr int increments_with_cracks = 8;  // friction depends on the path of the loads
constexpr double long_time = 1e9;          // s that an increment takes, so that no dashpot acts

using ForceField = Kokkos::View<double* [3], Kokkos::LayoutLeft>;
/// A separate copy on the host, which shares no memory with the view.
template <class ViewType>
typename ViewType::host_mirror_type host_copy(const ViewType& view) {
  typename ViewType::host_mirror_type copy = Kokkos::create_mirror(view);
  Kokkos::deep_copy(copy, view);
  return copy;
}

/// Force and torque on each particle that are not balanced; stores the force that holds a held axis in `reaction`.
struct Imbalance {
  ParticlePush push;
  ForceField force;
  KOKKOS_FUNCTION void operator()(int i) const {
    const Push all = push.total(i, push.outside(i));
    force(i, 0) = all.x;
    force(i, 1) = all.y;
    force(i, 2) = all.torque;
    push.hold(i, all);
  }
};

/// Current stiffness of both points of a bond: no normal one where a crack is open, no tangential one where it is open
/// or slides.
struct PointStiffness {
  BondParameters rock;
  double failure_at, expansion;
  Particles particles;
  Bonds bonds;
  Kokkos::View<double* [2], Kokkos::LayoutLeft> slip_before;
  StiffnessField stiffness;
  KOKKOS_FUNCTION void operator()(int k) const {
    const BondParameters law = law_of(rock, bonds.elasticity, k);
    const bool crack = has_failed(bonds.state(k));
    const double left = 1 - Kokkos::min(bonds.d_c(k), failure_at);
    const double area = 0.5 * bonds.length(k) * left / (law.length_factor * bonds.spacing(k));
    const BondMotion motion = motion_of_bond(particles, bonds, expansion, k);
    for (int s = 0; s < 2; ++s) {
      const bool gapes = crack && (bonds.joint(k) == faces_apart || motion.opening[s].delta_n > 0);
      const bool slides = crack && bonds.slip(k, s) != slip_before(k, s);
      const double undamaged = 1 - bonds.point_damage(k, s);
      const double normal = crack || motion.opening[s].delta_n < 0 ? 1 : undamaged;
      stiffness(k, s, 0) = gapes ? 0 : area * normal * law.normal_modulus;
      stiffness(k, s, 1) = gapes || slides ? 0 : area * (crack ? 1 : undamaged) * law.tangential_modulus;
    }
  }
};

/// One search; the members are what its steps share.
class Search {
 public:
  Search(const Exec& exec, const MechanicsParameters& parameters, const NeighbourGrid& grid, const BoundaryLoads& loads,
         const Particles& particles, const Bonds& bonds, const Contacts& contacts, const Ranks& ranks)
      : exec_(exec),
        parameters_(parameters),
        grid_(grid),
        loads_(loads),
        particles_(particles),
        bonds_(bonds),
        contacts_(contacts),
        ranks_(ranks),
        linear_(particles, bonds),
        force_("vug::dem::imbalance", particles.count),
        stiffness_("vug::dem::point_stiffness", bonds.count),
        slip_("vug::dem::slip_before", bonds.count),
        stretch_("vug::dem::stretch_before", contacts.stretch.extent(0)) {}

  bool operator()() {
    const BondCounts bonds = count_bonds(bonds_);
    const int increments = bonds.failed() + bonds.cracked_at_start > 0 ? increments_with_cracks : 1;
    bool found = linear_.rows() > 0;
    for (int n = 1; n <= increments && found; ++n) found = settle(static_cast<double>(n) / increments);
    Kokkos::deep_copy(exec_, particles_.v, 0.0);
    Kokkos::deep_copy(exec_, particles_.spin, 0.0);
    found = found && nothing_else_touches();
    exec_.fence("vug::dem::static_equilibrium");
    return found;
  }

 private:
  /// Newton's method for one increment of the loads.
  bool settle(double load_factor) {
    update_contacts(exec_, grid_, particles_, bonds_, contacts_);
    Kokkos::deep_copy(exec_, slip_, bonds_.slip);
    Kokkos::deep_copy(exec_, stretch_, contacts_.stretch);
    start();
    moved_ = Eigen::VectorXd::Zero(linear_.rows());
    for (int solve = 0; solve <= most_solves; ++solve) {
      throw_if_any_is_to_stop(ranks_);
      const Eigen::VectorXd left = imbalance(load_factor);
      if (solve == 0) load_ = std::max(load_, largest_);
      if (!std::isfinite(largest_)) return false;
      if (in_balance()) return true;
      if (!factorise()) return false;
      moved_ += linear_.solve(left);
      move();
    }
    return false;
  }

  bool in_balance() const { return largest_ <= std::max(balanced * load_, rounding()); }

  /// Whether the balance still holds with the pairs that have come near in the last increment and were not listed in
  /// it.
  bool nothing_else_touches() {
    const auto list = [&] { return on_host(contacts_.status)(contacts_generation); };
    const int before = list();
    update_contacts(exec_, grid_, particles_, bonds_, contacts_);
    if (list() == before) return true;
    Kokkos::deep_copy(exec_, stretch_, contacts_.stretch);
    imbalance(1);
    return in_balance();
  }

  /// Rounding error of forces that are differences of displacements; it matters where a slender beam moves far under a
  /// small load.
  double rounding() const {
    if (factored_.empty()) return 0;
    constexpr double digits = 16 * std::numeric_limits<double>::epsilon();
    return digits * *std::max_element(factored_.begin(), factored_.end()) * moved_.lpNorm<Eigen::Infinity>();
  }

  /// Force and torque on the free components that are not balanced; stores the largest, with torques divided by the
  /// particles' size.
  Eigen::VectorXd imbalance(double load_factor) {
    Kokkos::deep_copy(exec_, bonds_.slip, slip_);
    Kokkos::deep_copy(exec_, contacts_.stretch, stretch_);
    compute_forces(exec_, parameters_, long_time, particles_, bonds_, contacts_, NoAccounts{});
    for_each_node(exec_, "vug::dem::gather_contacts", particles_.count, gather_loads(bonds_, contacts_));
    for_each_node(exec_, "vug::dem::imbalance", particles_.count,
                  Imbalance{particle_push(load_factor, 0, bonds_, contacts_, loads_, particles_), force_});
    const auto force = on_host(force_);
    Eigen::VectorXd left(linear_.rows());
    largest_ = 0;
    for (int i = 0; i < particles_.count; ++i)
      for (int c = 0; c < 3; ++c) {
        const int row = linear_.row(i, c);
        if (row < 0) continue;
        left[row] = force(i, c);
        largest_ = std::max(largest_, std::abs(force(i, c)) / (c < 2 ? 1 : grid_.reach));
      }
    return left;
  }

  /// Factorises again only where a crack has opened or closed, or has started or stopped sliding.
  bool factorise() {
    for_each_node(exec_, "vug::dem::point_stiffness", bonds_.count,
                  PointStiffness{parameters_.bond, parameters_.chemical.failure_at, parameters_.thermal_expansion,
                                 particles_, bonds_, slip_, stiffness_});
    const auto now = on_host(stiffness_);
    const std::vector<double> values(now.data(), now.data() + now.size());
    if (values == factored_) return true;
    factored_ = values;
    return linear_.factorise(now);
  }

  /// Stores the positions at the start of the increment.
  void start() {
    u_ = host_copy(particles_.u);
    angle_ = host_copy(particles_.angle);
  }

  /// Moves all particles by `moved_` from the start of the increment, with the velocities that do so in a long time.
  void move() {
    const HostWriter u(particles_.u), v(particles_.v), rotation(particles_.rotation);
    const HostWriter angle(particles_.angle), spin(particles_.spin);
    for (int i = 0; i < particles_.count; ++i) {
      const auto by = [&](int c) { return linear_.row(i, c) < 0 ? 0.0 : moved_[linear_.row(i, c)]; };
      for (int c = 0; c < 2; ++c) {
        u(i, c) = u_(i, c) + by(c);
        v(i, c) = by(c) / long_time;
      }
      angle(i) = angle_(i) + by(2);
      spin(i) = by(2) / long_time;
      const Rotation turned = Rotation::by(angle(i));
      rotation(i, 0) = turned.cos_minus_1;
      rotation(i, 1) = turned.sin;
    }
  }

  Exec exec_;
  MechanicsParameters parameters_;
  NeighbourGrid grid_;
  BoundaryLoads loads_;
  Particles particles_;
  Bonds bonds_;
  Contacts contacts_;
  Ranks ranks_;
  LinearRock linear_;
  ForceField force_;
  StiffnessField stiffness_;
  Kokkos::View<double* [2], Kokkos::LayoutLeft> slip_;
  decltype(Contacts::stretch) stretch_;
  VectorField<double>::host_mirror_type u_;      ///< at the start of the increment
  ScalarField<double>::host_mirror_type angle_;  ///< likewise
  Eigen::VectorXd moved_;                        ///< displacements since then, of the free components
  std::vector<double> factored_;                 ///< the stiffnesses that linear_ was factorised with
  double load_ = 0, largest_ = 0;                ///< largest load and imbalance, N
};

}  // namespace

bool find_static_equilibrium(const Exec& exec, const MechanicsParameters& parameters, const NeighbourGrid& grid,
                             const BoundaryLoads& loads, const Particles& particles, const Bonds& bonds,
                             const Contacts& contacts, const Ranks& ranks) {
  return Search(exec, parameters, grid, loads, particles, bonds, contacts, ranks)();
}

}  // namespace vug
