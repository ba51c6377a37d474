#pragma once
// How much faster the rock may age than the fluid (accuracy.dissolution_tolerance; docs/model.md, "Slow scenes").
#include "coupling/module.hpp"

#include <algorithm>
#include <vector>

namespace vug {

inline constexpr double largest_factor = 1e6;  ///< upper limit, as for accuracy.dissolution_factor

/// The factor by which the rock ages faster than the fluid until the next look. `factor` is the one since the last
/// look; `seen` is the largest of the following, each of which grows with the factor and should be at most `tolerance`:
/// the share by which the reaction may be off its steady state; the share of a cell that a wall node has lost between
/// two looks for dissolved nodes; the share of its age by which the rock has aged. The factor at most doubles, as the
/// step of an integrator does.
inline double next_factor(double factor, double seen, double tolerance) {
  constexpr double safety = 0.75;  // the effect of pores that have just opened shows at the next look only
  const double change = seen > 0 ? std::min(2.0, safety * tolerance / seen) : 2;
  return std::clamp(change * factor, 1.0, largest_factor);
}

/// The largest factor until the next look, which is `look` s of the fluid away, for rock of this age (s). The rock is
/// to go through each of the `moments` (ascending) at the factor 1, because given values bend there, which no look can
/// foresee.
inline double factor_before(const std::vector<double>& moments, double age, double look) {
  const auto next = std::upper_bound(moments.begin(), moments.end(), age);
  return next == moments.end() ? largest_factor : std::max(1.0, (*next - age) / look - 1);
}

/// Chooses the factor during the run.
class Ageing : public Module {
 public:
  /// The present factor.
  double factor() const { return factor_; }
  /// Estimated bound of the relative error of the dissolved volume that ageing has caused so far.
  double error() const { return paid_ > 0 ? error_ / paid_ : 0; }
  double tolerance() const { return tolerance_; }
  double residual() const { return residual_; }            ///< at the last look
  double largest() const { return largest_; }              ///< largest factor so far
  std::int64_t waits() const { return waits_; }            ///< how often the factor has fallen back to 1
  std::int64_t waiting_steps() const { return waiting_; }  ///< lattice steps at the factor 1

  std::string_view name() const override { return "ageing"; }
  void history(std::vector<HistoryValue>& row) const override {
    row.push_back({"dissolution_factor_1", factor_});
    row.push_back({"dissolution_error_1", error()});
  }

 protected:
  explicit Ageing(double tolerance) : tolerance_(tolerance) {}
  /// What was found since the last look, which was `steps` lattice steps ago.
  struct Look {
    double made;      ///< volume that has dissolved, m3/m
    double residual;  ///< share by which the reaction may be off its steady state
    double loss;      ///< largest share of a cell that a wall node has lost
    double aged;      ///< share of its age by which the rock has aged
    bool still;       ///< the flow is steady
    std::int64_t steps;
    double most = largest_factor;  ///< largest factor until the next look
  };
  void take_in(const Look& look);
  void add_state(StateList& list);

 private:
  double tolerance_, factor_ = 1, largest_ = 1, residual_ = 0;
  double paid_ = 0, error_ = 0;  ///< m3/m, dissolved volume and its possible error
  std::int64_t waits_ = 0, waiting_ = 0;
};

}  // namespace vug
