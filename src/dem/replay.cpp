// Sub-steps that consist of the same two kernels, as one launch on a GPU.
#include "dem/forces.hpp"
#include "dem/mechanics.hpp"

#include <algorithm>

namespace vug {

namespace {

constexpr int longest_replay = 16;  // sub-steps: there may be one recording for every length

}  // namespace

int Mechanics::alike(int most) const {
  const bool more_kernels = accounts_ || timed_ || share_ || !servos_.empty();
  if (runs_on_host || more_kernels) return 0;
  const auto as_others = [&](long step) {
    return step % steps_between_searches != 0 && !(rest_ && step % steps_between_looks == 0);
  };
  int count = 0;
  while (count < std::min(most, longest_replay) && as_others(steps_ + count)) ++count;
  return count;
}

/// A recording can be replayed because everything that changes from one sub-step to the next, or that others change
/// between them, is in Views that stay where they are.
void Mechanics::replay(const Exec& exec, const StepControl& control, int count) {
  if (recorded_dt_ != control.dt) recorded_.clear();
  recorded_dt_ = last_dt_ = control.dt;
  auto found = recorded_.find(count);
  if (found == recorded_.end()) {
    Recording recording(exec);
    const Queue queue(exec, recording);
    for (int s = 0; s < count; ++s) {
      compute_forces(queue, parameters_, control.dt, particles_, bonds_, contacts_, NoAccounts{},
                     {rest_ ? &rest_->bonds : nullptr});
      integrate(queue, control, bonds_, contacts_, loads_, particles_, NoAccounts{},
                rest_ ? &rest_->particles : nullptr);
    }
    found = recorded_.emplace(count, recording).first;
  }
  found->second.replay(exec, "vug::dem::substeps");
  steps_ += count;
}

}  // namespace vug
