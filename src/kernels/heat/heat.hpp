#pragma once
// Conjugate heat on every node of the lattice, fluid and solid alike: D2Q5 or D2Q9, two relaxation times with Lambda =
// 1/4.
//
// One step: fill the halo (heat_boundary.hpp), then `conduct`, or `conduct_and_advect` where there is flow.
// Temperatures are deviations from a reference, so that float keeps its digits; energies are per unit of the fluid's
// volumetric heat capacity: a node holds theta in fluid, sigma theta in solid.
#include "kernels/launch/row_launch.hpp"
#include "kernels/nodes/fluid_rows.hpp"
#include "kernels/scalar/rounding.hpp"
#include "kernels/scalar/scalar_equilibrium.hpp"

#include <array>
#include <optional>
#include <type_traits>
#include <vector>

namespace vug {

/// Thermal constants of a mineral, as those of the solid in HeatParameters.
struct HeatMineral {
  double diffusivity = 0;
  double capacity_ratio = 1;
};

/// Lattice units (dx = dt = 1); a heat step every n flow steps has n times the diffusivities.
struct HeatParameters {
  double fluid_diffusivity = 0;
  double solid_diffusivity = 0;
  double capacity_ratio = 1;  ///< sigma = (rho cp)_s / (rho cp)_f
  ScalarVelocitySet velocity_set = ScalarVelocitySet::d2q5;
  std::vector<HeatMineral> minerals{};  ///< by their numbers, of which 0 is the solid above; empty: only that
};

/// HeatParameters in the form that kernels need.
template <class T>
struct HeatRates {
  T fluid, solid;  ///< relaxation rate s = 1 / (1/2 + 3 D) of the odd moments; the even ones relax with 2 - s
  T reflection;    ///< (1 - sigma) / (1 + sigma)
  double capacity_ratio;
};

/// Throws InputError unless all three parameters are positive and finite.
template <class T>
HeatRates<T> heat_rates(const HeatParameters& parameters);

/// The kinds of matter where there is more than fluid and one solid: 0 fluid, 1 + m mineral m, `no_matter` where
/// nothing is computed.
struct HeatMatter {
  Kokkos::View<std::uint8_t*> of_node;        ///< (node) with halo, as HeatFields::solid; empty: fluid and one solid
  ScalarField<double> capacity;               ///< (kind) heat capacity over that of the fluid; 0 of no_matter
  ScalarField<double> rate;                   ///< (kind) relaxation rate s
  Kokkos::View<const std::uint8_t*> mineral;  ///< (dense node) number of its mineral

  bool given() const { return of_node.extent(0) > 0; }
};
inline constexpr std::uint8_t no_matter = 255;

/// Entries of the mask of the solid where nothing is computed: beyond a side that is not joined to the opposite one
/// (D2Q9; see HeatFields), and in an opening. All values above 1 mean this.
inline constexpr std::uint8_t outside_lattice = 2, inside_opening = 3;

/// Per node Q populations, in two lattices on a GPU, and a byte: on a host 21 bytes in float and 41 in double with
/// D2Q5, 37 and 73 with D2Q9.
template <class T>
struct HeatFields {
  Lattice lattice;
  HeatRates<T> rates;
  ScalarVelocitySet velocity_set = ScalarVelocitySet::d2q5;
  bool openings = false;  ///< some nodes are in openings (opening.hpp), where g is what was filled in
  ScalarField<T> g;       ///< (q * lattice.size() + node) post-collision populations, with halo
  ScalarField<T> g_next;  ///< second lattice, exchanged with g in every step; empty on a host, which steps in place
  /// (node) 1 in solid. In the halo as at the node joined to it. Beyond a side that is not joined, every link must be
  /// one between like nodes: there it is as at the node beside it on D2Q5, and `outside_lattice` on D2Q9, whose
  /// diagonals meet there.
  Kokkos::View<std::uint8_t*> solid;
  HeatMatter matter;
  int first_row = 0, rows = 0;  ///< [first_row, first_row + rows) are the rows that this process computes
  int bands = 0;  ///< number of bands of rows that a step in place does side by side (heat_bands.hpp); 0 on a GPU
  ScalarField<T> lines;                        ///< (band, line, x) what they set aside
  std::array<bool, 2> periodic{false, false};  ///< which sides are joined, as given to set_heat_geometry
  StepRounding<T> rounding{};                  ///< of the next step
};

/// Temperature of a node, deviation from the reference: the sum of its populations, which every step conserves and
/// leaves at their node. Not valid in openings and outside the lattice.
template <class T>
struct Temperature {
  Kokkos::View<const T*> g;
  int plane;
  bool diagonals;  ///< there are diagonal populations (D2Q9)

  explicit Temperature(const HeatFields<T>& fields)
      : g(fields.g), plane(fields.lattice.size()), diagonals(fields.velocity_set == ScalarVelocitySet::d2q9) {}

