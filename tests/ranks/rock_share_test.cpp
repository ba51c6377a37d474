// How ranks share rock, on as many as mpirun starts.
#include "base/base.hpp"
#include "dem/mechanics.hpp"
#include "io/rock_generator.hpp"
#include "world.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace vug {
namespace {

/// Calls visit(values, count) for all Views of the state.
template <class Visit>
void for_bytes_of_state(const Mechanics& rock, const Visit& visit) {
  rock.visit_state([&](const char* name, const auto& view, auto...) {
    const auto now = on_host(view);
    visit(std::string(name), reinterpret_cast<const char*>(now.data()), now.size() * sizeof(*now.data()));
  });
}

TEST(RockShare, EveryRankMovesItsOwnRockAndAllTogetherThatOfOne) {
  RockSection section;
  section.element_size = 3e-3;
  const Assembly block = generate_rock(0.05, 0.1, section);
  Mechanics whole(block, {}, {}), shared(block, {}, {});
  shared.share(world);
  const int triangles = whole.particles().count;
  const auto x0 = on_host(whole.particles().x0);
  std::vector<int> left, ours;
  for (int i = 0; i < triangles; ++i) {
    EXPECT_EQ(world.most(shared.moves(i) ? world.rank() : -1), world.least(shared.moves(i) ? world.rank() : triangles));
    if (shared.moves(i)) ours.push_back(i);
    if (x0(i, 0) < 0.02) left.push_back(i);
  }
  for (Mechanics* rock : {&whole, &shared}) {
    rock->set_velocity(left, {-20, 5});  // m/s: it tears off
    rock->advance(Exec(), 0.3 * whole.critical_step(), 400);
    Exec().fence();
  }
  EXPECT_GT(whole.bond_counts().failed(), 5);
  const Contacts& contacts = whole.contacts();
  EXPECT_GT(on_host(contacts.first)(triangles, on_host(contacts.status)(contacts_generation)), 0);  // pairs that touch
  const auto u = on_host(whole.particles().u), v = on_host(whole.particles().v);
  const auto shared_u = on_host(shared.particles().u), shared_v = on_host(shared.particles().v);
  for (const int i : ours)
    for (int axis = 0; axis < 2; ++axis) ASSERT_EQ(shared_u(i, axis), u(i, axis)) << i;
  int old = 0;  // what others have moved since
  for (int i = 0; i < triangles; ++i) old += shared_v(i, 0) != v(i, 0);
  EXPECT_EQ(old > 0, !world.alone());
  shared.make_whole(Exec());
  std::vector<std::string> bytes;
  for_bytes_of_state(whole, [&](const std::string&, const char* at, std::size_t n) { bytes.emplace_back(at, n); });
  std::size_t next = 0;
  for_bytes_of_state(shared, [&](const std::string& name, const char* at, std::size_t n) {
    EXPECT_TRUE(bytes.at(next++) == std::string(at, n)) << name;
  });
}

}  // namespace
}  // namespace vug
