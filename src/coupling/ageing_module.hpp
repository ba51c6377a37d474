#pragma once
// Determines how far the acid is from its steady state, and lets the rock age as fast as that allows.
#include "coupling/ageing.hpp"
#include "coupling/reaction_module.hpp"

namespace vug {

/// Points of all tables over time at sides, injections and shapes, s, ascending.
std::vector<double> moments_of(const Scene& scene);

/// Comes after the solutes, which it watches, and before what has reacted is booked. `flow` may be null.
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
  /// Volume (m3/m) that could have been dissolved, at the factor 1, by the acid that the nodes have gained or lost
  /// since the last look.
  double unsteady(const Exec& exec);

  const Geometry& geometry_;
  ReactionModule<T, Set>& reaction_;
  const FlowModule<T>* flow_;
  int interval_;                 ///< lattice steps between looks
  std::vector<double> moments_;  ///< s, at which given values of the boundaries bend
  std::vector<Watched> watched_;
  ScalarField<double> change_;  ///< (block) work space for a sum
  int compared_;                ///< number of fluid nodes at the last look
  double paid_before_ = 0;
};

}  // namespace vug
