#include "coupling/concerns.hpp"

namespace vug {

void GivenFluxes::add(const std::string& key, const TimeTable& flux) {
  if (draws.empty() && flux.lowest() < 0) draws = key;
  if (puts_in.empty() && flux.highest() > 0) puts_in = key;
}

}  // namespace vug
