#include "dem/critical_step.hpp"

#include "dem/bond_elasticity.hpp"

namespace vug {

namespace {

/// Symmetric 3 × 3 matrix in the scaled coordinates (u_x, u_y, rho angle) with rho^2 = I / m.
struct Stiffness {
  double xx = 0, yy = 0, rr = 0, xy = 0, xr = 0, yr = 0;

  /// Adds a spring k along unit vector d at lever arm `lever` = r × d / rho.
  KOKKOS_FUNCTION void add(double k, Vec2 d, double lever) {
    xx += k * d.x * d.x;
    yy += k * d.y * d.y;
    rr += k * lever * lever;
    xy += k * d.x * d.y;
    xr += k * d.x * lever;
    yr += k * d.y * lever;
  }

  /// Largest eigenvalue by the trigonometric solution of the characteristic equation.
  KOKKOS_FUNCTION double largest_eigenvalue() const {
    const double q = (xx + yy + rr) / 3;
    const double a = xx - q, b = yy - q, c = rr - q;
    const double p = Kokkos::sqrt((a * a + b * b + c * c + 2 * (xy * xy + xr * xr + yr * yr)) / 6);
    if (!(p > 0)) return q;
    const double det = a * (b * c - yr * yr) - xy * (xy * c - yr * xr) + xr * (xy * yr - b * xr);
    const double cosine = Kokkos::max(-1.0, Kokkos::min(1.0, det / (2 * p * p * p)));
    return q + 2 * p * Kokkos::cos(Kokkos::acos(cosine) / 3);
  }
};

/// Critical step of one particle while everything else is held still and mirrored; the smallest over all particles
/// bounds that of the system.
struct ParticleStep {
  BondParameters rock;
  ContactParameters contact;
  double mass_scaling;
  Particles p;
  Bonds bonds;
  BoundaryLoads loads;

  KOKKOS_FUNCTION void add_bond(int e, double rho, Stiffness& stiffness, Stiffness& dashpot) const {
    const int k = bonds.entry(e) / 2, end = bonds.entry(e) % 2;
    const BondParameters law = law_of(rock, bonds.elasticity, k);
    const Vec2 n{bonds.normal(k, 0), bonds.normal(k, 1)}, t{-n.y, n.x};
    const double width = 0.5 * bonds.length(k);
    const double bond_length = law.length_factor * bonds.spacing(k);
    const double left = 1 - Kokkos::min(bonds.d_c(k), 1.0);
    for (int s = 0; s < 2; ++s) {
      const Vec2 r{bonds.arm(k, s, end, 0), bonds.arm(k, s, end, 1)};
      stiffness.add(left * width * law.normal_modulus / bond_length, n, cross(r, n) / rho);
      stiffness.add(left * width * law.tangential_modulus / bond_length, t, cross(r, t) / rho);
      dashpot.add(Kokkos::max(width * law.damping * law.normal_modulus, contact.normal_damping), n, cross(r, n) / rho);
      dashpot.add(Kokkos::max(width * law.damping * law.tangential_modulus, contact.tangential_damping), t,
                  cross(r, t) / rho);
    }
  }

  KOKKOS_FUNCTION void add_contact(int i, double rho, Stiffness& stiffness, Stiffness& dashpot) const {
    Vec2 far;
    for (int c = 0; c < 3; ++c) {
      const Vec2 corner{p.corner(i, c, 0), p.corner(i, c, 1)};
      if (dot(corner, corner) > dot(far, far)) far = corner;
    }
    const Vec2 out = (1 / norm(far)) * far, along{-out.y, out.x};
    stiffness.add(contact.normal_stiffness, out, 0);
    stiffness.add(contact.tangential_stiffness, along, norm(far) / rho);
    dashpot.add(contact.normal_damping, out, 0);
    dashpot.add(contact.tangential_damping, along, norm(far) / rho);
  }

  KOKKOS_FUNCTION void operator()(int i, double& smallest) const {
    if (is_gone(p.solid_fraction(i))) return;
    const double mass = mass_scaling * mass_fraction(p.solid_fraction(i)) * p.mass(i);
    const double rho = Kokkos::sqrt(p.inertia(i) / p.mass(i));
    Stiffness stiffness, dashpot;
    for (int e = bonds.row(i); e < bonds.row(i + 1); ++e) add_bond(e, rho, stiffness, dashpot);
    add_contact(i, rho, stiffness, dashpot);
    // the mirror image below doubles every spring; springs that end at the fixed rock beyond have none
    stiffness.add(0.5 * loads.stiffness(i, 0), {1, 0}, 0);
    stiffness.add(0.5 * loads.stiffness(i, 1), {0, 1}, 0);
    const double omega = Kokkos::sqrt(2 * stiffness.largest_eigenvalue() / mass);
    const double z = dashpot.largest_eigenvalue() / (mass * omega);
    smallest = Kokkos::min(smallest, 2 / omega * (Kokkos::sqrt(1 + z * z) - z));
  }
};

}  // namespace

double critical_step(const Exec& exec, const MechanicsParameters& parameters, const Particles& particles,
                     const Bonds& bonds, const BoundaryLoads& loads) {
  double smallest = 0;
  Kokkos::parallel_reduce(
      "vug::dem::critical_step", Kokkos::RangePolicy<Exec>(exec, 0, particles.count),
      ParticleStep{parameters.bond, parameters.contact, parameters.mass_scaling, particles, bonds, loads},
      Kokkos::Min<double>(smallest));
  return smallest;
}

}  // namespace vug
