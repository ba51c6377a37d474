#include "dem/contacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace vug {

namespace {

constexpr int pairs_per_particle = 10;  // a triangulation has about 5 per particle that share a corner but no edge

template <class V>
V fresh(const char* label, std::size_t count) {
  return V(std::string("vug::dem::contact_") + label, count);
}

/// A fifth of the mean edge of the smallest particle: wide enough for few rebuilds, narrow enough for few pairs.
double choose_skin(const Particles& particles) {
  const auto corner = on_host(particles.corner);
  double smallest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < particles.count; ++i) {
    double perimeter = 0;
    for (int c = 0; c < 3; ++c) {
      const int d = (c + 1) % 3;
      perimeter += std::hypot(corner(i, d, 0) - corner(i, c, 0), corner(i, d, 1) - corner(i, c, 1));
    }
    smallest = std::min(smallest, perimeter / 3);
  }
  return 0.2 * smallest;
}

}  // namespace

Contacts make_contacts(const Particles& particles, const Bonds& bonds, bool awake) {
  const auto n = static_cast<std::size_t>(particles.count);
  Contacts c;
  c.capacity = pairs_per_particle * particles.count + 64;
  c.skin = choose_skin(particles);
  const auto size = static_cast<std::size_t>(c.capacity);
  c.status = fresh<IndexList>("status", 3);
  c.first = fresh<decltype(c.first)>("first", n + 1);
  c.other = fresh<decltype(c.other)>("other", size);
  c.stretch = fresh<decltype(c.stretch)>("stretch", size);
  c.load = fresh<decltype(c.load)>("load", size);
  c.row = fresh<IndexList>("row", n + 1);
  c.entry = fresh<IndexList>("entry", 2 * size);
  c.push = fresh<decltype(c.push)>("push", n);
  c.energy = fresh<ScalarField<double>>("energy", n);
  c.u_built = fresh<VectorField<double>>("u_built", n);
  c.angle_built = fresh<ScalarField<double>>("angle_built", n);
  const HostWriter status(c.status);
  status(contacts_stale) = 1;
  if (awake) {
    const HostWriter events(bonds.events);
    events(bond_has_failed) = 1;
  }
  return c;
}

}  // namespace vug
