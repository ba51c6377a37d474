// The same bits in every build, whatever registers its processor has: digests of fields after some steps, recorded.
#include "kernels/flow/face_flow.hpp"
#include "kernels/flow/flow.hpp"
#include "kernels/reaction/reactive_wall_kernel.hpp"
#include "kernels/reaction/surface_normal.hpp"
#include "kernels/scalar/advective_form.hpp"
#include "kernels/solute/face_exchange.hpp"
#include "support/advance.hpp"
#include "support/flow_setup.hpp"
#include "support/heat_box.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

namespace vug {
namespace {

/// FNV-1a of the first `count` entries' bytes.
template <class Field>
std::uint64_t digest(const Field& field) {
  const auto host = test::host_copy(field);
  std::uint64_t hash = 0xcbf29ce484222325;
  for (std::size_t i = 0; i < host.span(); ++i) {
    unsigned char bytes[sizeof(*host.data())];
    std::memcpy(bytes, host.data() + i, sizeof bytes);
    for (const unsigned char b : bytes) hash = (hash ^ b) * 0x100000001b3;
  }
  return hash;
}

/// Of +-1, by integers only: the library's functions differ from system to system.
double noise(int x, int y) {
  std::uint32_t h = static_cast<std::uint32_t>(x) * 2654435761u ^ static_cast<std::uint32_t>(y) * 2246822519u;
  h = (h ^ h >> 15) * 2246822519u;
  return static_cast<double>((h ^ h >> 13) % 2001) / 1000.0 - 1.0;
}

/// Pathways of three nodes among loose ones.
bool is_rock(int x, int y) {
  return (x + y) % 17 > 2 && (x - 2 * y + 200) % 23 > 2 && noise(x, y) < 0.8;
}

constexpr int nx = 121, ny = 83;

template <class T>
std::uint64_t flow_digest(Collision collision, double limit) {
  const Lattice lattice(nx, ny);
  test::Flow<T> flow(lattice, test::shape(lattice, is_rock), {true, false}, collision, 0.7);
  flow.set([](int x, int y) {
    return Macroscopic<double>{0.01 * noise(x, y), 0.03 * noise(y, x), 0.02 * noise(x, 3)};
  });
  flow.step.body_force = {T(1e-4), T(-2e-5)};
  flow.step.speed_limit = T(limit);
  for (int t = 0; t < 11; ++t) flow.sweep();
  EXPECT_EQ(sum_in_order(flow.step.limited) > 0, limit > 0);
  return digest(flow.fields.f) ^ 3 * digest(flow.fields.u);
}

template <class T, class Set>
std::uint64_t solute_digest(bool advective) {
  const Lattice lattice(nx, ny);
  test::Flow<T> flow(lattice, test::shape(lattice, is_rock), {true, false});
  flow.set([](int x, int y) { return Macroscopic<double>{0, 0.03 * noise(y, x), 0.02 * noise(x, 3)}; });
  SoluteFields<T> s = make_solute_fields<Set, T>(flow.exec, flow.nodes, 0.3);
  const ScalarField<T> e("e", flow.nodes.capacity);
  const ScalarField<double> correction("correction", block_count(flow.nodes.count));
  advective_defect<Set>(flow.exec, flow.nodes, flow.fields.u, e);
  const SoluteParameters parameters = solute_parameters(0.05);
  for (int t = 0; t < 11; ++t) {
    s.rounding = rounding_of_step<T>(t);
    if (advective)
      advance_solute<Set>(flow.exec, flow.nodes, parameters, flow.fields.u, e, s, correction);
    else
      advance_solute<Set>(flow.exec, flow.nodes, parameters, flow.fields.u, s);
  }
  flow.exec.fence();
  return digest(s.h) ^ 3 * digest(s.C) ^ 5 * digest(e);
}

template <class T>
std::uint64_t faces_digest() {
  const Lattice lattice(nx, ny);
  test::Flow<T> flow(lattice, test::shape(lattice, is_rock), {true, false});
  flow.set([](int x, int y) { return Macroscopic<double>{0, 0.03 * noise(y, x), 0.02 * noise(x, 3)}; });
  SoluteFields<T> s = make_solute_fields<D2Q5, T>(flow.exec, flow.nodes, 0.3);
  const VectorField<T> excess("excess", flow.nodes.capacity);
  const ScalarField<double> correction("correction", block_count(flow.nodes.count));
  for (int t = 0; t < 5; ++t) {
    s.rounding = rounding_of_step<T>(t);
    flow.sweep();
    face_excess(flow.exec, flow.nodes, flow.fields, excess);
    advance_solute<D2Q5>(flow.exec, flow.nodes, solute_parameters(0.05), flow.fields.u, s);
    exchange_at_faces(flow.exec, flow.nodes, excess, 2, s, correction);
  }
  flow.exec.fence();
  return digest(excess) ^ 3 * digest(s.h) ^ 5 * digest(correction);
}

template <class T>
std::uint64_t heat_digest(ScalarVelocitySet set) {
  test::HeatBox<T> box(nx, ny, {0.056, 0.14, 0.625, set}, is_rock, noise, {true, true});
  box.flow([](int x, int y) { return std::array<double, 2>{0.03 * noise(y, x), 0.02 * noise(x, 3)}; });
  box.run(11);
  std::uint64_t hash = 5 * digest(box.lagged);  // of populations those inside the lattice
  const auto g = test::host_copy(box.fields.g);
  const ScalarField<T> inside("inside", std::size_t(box.directions()) * nx * ny);
  const auto host = Kokkos::create_mirror_view(inside);
  int k = 0;
  for (int q = 0; q < box.directions(); ++q)
    for (int y = 0; y < ny; ++y)
      for (int x = 0; x < nx; ++x) host(k++) = g(q * box.lattice.size() + box.lattice.node(x, y));
  Kokkos::deep_copy(inside, host);
  return hash ^ digest(inside);
}

/// The mean of two nodes.
struct FaceBetween {
  ScalarField<double> kelvin;
  KOKKOS_FUNCTION void announce(int, int) const {}
  KOKKOS_FUNCTION double operator()(int solid, int fluid) const { return 0.5 * (kelvin(solid) + kelvin(fluid)); }
};

/// Normals of a rock that has dissolved in part and been handed solid here and there, and what its links conduct.
template <class T>
std::uint64_t rates_digest(double inverse_equilibrium) {
  const Lattice lattice(nx, ny);
  test::Flow<T> flow(lattice, test::shape(lattice, is_rock), {true, false});
  std::vector<double> solid(lattice.size()), gone(lattice.size()), warmth(lattice.size());
  for (int y = 0; y < ny; ++y)
    for (int x = 0; x < nx; ++x) {
      const int n = lattice.node(x, y);
      warmth[n] = 400 + 140 * noise(x, y);
      gone[n] = is_rock(x, y) ? 0.4 * (1 + noise(x, 2 * y)) : 0;
      solid[n] = is_rock(x, y) ? 1 - gone[n] + (noise(y, x) > 0.9 ? 0.3 : 0) : 0;
    }
  const auto volume = to_device<ScalarField<double>>("volume", solid),
             dissolved = to_device<ScalarField<double>>("dissolved", gone),
             kelvin = to_device<ScalarField<double>>("kelvin", warmth);
  Surface surface;
  find_surface(flow.exec, flow.nodes, test::shape(lattice, is_rock), surface);
  VectorField<double> normal;
  find_normals(flow.exec, flow.nodes, surface, volume, dissolved, normal);
  ReactiveWall wall;
  wall.inverse_equilibrium = inverse_equilibrium;
  ReactiveLinks<T> links;
  find_reactive_links<D2Q5>(flow.exec, flow.nodes, surface, wall.law, links);
  for (const double k0 : {1e-4, 3e-4}) {
    const ArrheniusRate<FaceBetween> rate{k0, 7553, 330, {kelvin}};
    set_conductances<D2Q5>(flow.exec, flow.nodes, surface, wall, rate, normal, links, k0 > 2e-4 ? 0.3 : 0);
  }
  flow.exec.fence();
  return digest(normal) ^ 3 * digest(links.conductance) ^ 5 * digest(links.rate);
}

TEST(SameBits, InEveryBuild) {
  if constexpr (!shares_host_memory) GTEST_SKIP() << "a GPU fuses multiplications and additions";
  struct Recorded {
    std::uint64_t found, expected;
  };
  const Recorded all[] = {
      {flow_digest<double>(Collision::trt, 0), 0x68f8e9dee67fea22},
      {flow_digest<double>(Collision::trt, 0.02), 0xd6197687b55fd83e},
      {flow_digest<double>(Collision::lallemand_luo, 0), 0x6db1a618704fa75d},
      {flow_digest<double>(Collision::regularised, 0), 0x5b5a9f42c2df185e},
      {flow_digest<float>(Collision::trt, 0.02), 0xddd4787279e050a4},
      {flow_digest<float>(Collision::regularised, 0.02), 0x19676748b1d31509},
      {solute_digest<double, D2Q5>(false), 0x465703bffd562d7f},
      {solute_digest<double, D2Q5>(true), 0x3aee1d4b6b9f9a07},
      {solute_digest<double, D2Q9>(true), 0x900efba3cd6383d2},
      {solute_digest<float, D2Q5>(true), 0xb6abebe5f3a6dcc4},
      {solute_digest<float, D2Q9>(true), 0x12e7db30509f1b7d},
      {heat_digest<double>(ScalarVelocitySet::d2q5), 0xcce70c511210767d},
      {heat_digest<double>(ScalarVelocitySet::d2q9), 0x816155827451bda4},
      {heat_digest<float>(ScalarVelocitySet::d2q5), 0x3fa24d26c1e03c6a},
      {heat_digest<float>(ScalarVelocitySet::d2q9), 0x210ba88080dce8ee},
      {faces_digest<double>(), 0xacd747db217687d9},
      {faces_digest<float>(), 0x95aad8c8b0b293af},
      {rates_digest<double>(1e-3), 0xcd9200d5a237679c},
      {rates_digest<float>(0.2), 0x9dd9f8b658079f87},
  };
  for (std::size_t k = 0; k < std::size(all); ++k) EXPECT_EQ(all[k].found, all[k].expected) << "entry " << k;
}

}  // namespace
}  // namespace vug
