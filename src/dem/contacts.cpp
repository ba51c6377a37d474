#include "dem/contacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vug {

namespace {

constexpr int pairs_per_particle = 10;  // a triangulation has about 5 per particle that share a corner but no edge

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
  const int n = particles.count;
  Contacts c;
  c.capacity = pairs_per_particle * particles.count + 64;
  c.skin = choose_skin(particles);
  make_zeros(c.status, "vug::dem::contact_status", 3);
  make_zeros(c.first, "vug::dem::contact_first", n + 1);
  make_zeros(c.other, "vug::dem::contact_other", c.capacity);
  make_zeros(c.stretch, "vug::dem::contact_stretch", c.capacity);
  make_zeros(c.idle_overlap, "vug::dem::contact_idle_overlap", c.capacity);
  make_zeros(c.load, "vug::dem::contact_load", c.capacity);
  make_zeros(c.row, "vug::dem::contact_row", n + 1);
  make_zeros(c.entry, "vug::dem::contact_entry", 2 * c.capacity);
  make_zeros(c.push, "vug::dem::contact_push", n);
  make_zeros(c.energy, "vug::dem::contact_energy", n);
  make_zeros(c.u_built, "vug::dem::contact_u_built", n);
  make_zeros(c.angle_built, "vug::dem::contact_angle_built", n);
  const HostWriter status(c.status);
  status(contacts_stale) = 1;
  if (awake) {
    const HostWriter events(bonds.events);
    events(bond_has_failed) = 1;
  }
  return c;
}

}  // namespace vug
