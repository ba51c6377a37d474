#include "ranks/stop.hpp"

#include "host/interruption.hpp"

namespace vug {

bool any_is_to_stop(const Ranks& ranks) {
  const int signal = ranks.most(stop_signal());
  if (signal != 0) request_stop(signal);
  return signal != 0;
}

void throw_if_any_is_to_stop(const Ranks& ranks) {
  if (any_is_to_stop(ranks)) throw_if_stop_requested();
}

}  // namespace vug
