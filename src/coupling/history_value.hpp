#pragma once
// A number in history.csv.
#include <string>

namespace vug {

struct HistoryValue {
  std::string name;  ///< with its unit: "time_s"
  double value;
};

}  // namespace vug
