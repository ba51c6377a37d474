#pragma once
// Looks how far the acid is from its steady state and lets the rock age as fast as that allows.
#include "coupling/ageing.hpp"
#include "coupling/reaction_module.hpp"

namespace vug {

/// Stands after the solutes, which it watches, and before what has reacted is booked. `flow` may be null.
template <class T, class Set>
class AgeingModule final : public Ageing {
 public:
  AgeingModule(const Scene& scene, const Geometry& geometry, ReactionModule<T, Set>& reaction,
               const FlowModule<T>* flow);

  void step(const Exec& exec, const Clock& clock) override;
  void tasks(std::vector<Task>& schedule) const override;
  void visit_shares(const SharedFields& visit) const override;
  void births(const Exec& exec, const Births& births) override;
  void state(StateList& list) override;

 private:
  using Sway = typename ReactionModule<T, Set>::Sway;
  struct Watched {
    Sway sway;
    ScalarField<T> before;  ///< (fluid) concentration at the last look
  };
  /// Volume, at the factor 1, that what has come and gone in the nodes since the last look could have dissolved, m3/m.
  double unsteady(const Exec& exec);

  const Geometry& geometry_;
  ReactionModule<T, Set>& reaction_;
  const FlowModule<T>* flow_;
  int interval_;                 ///< lattice steps between looks
  std::vector<double> moments_;  ///< s, at which what the boundaries are given bends
  std::vector<Watched> watched_;
  ScalarField<double> change_;  ///< (block) room for a sum
  int compared_;                ///< fluid nodes that were there at the last look
  double paid_before_ = 0;
};

}  // namespace vug
