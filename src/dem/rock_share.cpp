#include "dem/rock_share.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>

namespace vug {

namespace {

constexpr int pairs_per_group = bonds_per_group;

Groups groups_of(const char* label, int count, int size) {
  const Kokkos::View<std::uint8_t*> ours(label, (count + size - 1) / size);
  return {count, size, ours, ours};
}

using Marks = std::vector<std::uint8_t>;  ///< (group) 1: runs here

void set_marks(const Kokkos::View<std::uint8_t*>& view, const Marks& marks) {
  Kokkos::deep_copy(view, to_device<Kokkos::View<std::uint8_t*>>("vug::dem::marks", marks));
}

/// Gives every rank an equal share of consecutive whole groups of particles.
std::vector<int> owners_of_groups(const Ranks& ranks, int groups) {
  std::vector<int> owner(groups);
  for (int r = 0; r < ranks.size(); ++r)
    for (int g = begin_of_share(groups, r, ranks.size()); g < begin_of_share(groups, r + 1, ranks.size()); ++g)
      owner[g] = r;
  return owner;
}

/// The items of group g.
std::pair<int, int> items_of(const Groups& groups, int g) {
  return {g * groups.size, std::min((g + 1) * groups.size, groups.count)};
}

}  // namespace

RockShare::RockShare(const Ranks& ranks, Particles particles, Bonds bonds, Contacts contacts)
    : ranks_(ranks),
      particles_(std::move(particles)),
      bonds_(std::move(bonds)),
      contacts_(std::move(contacts)),
      owner_(particles_.count),
      particle_groups_(groups_of("vug::dem::our_particles", particles_.count, particles_per_group)),
      bond_groups_(groups_of("vug::dem::our_bonds", bonds_.count, bonds_per_group)),
      pair_groups_(groups_of("vug::dem::our_pairs", particles_.count, pairs_per_group)) {
  const auto column = [](const VectorField<double>& field, int axis) {
    return Kokkos::subview(field, Kokkos::ALL, axis);
  };
  const Particles& p = particles_;
  moving_ = {column(p.u, 0), column(p.u, 1), column(p.v, 0),        column(p.v, 1),
             p.angle,        p.spin,         column(p.rotation, 0), column(p.rotation, 1)};
  const int groups = static_cast<int>(particle_groups_.ours.extent(0));
  const std::vector<int> owner_of_group = owners_of_groups(ranks_, groups);
  for (int i = 0; i < particles_.count; ++i) owner_[i] = owner_of_group[particle_groups_.group_of(i)];
  const auto pair = on_host(bonds_.pair);
  std::vector<int> owner_of_bond(bonds_.count);
  for (int k = 0; k < bonds_.count; ++k) owner_of_bond[k] = owner_[pair(k, 0)];
  of_groups_ = owners_of(owner_of_group, ranks_.size());
  of_particles_ = owners_of(owner_, ranks_.size());
  of_bonds_ = owners_of(owner_of_bond, ranks_.size());
  Marks ours(groups), ours_of_bonds(bond_groups_.ours.extent(0));
  for (int g = 0; g < groups; ++g) ours[g] = owner_of_group[g] == ranks_.rank();
  for (int k = 0; k < bonds_.count; ++k)
    if (moves(pair(k, 0)) || moves(pair(k, 1))) ours_of_bonds[bond_groups_.group_of(k)] = 1;
  set_marks(particle_groups_.ours, ours);
  set_marks(bond_groups_.ours, ours_of_bonds);
}

/// A group is evaluated as a whole, so everything that its items touch must be known here.
void RockShare::follow_pairs(const Exec& exec) {
  exec.fence("vug::dem::follow_pairs");
  const int generation = on_host(contacts_.status)(contacts_generation);
  if (generation == generation_) return;
  generation_ = generation;
  const auto first_pair = on_host(contacts_.first), other = on_host(contacts_.other);
  const auto first = [&](int low) { return first_pair(low, generation); };
  const auto high = [&](int pair) { return other(pair, generation); };
  Marks marks(pair_groups_.ours.extent(0));
  for (int low = 0; low < particles_.count; ++low) {
    bool ours = moves(low);
    for (int pair = first(low); pair < first(low + 1); ++pair) ours = ours || moves(high(pair));
    if (ours) marks[pair_groups_.group_of(low)] = 1;
  }
  set_marks(pair_groups_.ours, marks);
  std::vector<bool> needed(particles_.count, false);
  const auto for_ours = [](const Groups& groups, const auto& visit) {
    const auto ours = on_host(groups.ours);
    for (int g = 0; g < static_cast<int>(ours.extent(0)); ++g)
      for (auto [item, end] = items_of(groups, g); ours(g) != 0 && item < end; ++item) visit(item);
  };
  const auto ends = on_host(bonds_.pair);
  for_ours(bond_groups_, [&](int k) { needed[ends(k, 0)] = needed[ends(k, 1)] = true; });
  for_ours(pair_groups_, [&](int low) {
    for (int pair = first(low); pair < first(low + 1); ++pair) needed[low] = needed[high(pair)] = true;
  });
  std::vector<int> others, owners;
  for (int i = 0; i < particles_.count; ++i)
    if (needed[i] && !moves(i)) {
      others.push_back(i);
      owners.push_back(owner_[i]);
    }
  motion_ = Halo(ranks_, others, owners);
}

void RockShare::tell_rest(const Exec& exec, const Rest& rest) const {
  exec.fence("vug::dem::tell_rest");
  ranks_.make_whole(of_groups_, rest.particles.runs.data());
}

void RockShare::agree_on_events() const {
  const auto events = on_host(bonds_.events);
  for (const int event : {bond_has_failed, cracks_have_changed}) events(event) = ranks_.most(events(event));
  Kokkos::deep_copy(bonds_.events, events);
}

void RockShare::prepare_search(const Exec& exec) const {
  exec.fence("vug::dem::prepare_search");
  agree_on_events();
  if (on_host(bonds_.events)(bond_has_failed) == 0) return;
  make_positions_whole(exec);
  make_whole(of_bonds_, bonds_.joint);
}

void RockShare::make_positions_whole(const Exec& exec) const {
  exec.fence("vug::dem::make_positions_whole");
  make_whole(of_particles_, particles_.u);
  make_whole(of_particles_, particles_.angle);
  make_whole(of_particles_, particles_.rotation);
  make_whole(of_bonds_, bonds_.d_m);
  make_whole(of_bonds_, bonds_.state);
}

void RockShare::make_whole(const Exec& exec, const MassLoss& loss) const {
  make_positions_whole(exec);
  agree_on_events();
  const auto whole = [&](const Owners& owners, const auto&... views) { (make_whole(owners, views), ...); };
  whole(of_particles_, particles_.v, particles_.spin, particles_.reaction, particles_.force, particles_.torque,
        loss.momentum, loss.kinetic, contacts_.energy);
  whole(of_bonds_, bonds_.joint, bonds_.point_damage, bonds_.slip, bonds_.stress, bonds_.load, loss.elastic);
  // both lists of pairs, because a new one looks up what it keeps in the old
  for (const auto& field : {contacts_.stretch, contacts_.idle_overlap})
    for (int generation = 0; generation < 2; ++generation)
      for (std::size_t feature = 0; feature < pair_features; ++feature)
        ranks_.make_whole(of_pairs(generation), field.data() + (generation + 2 * feature) * field.extent(0));
}

Owners RockShare::of_pairs(int generation) const {
  Owners owners = of_particles_;
  const auto first_pair = on_host(contacts_.first);
  for (Runs& runs : owners)
    for (auto& [first, last] : runs) {
      first = first_pair(first, generation);
      last = first_pair(last, generation);
    }
  return owners;
}

template <class V>
void RockShare::make_whole(const Owners& owners, const V& view) const {
  static_assert(std::is_same_v<typename V::array_layout, Kokkos::LayoutLeft> || V::rank() == 1);
  for (std::size_t column = 0; column < view.size(); column += view.extent(0))
    ranks_.make_whole(owners, view.data() + column);
}

}  // namespace vug
