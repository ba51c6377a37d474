// The tasks of a lattice step, module by module, in their order: the schedule of `vug check --schedule`.
// tests/meta/schedule_test.cpp compares it with what steps change.
#include "coupling/ageing_module.hpp"
#include "coupling/flow_module.hpp"
#include "coupling/heat_module.hpp"
#include "coupling/mechanics_module.hpp"
#include "coupling/reaction_module.hpp"
#include "coupling/solute_module.hpp"

namespace vug {

using Names = std::vector<std::string>;

template <class T>
void FlowModule<T>::tasks(std::vector<Task>& schedule) const {
  for (std::size_t c = 0; c < carriers_.size(); ++c)
    schedule.push_back({"flow: defect of the advective form",
                        carriers_[c].interval,
                        {"flow/u"},
                        {"flow/carrier" + std::to_string(c)},
                        {}});
  schedule.push_back(
      {"flow: sides, streaming and collision", 1, needs_temperature() ? Names{"heat/g"} : Names{}, {"flow"}, {}});
  if (excess_.extent(0) > 0)
    schedule.push_back({"flow: mass from node to node", excess_interval_, {"flow/f"}, {"flow/excess"}, {}});
}

template <class T>
void HeatModule<T>::tasks(std::vector<Task>& schedule) const {
  if (carrier_)
    schedule.push_back({"heat: sides, conduction and convection", interval_, {"flow/u", "flow/carrier"}, {"heat"}, {}});
  else
    schedule.push_back({"heat: sides and conduction", interval_, {}, {"heat"}, {}});
}

template <class T, class Set>
Names ReactionModule<T, Set>::names(std::initializer_list<const char*> parts) const {
  Names all;
  for (const Attack<T>& attack : attacks_)
    for (const char* part : parts) all.push_back(attack.state_key() + "/" + part);
  return all;
}

template <class T, class Set>
void ReactionModule<T, Set>::tasks(std::vector<Task>& schedule) const {
  Names reads{"reaction/volume", "reaction/dissolved"}, writes = names({"link_rate", "link_conductance"});
  if (heat_) reads.push_back("heat/g");
  writes.push_back("reaction/refreshed");
  schedule.push_back({"reaction: rates of the links at walls", wall_interval_, reads, writes,
                      names({"consumed"})});  // settled into sums of higher precision (long_sum.hpp)
}

template <class T, class Set>
void SoluteModule<T, Set>::tasks(std::vector<Task>& schedule) const {
  Names reads, writes{"solute"};
  if (carrier_) reads = {"flow/u", "flow/carrier"};
  if (excess_) reads.push_back("flow/excess");
  for (const ReactingSpecies<T>& pair : reacting_) {
    reads.push_back(pair.key + "/link_conductance");
    for (const char* part : {"link_acid", "link_product", "link_solid"}) writes.push_back(pair.key + "/" + part);
  }
  schedule.push_back({reacting_.empty() ? "solutes: sides, streaming and collision"
                                        : "solutes: sides, streaming and collision, reaction at walls",
                      interval_,
                      reads,
                      writes,
                      {}});
}

template <class T, class Set>
void AgeingModule<T, Set>::tasks(std::vector<Task>& schedule) const {
  Names writes = reaction_.names({"aged", "seen"});
  writes.insert(writes.end(), {"ageing", "reaction/factor"});
  schedule.push_back({"ageing: by how much faster the rock ages than the fluid",
                      interval_,
                      reaction_.names({"consumed", "link_acid"}),
                      writes,
                      {}});
}

template <class T, class Set>
void TurnoverModule<T, Set>::tasks(std::vector<Task>& schedule) const {
  schedule.push_back({"reaction: what it has dissolved",
                      update_interval_,
                      {},
                      {"reaction"},
                      reaction_.names({"link_acid", "link_product", "link_solid"})});
}

template <class T>
void MechanicsModule<T>::tasks(std::vector<Task>& schedule) const {
  std::vector<std::string> of_force{"flow/f"};
  if (dissolved_) of_force.emplace_back("mechanics/solid_fraction");  // which triangles are gone
  if (flow_)
    schedule.push_back(
        {"rock: the fluid's force", exchange_interval_, of_force, {"mechanics/force", "mechanics/torque"}, {}});
  if (heat_)
    schedule.push_back({"rock: its temperature", update_interval_, {"heat/g"}, {"mechanics/temperature_change"}, {}});
  if (dissolved_)
    schedule.push_back({"rock: what has dissolved of it",
                        update_interval_,
                        {"reaction/dissolved"},
                        {"mechanics/dissolved_shares", "mechanics/solid_fraction", "mechanics/d_c", "mechanics/lost"},
                        {}});
  schedule.push_back({"rock: sub-steps of bonds, contacts and triangles", 1, {}, {"mechanics"}, {}});
}

#define VUG_INSTANTIATE(T)                                           \
  template void FlowModule<T>::tasks(std::vector<Task>&) const;      \
  template void HeatModule<T>::tasks(std::vector<Task>&) const;      \
  template void MechanicsModule<T>::tasks(std::vector<Task>&) const; \
  VUG_INSTANTIATE_SET(T, D2Q5)                                       \
  VUG_INSTANTIATE_SET(T, D2Q9)
#define VUG_INSTANTIATE_SET(T, Set)                                                       \
  template Names ReactionModule<T, Set>::names(std::initializer_list<const char*>) const; \
  template void ReactionModule<T, Set>::tasks(std::vector<Task>&) const;                  \
  template void SoluteModule<T, Set>::tasks(std::vector<Task>&) const;                    \
  template void AgeingModule<T, Set>::tasks(std::vector<Task>&) const;                    \
  template void TurnoverModule<T, Set>::tasks(std::vector<Task>&) const;
VUG_INSTANTIATE(float)
VUG_INSTANTIATE(double)
#undef VUG_INSTANTIATE_SET
#undef VUG_INSTANTIATE

}  // namespace vug
