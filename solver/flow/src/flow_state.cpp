#include "parapet/flow/flow_state.hpp"

namespace parapet::solver {

std::size_t FlowState::bytes() const {
  std::size_t numbers = built_x.size() + built_z.size() + picked_x.size() + picked_z.size();
  fluid.for_each_field(
      [&](const FieldInfo&, const std::vector<double>& array) { numbers += array.size(); });
  return sizeof(FlowState) + numbers * sizeof(double) + fluid.id.size() * sizeof(std::int32_t) +
         departures.size() * sizeof(Departure);
}

}  // namespace parapet::solver