  KOKKOS_FORCEINLINE_FUNCTION T operator()(int node) const {
    return diagonals ? sum_of_populations<D2Q9, T>(&g(node), plane) : sum_of_populations<D2Q5, T>(&g(node), plane);
  }
};

/// Properties of the nodes for boundaries and sums: fluid and one solid.
template <class T>
struct TwoKinds {
  double capacity_ratio;
  HeatRates<T> rates;
  Kokkos::View<const std::uint8_t*> kind;
  KOKKOS_FORCEINLINE_FUNCTION bool solid(int node) const { return kind(node) != 0; }
  KOKKOS_FORCEINLINE_FUNCTION T rate(int node) const { return kind(node) ? rates.solid : rates.fluid; }
  KOKKOS_FORCEINLINE_FUNCTION T share(int, T share) const { return share; }
  KOKKOS_FORCEINLINE_FUNCTION double capacity(int node) const { return kind(node) ? capacity_ratio : 1; }
};
/// Fluid and minerals.
template <class T>
struct ManyKinds {
  Kokkos::View<const double*> capacities, rates;
  Kokkos::View<const std::uint8_t*> kind;
  KOKKOS_FORCEINLINE_FUNCTION bool solid(int) const { return false; }
  KOKKOS_FORCEINLINE_FUNCTION T rate(int node) const { return static_cast<T>(rates(kind(node))); }
  KOKKOS_FORCEINLINE_FUNCTION T share(int node, T share) const { return share / static_cast<T>(capacity(node)); }
  KOKKOS_FORCEINLINE_FUNCTION double capacity(int node) const { return capacities(kind(node)); }
};

/// Calls visit(kinds) with the properties of the nodes, TwoKinds or ManyKinds.
template <class T, class Visit>
void visit_kinds(const HeatFields<T>& fields, const Visit& visit) {
  if (fields.matter.given())
    visit(ManyKinds<T>{fields.matter.capacity, fields.matter.rate, fields.matter.of_node});
  else
    visit(TwoKinds<T>{fields.rates.capacity_ratio, fields.rates, fields.solid});
}

/// Allocates the fields; all nodes have temperature `theta`. `openings`: there are nodes of type NodeType::opening.
/// `mineral` (dense node) numbers parameters.minerals. `rows`: those of this process, where processes share them.
template <class T>
HeatFields<T> make_heat_fields(const Exec& exec, const Lattice& lattice, const HeatParameters& parameters,
                               const Kokkos::View<NodeType*>& type, std::array<bool, 2> periodic, double theta,
                               bool openings = false, const Kokkos::View<const std::uint8_t*>& mineral = {},
                               const std::optional<Rows>& rows = {});

/// Sets the rates of the next steps from the diffusivities of `parameters`. With a `stretch` other than 1 they are
/// those of the one step after which steps take `stretch` times as many lattice steps (turning.hpp; D2Q5).
template <class T>
void set_heat_rates(const HeatParameters& parameters, double stretch, HeatFields<T>& fields);

/// theta (node) = temperature of every node of this process's rows, 0 in openings.
template <class T>
void take_temperatures(const Exec& exec, const HeatFields<T>& fields, const ScalarField<T>& theta);

/// The same for the whole lattice in a new field, 0 outside the lattice: for output.
template <class T>
ScalarField<T> temperatures(const Exec& exec, const HeatFields<T>& fields);

/// Takes over a changed geometry. The populations of a node stay as they are when its kind changes; the energy that it
/// gains is booked by add_birth_energy (heat_sums.hpp), which must be called before.
template <class T>
void set_heat_geometry(const Exec& exec, const Kokkos::View<NodeType*>& type, std::array<bool, 2> periodic,
                       HeatFields<T>& fields);

/// On a host: sets the number of bands of rows in which a step is done, at most one per row. make_heat_fields chooses
/// it from the number of threads; the results do not depend on it, to the bit.
template <class T>
void set_heat_bands(const Exec& exec, int bands, HeatFields<T>& fields);

/// Conduction through fluid and solid: pull, conjugate link, collide at rest, store. The halo must have been filled.
/// If `theta` (node) is given, it holds the temperatures afterwards, except in openings: on a host that costs a third
/// of taking them later.
template <class T>
void conduct(const Exec& exec, HeatFields<T>& fields, const std::type_identity_t<ScalarField<T>>& theta = {});

/// Ratio of the rates at which the even and the odd part of the carried populations build up, (2 - s) / s; 1 on D2Q5,
/// which has no even part.
template <class T>
T even_defect_weight(const HeatFields<T>& fields) {
  return fields.velocity_set == ScalarVelocitySet::d2q9 ? (2 - fields.rates.fluid) / fields.rates.fluid : T(1);
}

/// lagged *= stretch: adapts what lags behind the displacement to steps that now take `stretch` times as many lattice
/// steps.
template <class T>
void stretch_lagged(const Exec& exec, const Share& list, double stretch, const ScalarField<T>& lagged);

/// `conduct`, followed by what the flow adds to the populations of fluid nodes. On a host this goes row by row, so that
/// every part of a row is finished while it is in the nearest cache, because the fluid nodes of rock are scattered. `u`
/// is the displacement in this step, `defect` (fluid) the e of kernels/scalar/advective_form.hpp for that of the heat
/// step before, its even part weighted with even_defect_weight. `lagged` (fluid) is the e' that lags behind e
/// (Convection in heat_kernels.hpp): 0 at the start and at births, part of a checkpoint. The energy that the advective
/// form adds is added to `created` (row); `theta` as in `conduct`.
template <class T>
void conduct_and_advect(const Exec& exec, const FluidNodes& nodes, const FluidRows& rows,
                        const std::type_identity_t<Displacement<T>>& u, const ScalarField<T>& defect,
                        const ScalarField<T>& lagged, HeatFields<T>& fields, const ScalarField<double>& created,
                        const std::type_identity_t<ScalarField<T>>& theta = {});

}  // namespace vug
