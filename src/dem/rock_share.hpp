#pragma once
// Sharing the motion of a rock that every process holds completely (docs/scaling.md).
#include "dem/contacts.hpp"
#include "dem/mass_loss.hpp"
#include "dem/rest.hpp"
#include "ranks/halo.hpp"

#include <array>

namespace vug {

/// Each rank moves consecutive groups of triangles, evaluates every bond and pair that has one of them at an end, and
/// receives the motion of the triangles at the other ends. What two ranks evaluate gets the same bits on both, so both
/// know damage, cracks and friction of a bond between them. Everything else about the others' rock is outdated until it
/// is made whole. Functions that wait for other ranks must be called by all ranks.
class RockShare {
 public:
  /// Takes the Views of a rock, which must stay where they are in memory.
  RockShare(const Ranks& ranks, Particles particles, Bonds bonds, Contacts contacts);

  /// Whether this rank moves the particle.
  bool moves(int particle) const { return owner_[particle] == ranks_.rank(); }
  /// Groups that run here when nothing sleeps.
  const Groups& particles() const { return particle_groups_; }
  const Groups& bonds() const { return bond_groups_; }
  const Groups& pairs() const { return pair_groups_; }

  /// Marks the known pairs as outdated.
  void forget_pairs() { generation_ = -1; }
  /// Determines what runs here and whose motion is needed, if pairs have changed; then it waits for the other ranks.
  void follow_pairs(const Exec& exec);
  /// Gets the motion of the others' triangles that is needed here.
  void exchange_motion(const Exec& exec) const { motion_.exchange<double, 8>(exec, moving_); }
  /// Tells all ranks which groups rest.
  void tell_rest(const Exec& exec, const Rest& rest) const;
  /// Agrees on whether cracks have changed, and brings to all ranks what a search for pairs reads.
  void prepare_search(const Exec& exec) const;
  /// Brings positions and damage to all ranks.
  void make_positions_whole(const Exec& exec) const;
  /// Brings everything that a checkpoint or a sum may read to all ranks.
  void make_whole(const Exec& exec, const MassLoss& loss) const;

 private:
  Owners of_pairs(int generation) const;
  void agree_on_events() const;
  /// The same for all columns of a View (item, ...).
  template <class V>
  void make_whole(const Owners& owners, const V& view) const;

  Ranks ranks_;
  Particles particles_;
  Bonds bonds_;
  Contacts contacts_;
  std::vector<int> owner_;  ///< (particle)
  Owners of_particles_, of_groups_, of_bonds_;
  Groups particle_groups_, bond_groups_, pair_groups_;
  std::array<ScalarField<double>, 8> moving_;
  Halo motion_;
  int generation_ = -1;  ///< of the pairs that are known
};

}  // namespace vug
