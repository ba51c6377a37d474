// Reports of the reactions: limits, and balances of acid, product and rock, in total and for each mineral.
#include "coupling/reaction_module.hpp"
#include "io/units.hpp"
#include "kernels/launch/launch.hpp"
#include "kernels/reaction/surface_normal.hpp"

#include <algorithm>
#include <limits>
#include <type_traits>

namespace vug {

namespace {

/// The largest concentration of a species that the case gives, over the unit; 1 where it gives none but fluxes.
template <class T>
double strongest(const SpeciesState<T>& species, double unit) {
  double largest = species.section.initial;
  for (const StretchLinks& boundary : species.boundaries) {
    const auto& given = boundary.stretch.conditions.solute.concentration;
    if (const auto found = given.find(species.section.name); found != given.end())
      largest = std::max(largest, found->second.highest());
  }
  return largest > 0 ? largest / unit : 1;
}

/// Damkohler number of a node below which the paper's wall takes another amount of acid in single than in double
/// precision, by 0.4 % there and by half at 1e-6 (docs/model.md).
constexpr double slowest_paper_wall_in_single = 3e-5;

}  // namespace

template <class T, class Set>
void ReactionModule<T, Set>::limits_of(const Attack<T>& attack, const RateLaw& rate, const std::string& name,
                                       LimitTable& table) const {
  const double k0 = scaled(rate), activation = rate.activation_energy / gas_constant;
  const double D = attack.reactant->parameters.diffusivity();
  const auto row = [&](const char* at, double kelvin) {
    const double k = arrhenius(k0, activation, kelvin, section_.reference_temperature);
    Limit limit{"reaction", "Damkohler number of a node, k dx/D, " + name + at,
                k / D,      "1",
                0,          std::numeric_limits<double>::infinity(),
                ""};
    if (std::is_same_v<T, float> && section_.wall == ReactiveWallLaw::paper && k > 0) {
      limit.low = slowest_paper_wall_in_single;
      limit.advice =
          "the paper's wall loses so slow a reaction in single precision: use accuracy.precision = \"double\" or "
          "reaction.wall = \"kinetic\" (docs/model.md)";
    }
    table.push_back(limit);
  };
  if (heat_) {
    row("coldest", heat_->range().coldest);
    row("hottest", heat_->range().hottest);
  } else {
    row("at the case's temperature", section_.temperature);
  }
}

template <class T, class Set>
void ReactionModule<T, Set>::limits(LimitTable& table) const {
  double most = 0;  // volume dissolved per volume of acid
  for (const Attack<T>& attack : attacks_) {
    const std::string of = attack.key.empty() ? "" : attack.key + ", ";
    const double acid = strongest(*attack.reactant, units_.concentration);
    if (!has_minerals()) limits_of(attack, attack.rate, of, table);
    if (!has_minerals()) most = std::max(most, acid * volume_per_acid(section_.molar_volume, attack.rate));
    for (std::size_t m = 0; m < solids_.size(); ++m) {
      if (solids_[m].name.empty() || attack.rates[m].rate_constant == 0) continue;
      limits_of(attack, attack.rates[m], of + solids_[m].name + ", ", table);
      most = std::max(most, acid * volume_per_acid(attack, m));
    }
  }
  const double coldest = heat_ ? heat_->range().coldest : section_.temperature;
  const double hottest = heat_ ? heat_->range().hottest : section_.temperature;
  const char* clamped = "beyond the range of Arrhenius' law the rate is that of its nearest end";
  table.push_back({"reaction", "lowest temperature", coldest, "K", coldest_reaction, hottest_reaction, clamped});
  table.push_back({"reaction", "highest temperature", hottest, "K", coldest_reaction, hottest_reaction, clamped});
  const char* per_acid = "volume dissolved per volume of the strongest acid";
  if (factor_ > 1 && !varies_)  // a factor that the run chooses is limited by its tolerance
    table.push_back({"reaction", per_acid, most, "1", 0, 0.1 + 1e-9,
                     "lower accuracy.dissolution_factor: the error is about a third of this (docs/accuracy.md)"});
  else if (dissolves_)  // concerns() warns where the surface follows too late, or more dissolves than there is
    table.push_back({"reaction", per_acid, most / factor_, "1", 0, std::numeric_limits<double>::infinity(), ""});
  if (section_.wall == ReactiveWallLaw::paper && Set::Q == D2Q9::Q)
    table.push_back({"reaction", "diffusivity for the paper's wall on D2Q9",
                     attacks_[0].reactant->parameters.diffusivity(), "lattice", 0.05, 1,
                     "use reaction.wall = \"kinetic\" or solute.velocity_set = \"d2q5\" (docs/stability.md)"});
}

template <class T, class Set>
std::vector<double> ReactionModule<T, Set>::of_minerals(const ScalarField<double>& values) const {
  return sums_by_mineral(Exec{}, "vug::minerals::sum", geometry_.lattice.size(), values, geometry_.mineral, minerals());
}

template <class T, class Set>
std::vector<double> ReactionModule<T, Set>::of_links(const Attack<T>& attack, const ScalarField<double>& values) const {
  return sums_by_mineral(Exec{}, "vug::minerals::sum_of_links", attack.links.count, values, attack.links.mineral,
                         minerals());
}

template <class T, class Set>
double ReactionModule<T, Set>::volume_per_acid(const Attack<T>& attack, std::size_t m) const {
  return volume_per_acid(solids_[m].molar_volume, attack.rates[m]);
}

template <class T, class Set>
std::vector<double> ReactionModule<T, Set>::dissolving_of_minerals() const {
  std::vector<double> volumes(solids_.size(), 0);
  for (const Attack<T>& attack : attacks_) {
    const std::vector<double> reacted = of_links(attack, attack.links.solid);
    for (std::size_t m = 0; m < volumes.size(); ++m) volumes[m] += volume_per_acid(attack, m) * reacted[m];
  }
  return volumes;
}

template <class T, class Set>
double ReactionModule<T, Set>::with_dissolving(double volume, double sign) const {
  if (has_minerals())
    for (const double dissolving : dissolving_of_minerals()) volume += sign * dissolving;
  else
    for (const Attack<T>& attack : attacks_)
      volume += sign * volume_per_acid(section_.molar_volume, attack.rate) * sum_in_order(attack.links.solid);
  return volume;
}

template <class T, class Set>
std::vector<double> ReactionModule<T, Set>::acid_of_minerals(const Attack<T>& attack) const {
  std::vector<double> acid = of_minerals(attack.sums.acid);
  const std::vector<double> not_booked = of_links(attack, attack.links.acid);
  for (std::size_t m = 0; m < acid.size(); ++m) acid[m] += not_booked[m];
  return acid;
}

template <class T, class Set>
double ReactionModule<T, Set>::paid_for(const Attack<T>& attack, double consumed) const {
  if (!has_minerals())
    return units_.volume() * volume_per_acid(section_.molar_volume, attack.rate) * attack.aged[0].at(consumed, factor_);
  const std::vector<double> acid = acid_of_minerals(attack);
  double volume = 0;
  for (std::size_t m = 0; m < acid.size(); ++m)
    volume += volume_per_acid(attack, m) * attack.aged[m].at(acid[m], factor_);
  return units_.volume() * volume;
}

template <class T, class Set>
double ReactionModule<T, Set>::consumed(const Attack<T>& attack) const {
  return attack.consumed.total() + sum_in_order(attack.links.acid);
}

template <class T, class Set>
double ReactionModule<T, Set>::released(const Attack<T>& attack, double consumed) const {
  const ScalarField<double>& booked = attack.sums.released;
  if (booked.extent(0) > 0) return sum_in_order(booked) + sum_in_order(attack.links.product);
  if (!has_minerals()) return attack.rate.product_yield() * consumed;
  const std::vector<double> acid = acid_of_minerals(attack);
  double product = consumed;
  for (std::size_t m = 0; m < acid.size(); ++m) product -= (1 - attack.rates[m].product_yield()) * acid[m];
  return product;
}

template <class T, class Set>
double ReactionModule<T, Set>::paid() const {
  gather_links();
  double volume = 0;
  for (const Attack<T>& attack : attacks_) volume += paid_for(attack, consumed(attack));
  return volume;
}

template <class T, class Set>
std::vector<typename ReactionModule<T, Set>::Sway> ReactionModule<T, Set>::sways() const {
  std::vector<Sway> sways;
  std::vector<double> own, most;  // (reactant) volume that a mole dissolves; moles of product that it becomes
  for (const Attack<T>& attack : attacks_) {
    double volume = 0, back = 0, yield = 1, most_yield = 0;
    const auto note = [&](double molar_volume, const RateLaw& rate) {
      volume = std::max(volume, units_.volume() * volume_per_acid(molar_volume, rate) / factor_);
      most_yield = std::max(most_yield, rate.product_yield());
      if (rate.inverse_equilibrium_constant <= back) return;
      back = rate.inverse_equilibrium_constant;
      yield = rate.product_yield();
    };
    if (!has_minerals()) note(section_.molar_volume, attack.rate);
    for (std::size_t m = 0; m < solids_.size(); ++m) note(solids_[m].molar_volume, attack.rates[m]);
    sways.push_back({attack.reactant, volume});
    own.push_back(volume);
    most.push_back(most_yield);
    if (attack.product && back > 0) sways.push_back({attack.product, volume * back / (1 + back * yield)});
  }
  // what a reactant dissolves by way of its product, where that is a reactant as well, and so on
  for (std::size_t r = 0; r < attacks_.size(); ++r) {
    double volume = own[r], moles = 1;
    std::size_t at = r;
    for (std::size_t link = 1; link < attacks_.size(); ++link) {
      const auto next = std::find_if(attacks_.begin(), attacks_.end(), [&](const Attack<T>& other) {
        return attacks_[at].product && other.reactant == attacks_[at].product;
      });
      if (next == attacks_.end()) break;
      moles *= most[at];
      at = static_cast<std::size_t>(next - attacks_.begin());
      volume += moles * own[at];
    }
    for (Sway& sway : sways)
      if (sway.species == attacks_[r].reactant) sway.volume = std::max(sway.volume, volume);
  }
  return sways;
}

template <class T, class Set>
void ReactionModule<T, Set>::ledger(Ledger& ledger) const {
  gather_links();
  const double mol = units_.amount();
  std::vector<double> paid;
  for (const Attack<T>& attack : attacks_) {
    const double consumed = this->consumed(attack);
    const std::string reaction = attack.key.empty() ? "reaction" : "reaction_of_" + attack.key;
    ledger.of(attack.reactant->section.name, "mol/m").gains.push_back({reaction, -mol * consumed});
    if (attack.product)
      ledger.of(attack.product->section.name, "mol/m").gains.push_back({reaction, mol * released(attack, consumed)});
    if (dissolves_) paid.push_back(paid_for(attack, consumed));
  }
  if (!dissolves_) return;
  const double dissolved = with_dissolving(sum_in_order(geometry_.dissolved), 1);
  Balance& solid = ledger.of("solid_volume", "m3/m");
  solid.initial = units_.volume() * initial_volume_;
  solid.stored = units_.volume() * with_dissolving(sum_in_order(geometry_.volume), -1);
  solid.gains.push_back({"dissolved", -units_.volume() * dissolved});
  solid.gains.push_back({"overdrawn", -units_.volume() * sum_in_order(lost_)});
  Balance& reaction = ledger.of("dissolved_volume", "m3/m");
  reaction.stored = units_.volume() * dissolved;
  for (std::size_t r = 0; r < attacks_.size(); ++r)
    reaction.gains.push_back({(r == 0 ? "acid" : attacks_[r].key) + "_times_molar_volume", paid[r]});
  if (has_minerals()) mineral_ledger(ledger);
}

template <class T, class Set>
void ReactionModule<T, Set>::mineral_ledger(Ledger& ledger) const {
  const std::vector<double> volume = of_minerals(geometry_.volume), booked = of_minerals(geometry_.dissolved);
  const std::vector<double> dissolving = dissolving_of_minerals();
  std::vector<std::vector<double>> acid;
  for (const Attack<T>& attack : attacks_) acid.push_back(acid_of_minerals(attack));
  for (std::size_t m = 0; m < solids_.size(); ++m) {
    const Solid& kind = solids_[m];
    if (kind.name.empty()) continue;
    const double dissolved = booked[m] + dissolving[m], pixel = units_.volume();
    Balance& solid = ledger.of(kind.name + "_volume", "m3/m");
    solid.initial = pixel * kind.initial;
    solid.stored = pixel * (volume[m] - dissolving[m]);
    solid.gains.push_back({"dissolved", -pixel * dissolved});
    solid.gains.push_back({"overdrawn", -pixel * sum_in_order(losses_.of_minerals.lost[m])});
    if (kind.molar_volume == 0) continue;
    Balance& amount = ledger.of(kind.name + "_dissolved", "mol/m");
    amount.stored = pixel * dissolved / kind.molar_volume;
    for (std::size_t r = 0; r < attacks_.size(); ++r)
      amount.gains.push_back({"by_" + attacks_[r].reactant->section.name,
                              factor_ * units_.amount() * attacks_[r].aged[m].at(acid[r][m], factor_) /
                                  attacks_[r].rates[m].stoichiometry});
  }
}

template <class T, class Set>
ReactingNodes ReactionModule<T, Set>::reacting_nodes() const {
  if (!has_minerals()) return {};
  const Kokkos::View<std::uint8_t*> reacts("vug::minerals::reacts", solids_.size());
  const auto host = Kokkos::create_mirror_view(reacts);
  for (std::size_t m = 0; m < solids_.size(); ++m)
    host(m) = std::any_of(attacks_.begin(), attacks_.end(),
                          [&](const Attack<T>& attack) { return attack.rates[m].rate_constant > 0; });
  Kokkos::deep_copy(reacts, host);
  return {geometry_.mineral, reacts};
}

template <class T, class Set>
void ReactionModule<T, Set>::history(std::vector<HistoryValue>& row) const {
  gather_links();
  VectorField<double> normal;
  if (section_.surface_normal)
    find_normals(Exec{}, geometry_.fluid, geometry_.surface, geometry_.volume, geometry_.dissolved, normal);
  const bool inert = !has_minerals() && std::all_of(attacks_.begin(), attacks_.end(), [](const Attack<T>& attack) {
    return attack.rate.rate_constant == 0;
  });
  const double area =
      inert ? 0 : surface_area<Set>(Exec{}, geometry_.fluid, geometry_.surface, normal, reacting_nodes());
  row.push_back({"reactive_area_m2_per_m", area * units_.spacing});
  const double dissolved = with_dissolving(sum_in_order(geometry_.dissolved), 1);
  row.push_back({"dissolved_volume_m3_per_m", units_.volume() * dissolved});
}

#define VUG_INSTANTIATE(T, Set)                                                                      \
  template double ReactionModule<T, Set>::consumed(const Attack<T>&) const;                          \
  template double ReactionModule<T, Set>::paid() const;                                              \
  template std::vector<double> ReactionModule<T, Set>::acid_of_minerals(const Attack<T>&) const;     \
  template std::vector<typename ReactionModule<T, Set>::Sway> ReactionModule<T, Set>::sways() const; \
  template void ReactionModule<T, Set>::limits(LimitTable&) const;                                   \
  template void ReactionModule<T, Set>::ledger(Ledger&) const;                                       \
  template void ReactionModule<T, Set>::history(std::vector<HistoryValue>&) const;
VUG_FOR_NUMBERS_AND_SETS(VUG_INSTANTIATE)
#undef VUG_INSTANTIATE

}  // namespace vug
