#pragma once
// How processes share the motion of a rock that all of them hold (docs/scaling.md).
#include "dem/contacts.hpp"
#include "dem/mass_loss.hpp"
#include "dem/rest.hpp"
#include "ranks/halo.hpp"

#include <array>

namespace vug {

/// Each rank moves groups of triangles that follow one another, evaluates every bond and pair that has one of them at
/// an end, and is told how the triangles at the other ends move. What two ranks evaluate both get the same bits:
/// damage, cracks and friction of a bond between them are known to both. Everything else about the others' rock is old
/// until it is made whole. What waits for others is called by all ranks.
class RockShare {
 public:
  /// The Views of a rock that stays where it is in memory.
  RockShare(const Ranks& ranks, Particles particles, Bonds bonds, Contacts contacts);

  /// Whether this rank moves a particle.
  bool moves(int particle) const { return owner_[particle] == ranks_.rank(); }
  /// What runs here when nothing sleeps.
  const Groups& particles() const { return particle_groups_; }
  const Groups& bonds() const { return bond_groups_; }
  const Groups& pairs() const { return pair_groups_; }

  /// The pairs are others than those that were known.
  void forget_pairs() { generation_ = -1; }
  /// Finds out what runs here and whose motion is needed, if pairs have changed. Waits for the others then.
  void follow_pairs(const Exec& exec);
  /// Brings the motion of the others' triangles here.
  void exchange_motion(const Exec& exec) const { motion_.exchange<double, 8>(exec, moving_); }
  /// Brings which groups rest to all.
  void tell_rest(const Exec& exec, const Rest& rest) const;
  /// Agrees on whether cracks have changed, and brings what a search for pairs reads to all.
  void prepare_search(const Exec& exec) const;
  /// Brings positions and damage to all.
  void make_positions_whole(const Exec& exec) const;
  /// Brings everything that a checkpoint or a sum may read to all.
  void make_whole(const Exec& exec, const MassLoss& loss) const;

 private:
  Owners of_pairs(int generation) const;
  void agree_on_events() const;
  /// All columns of (item, ...).
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
