/// The neighbour rows of a step: of the pairs that the kernel reaches, each group's slots side by
/// side (RowView).
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "parapet/flow/neighbor_rows.hpp"

namespace parapet::solver {

/// Picked anew for every step from what may be near.
class StepRows {
 public:
  /// @param arrays the fluid with its records up to date, walls and constants; their rows are not
  ///        looked at
  void pick(const PassTable& passes, const FlowArrays& arrays, const NeighborRows& rows,
            int threads);
  /// With the rows of the wall points; valid until the next pick, or the next build of `rows`.
  RowView view(const NeighborRows& rows) const;

 private:
  std::vector<std::int32_t> begin_, wall_begin_, end_;
  // Not written before it is needed: most of the room that is kept for dense flows takes no memory.
  std::unique_ptr<std::int32_t[]> index_;
  std::int32_t room_ = 0;
};

}  // namespace parapet::solver
