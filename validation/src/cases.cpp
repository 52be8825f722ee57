#include "cases.hpp"

#include <array>

namespace parapet::validation {

std::span<const Case> all_cases() {
  static constexpr auto cases = std::to_array<Case>({
      {"plane_flows", "Plane Poiseuille and Couette flow", plane_flows},
  });
  return cases;
}

}  // namespace parapet::validation
