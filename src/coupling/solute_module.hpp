#pragma once
// Dissolved species carried by the fluid (paper sections 2.3, 3.2).
#include "coupling/flow_module.hpp"
#include "coupling/module.hpp"
#include "coupling/stretch_links.hpp"
#include "kernels/dissolution.hpp"
#include "kernels/solute.hpp"
#include "kernels/units.hpp"

namespace vug {

/// One species: its state, its boundaries and what its balance needs.
template <class T>
struct SpeciesState {
  Species section;
  SoluteParameters parameters;
  SoluteFields<T> fields;
  std::vector<StretchLinks> boundaries;
  ScalarField<double> correction;  ///< (block) added by the advective form
  ScalarField<double> created;     ///< (block) added by filling newborn nodes
  double initial = 0;              ///< lattice units
};

/// Owns the populations of all species. `flow` may be null: diffusion only.
template <class T, class Set>
class SoluteModule final : public Module {
 public:
  SoluteModule(const Exec& exec, const Scene& scene, const LatticeUnits& units, const Geometry& geometry,
               const FlowModule<T>* flow);

  std::string_view name() const override { return "solute"; }
  void step(const Exec& exec, const Clock& clock) override;
  void births(const Exec& exec, const Births& births) override;
  void guard(const Exec& exec, const Clock& clock) override;
  void limits(LimitTable& table) const override;
  void ledger(Ledger& ledger) const override;
  void fields(FieldList& list) const override;
  void state(StateList& list) override;

  /// State of the species of that name; the reactive wall dresses its populations.
  SpeciesState<T>& species(const std::string& name);

 private:
  void find_boundaries(const Exec& exec);

  SoluteSection section_;
  LatticeUnits units_;
  const Geometry& geometry_;
  const FlowModule<T>* flow_;
  BirthFill fill_;
  std::vector<SpeciesState<T>> species_;
};

}  // namespace vug
