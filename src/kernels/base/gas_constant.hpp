#pragma once

namespace vug {

inline constexpr double gas_constant = 8.314462618;  ///< J/(mol K)

}  // namespace vug
