#include "coupling/concerns.hpp"

namespace vug {

std::string key_of(const Stretch& stretch) {
  if (stretch.opening) return "boundary.shape." + stretch.name.substr(std::string("shape_").size());
  return "boundary." + stretch.name;
}

void GivenFluxes::add(const std::string& key, const TimeTable& flux) {
  if (draws.empty() && flux.lowest() < 0) draws = key;
  if (puts_in.empty() && flux.highest() > 0) puts_in = key;
}

}  // namespace vug
