#pragma once
// Flow through the pores (paper section 2.1).
#include "coupling/module.hpp"
#include "coupling/stretch_links.hpp"
#include "kernels/flow.hpp"
#include "kernels/units.hpp"

namespace vug {

/// Owns the flow populations, velocity and pressure; writes nothing else.
template <class T>
class FlowModule final : public Module {
 public:
  /// `carries_scalars`: whether heat or solute is in the scene and needs the advective defect.
  FlowModule(const Exec& exec, const Scene& scene, const LatticeUnits& units, const Geometry& geometry,
             bool carries_scalars);

  std::string_view name() const override { return "flow"; }
  void step(const Exec& exec, const Clock& clock) override;
  void births(const Exec& exec, const Births& births) override;
  void guard(const Exec& exec, const Clock& clock) override;
  void limits(LimitTable& table) const override;
  void ledger(Ledger& ledger) const override;
  void history(std::vector<HistoryValue>& row) const override;
  void fields(FieldList& list) const override;
  void state(StateList& list) override;

  const FlowFields<T>& flow() const { return fields_; }
  /// (fluid) advective defect of the velocity that the scalars were last collided with (advective_form.hpp).
  const ScalarField<T>& defect() const { return defect_; }

 private:
  void find_boundaries(const Exec& exec);
  void dress(const Exec& exec, const StretchLinks& boundary, double time) const;

  FlowSection section_;
  LatticeUnits units_;
  const Geometry& geometry_;
  bool carries_scalars_;
  std::vector<StretchLinks> boundaries_;
  FlowFields<T> fields_;
  FlowStep<T> step_;
  ScalarField<T> defect_;
  double initial_mass_ = 0;  ///< lattice units, as are all sums below
  double born_mass_ = 0;
};

}  // namespace vug
