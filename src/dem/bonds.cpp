#include "dem/bonds.hpp"

#include "base/require.hpp"
#include "dem/edges.hpp"
#include "dem/heterogeneity.hpp"
#include "dem/materials.hpp"

#include <algorithm>
#include <set>
#include <vector>

namespace vug {

namespace {

void allocate(Bonds& b, int n, int particles) {
  b.count = n;
  make_zeros(b.pair, "vug::dem::bond_pair", n);
  make_zeros(b.vertex, "vug::dem::bond_vertex", n);
  make_zeros(b.length, "vug::dem::bond_length", n);
  make_zeros(b.spacing, "vug::dem::bond_spacing", n);
  make_zeros(b.normal, "vug::dem::bond_normal", n);
  make_zeros(b.arm, "vug::dem::bond_arm", n);
  make_zeros(b.normal_strength, "vug::dem::bond_normal_strength", n);
  make_zeros(b.cohesion, "vug::dem::bond_cohesion", n);
  make_zeros(b.energy_I, "vug::dem::bond_energy_I", n);
  make_zeros(b.energy_II, "vug::dem::bond_energy_II", n);
  make_zeros(b.point_damage, "vug::dem::bond_point_damage", n);
  make_zeros(b.d_m, "vug::dem::bond_d_m", n);
  make_zeros(b.d_c, "vug::dem::bond_d_c", n);
  make_zeros(b.overstressed, "vug::dem::bond_overstressed", n);
  make_zeros(b.state, "vug::dem::bond_state", n);
  make_zeros(b.joint, "vug::dem::bond_joint", n);
  make_zeros(b.events, "vug::dem::bond_events", 2);
  Kokkos::deep_copy(b.joint, faces_joined);
  make_zeros(b.slip, "vug::dem::bond_slip", n);
  make_zeros(b.stress, "vug::dem::bond_stress", n);
  make_zeros(b.load, "vug::dem::bond_load", n + 1);
  make_zeros(b.row, "vug::dem::bond_row", particles + 1);
  make_zeros(b.entry, "vug::dem::bond_entry", 2 * n);
  make_zeros(b.slot, "vug::dem::bond_slot", particles);
}

void fill_geometry(const Assembly& assembly, const std::vector<Edge>& edges, const Particles& particles, Bonds& b) {
  const auto x0 = on_host(particles.x0);
  const HostWriter pair(b.pair), vertex(b.vertex);
  const HostWriter length(b.length), spacing(b.spacing);
  const HostWriter normal(b.normal);
  const HostWriter arm(b.arm);
  for (int k = 0; k < b.count; ++k) {
    const Edge& edge = edges[k];
    const Vec2 p = vertex_of(assembly, edge.vertex[0]), q = vertex_of(assembly, edge.vertex[1]);
    const Vec2 half = 0.5 * (q - p), middle = 0.5 * (p + q);
    const double l = 2 * norm(half);
    const Vec2 n{2 * half.y / l, -2 * half.x / l};
    Vec2 centre[2];
    for (int end = 0; end < 2; ++end) {
      const int i = edge.triangle[end];
      pair(k, end) = i;
      vertex(k, end) = edge.vertex[end];
      centre[end] = {x0(i, 0), x0(i, 1)};
      for (int point = 0; point < 2; ++point) {
        const Vec2 r = middle + (point == 0 ? -gauss_point : gauss_point) * half - centre[end];
        arm(k, point, end, 0) = r.x;
        arm(k, point, end, 1) = r.y;
      }
    }
    length(k) = l;
    spacing(k) = dot(centre[1] - centre[0], n);
    normal(k, 0) = n.x;
    normal(k, 1) = n.y;
  }
}

/// Parameters of each bond; one entry for all where the rock is of one material.
std::vector<BondParameters> laws_of_bonds(const Assembly& assembly, const std::vector<Edge>& edges,
                                          const Particles& particles, const MechanicsParameters& parameters) {
  if (assembly.region.empty()) return {parameters.bond};
  const auto x0 = on_host(particles.x0);
  std::vector<BondParameters> laws;
  for (const Edge& edge : edges) {
    const Vec2 p = vertex_of(assembly, edge.vertex[0]), along = vertex_of(assembly, edge.vertex[1]) - p;
    const auto distance = [&](int i) { return std::abs(cross(along, Vec2{x0(i, 0), x0(i, 1)} - p)); };
    const auto [a, b] = edge.triangle;
    laws.push_back(joint_of(material_of(parameters, assembly, a).bond, distance(a),
                            material_of(parameters, assembly, b).bond, distance(b)));
  }
  return laws;
}

void fill_elasticity(const std::vector<BondParameters>& laws, Bonds& b) {
  const auto fill = [&](const char* label, double BondParameters::*number, ScalarField<double>& values) {
    make_zeros(values, label, static_cast<int>(laws.size()));
    const HostWriter host(values);
    for (std::size_t k = 0; k < laws.size(); ++k) host(k) = laws[k].*number;
  };
  fill("vug::dem::bond_normal_modulus", &BondParameters::normal_modulus, b.elasticity.normal_modulus);
  fill("vug::dem::bond_tangential_modulus", &BondParameters::tangential_modulus, b.elasticity.tangential_modulus);
  fill("vug::dem::bond_internal_friction", &BondParameters::internal_friction, b.elasticity.internal_friction);
  fill("vug::dem::bond_damping", &BondParameters::damping, b.elasticity.damping);
}

/// Draws one property of all bonds: scatter from the rock's seed and shape, mean from the parameters of each bond.
void draw(const BondParameters& rock, const std::vector<BondParameters>& laws, const std::vector<Edge>& edges,
          BondProperty property, double BondParameters::*mean, const ScalarField<double>& values) {
  const HostWriter host(values);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const auto [low, high] = std::minmax(edges[k].vertex[0], edges[k].vertex[1]);
    const double u = uniform_of(rock.seed, static_cast<std::uint64_t>(low), static_cast<std::uint64_t>(high),
                                static_cast<std::uint64_t>(property));
    host(k) = laws[laws.size() == 1 ? 0 : k].*mean * weibull_of_mean_one(u, rock.weibull_shape);
  }
}

void open_initial_cracks(const Assembly& assembly, const std::vector<Edge>& edges, Bonds& b) {
  std::set<std::array<int, 2>> cracks;
  const HostWriter events(b.events);
  events(bond_has_failed) = assembly.initial_cracks.empty() ? 0 : 1;
  for (const auto& c : assembly.initial_cracks) cracks.insert({std::min(c[0], c[1]), std::max(c[0], c[1])});
  const HostWriter state(b.state);
  const HostWriter d_m(b.d_m);
  const HostWriter point_damage(b.point_damage);
  for (int k = 0; k < b.count; ++k) {
    const auto& v = edges[k].vertex;
    const bool cracked = cracks.erase({std::min(v[0], v[1]), std::max(v[0], v[1])}) > 0;
    state(k) = cracked ? BondState::cracked_at_start : BondState::intact;
    d_m(k) = point_damage(k, 0) = point_damage(k, 1) = cracked ? 1 : 0;
  }
  if (!cracks.empty()) {
    const auto& v = *cracks.begin();
    throw InputError("rock assembly: initial crack " + std::to_string(v[0]) + "-" + std::to_string(v[1]) +
                     " is no edge between two triangles");
  }
}

void fill_rows(const std::vector<Edge>& edges, int particles, Bonds& b) {
  const HostWriter row(b.row), entry(b.entry);
  const HostWriter slot(b.slot);
  std::vector<std::vector<int>> of(particles);
  for (int k = 0; k < b.count; ++k)
    for (int end = 0; end < 2; ++end) of[edges[k].triangle[end]].push_back(2 * k + end);
  int next = 0;
  for (int i = 0; i < particles; ++i) {
    row(i) = next;
    for (int edge = 0; edge < 3; ++edge) slot(i, edge) = 2 * b.count;
    for (const int e : of[i]) {
      slot(i, next - row(i)) = e;
      entry(next++) = e;
    }
  }
  row(particles) = next;
}

}  // namespace

Bonds make_bonds(const Assembly& assembly, const Particles& particles, const MechanicsParameters& parameters) {
  std::vector<Edge> edges = find_edges(assembly);
  std::erase_if(edges, [](const Edge& edge) { return edge.triangle[1] < 0; });
  Bonds b;
  allocate(b, static_cast<int>(edges.size()), particles.count);
  fill_geometry(assembly, edges, particles, b);
  const std::vector<BondParameters> laws = laws_of_bonds(assembly, edges, particles, parameters);
  if (!assembly.region.empty()) fill_elasticity(laws, b);
  using Law = BondParameters;
  draw(parameters.bond, laws, edges, BondProperty::normal_strength, &Law::normal_strength, b.normal_strength);
  draw(parameters.bond, laws, edges, BondProperty::cohesion, &Law::cohesion, b.cohesion);
  draw(parameters.bond, laws, edges, BondProperty::energy_I, &Law::fracture_energy_I, b.energy_I);
  draw(parameters.bond, laws, edges, BondProperty::energy_II, &Law::fracture_energy_II, b.energy_II);
  open_initial_cracks(assembly, edges, b);
  fill_rows(edges, particles.count, b);
  return b;
}

}  // namespace vug
