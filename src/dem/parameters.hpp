#pragma once
// All parameters of the mechanics, SI; the defaults are the paper's Table 1 ("paper-literal" profile).
#include <cstdint>
#include <vector>

namespace vug {

/// Cohesive bond (paper Eqs. 11, 12, Table 1; docs/model.md, "Bonds").
struct BondParameters {
  double normal_modulus = 24.03e9;      ///< M_n, Pa
  double tangential_modulus = 10.68e9;  ///< M_t, Pa
  double length_factor = 0.659;     ///< chi: bond length L = chi h; h: distance of the two centroids across the edge
  double normal_strength = 15e6;    ///< mean of sigma_n^th, Pa
  double cohesion = 95e6;           ///< mean internal cohesion c, Pa
  double internal_friction = 0.47;  ///< tan(phi) in the shear strength
  double fracture_energy_I = 20;    ///< mean of G_I, N/m
  double fracture_energy_II = 64;   ///< mean of G_II, N/m
  double damping = 4.60e-6;         ///< eta, s/m: viscous stress eta M v
  double weibull_shape = 7;         ///< m; 0 switches the scatter off
  std::uint64_t seed = 1;           ///< of the scatter
};

/// Contact between triangles that no intact bond joins (Table 1).
struct ContactParameters {
  double normal_stiffness = 3.73e10;      ///< K_n, N/m
  double tangential_stiffness = 1.69e10;  ///< K_t, N/m
  double friction = 0.30;                 ///< sliding friction coefficient
  double normal_damping = 1.17e3;         ///< N s/m
  double tangential_damping = 0;          ///< N s/m
  double radius_factor = 0.1;             ///< sphero radius over the smallest inradius of the assembly
};

/// The polynomial square d_c^2 + linear d_c + constant.
struct QuadraticFit {
  double square, linear, constant;
};

/// Effect of dissolution on bonds (Eqs. 26-29); the default fits are those of the paper's sandstone (Eq. 29).
struct ChemicalDamageLaw {
  bool normalised = true;    ///< divide f1, f2 by their values at d_c = 0, so that d_c = 0 is Table 1 exactly
  double failure_at = 0.95;  ///< a bond fails at this d_c
  QuadraticFit strength{-0.83, 0.017, 0.98};  ///< f1; positive for d_c < 1
  QuadraticFit energy{5.29, -3.34, 1.01};     ///< f2; likewise, and must not rise from d_c = 0
};

/// Material of a region that differs from the rest of the rock; scatter and length factor are those of the rock.
struct RockMaterial {
  double density = 2500;            ///< kg/m3
  double thermal_expansion = 8e-6;  ///< 1/K, linear
  BondParameters bond;
};

/// Parameters of the triangles and of their motion.
struct MechanicsParameters {
  double density = 2500;            ///< kg/m3
  double thermal_expansion = 8e-6;  ///< 1/K, linear
  double local_damping = 0;         ///< Cundall's alpha, 0 to 1
  double mass_scaling = 1;          ///< density scaling of inertia only, >= 1
  double rest_tolerance = 0;  ///< unrest below which rock sleeps, over the force in its bonds (rest.hpp); 0: never
  bool output_from_unloaded = false;  ///< output counts displacements from the rock before the preload, not after it
  bool energy_ledger = false;         ///< keep account of work, fracture, friction and damping (costs about a tenth)
  BondParameters bond;
  ContactParameters contact;
  ChemicalDamageLaw chemical;
  std::vector<RockMaterial> materials;  ///< of the regions 1, 2, ... of the assembly; region 0 is as above
};

}  // namespace vug
