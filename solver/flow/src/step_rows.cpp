#include "parapet/flow/step_rows.hpp"

#include "parallel.hpp"
#include "parapet/flow/index.hpp"

namespace parapet::solver {

void StepRows::pick(const PassTable& passes, const FlowArrays& arrays, const NeighborRows& rows,
                    int threads) {
  const int n = arrays.fluid.n;
  for (auto* a : {&begin_, &wall_begin_, &end_}) a->resize(at(groups_of(n)));
  const std::vector<std::int32_t>& block_first = rows.block_first();
  if (block_first.back() > room_) {
    room_ = block_first.back();
    index_.reset(new std::int32_t[at(room_)]);
  }
  const NearView near = rows.view();
  for_blocks(n, threads, [&](int begin, int end) {
    const std::unique_ptr<std::int32_t[]> scratch(new std::int32_t[at(lanes * rows.room())]);
    passes.reached_rows(arrays, near,
                        {begin_.data(), wall_begin_.data(), end_.data(), index_.get(),
                         block_first[at(begin / block_size)], scratch.get(), rows.room()},
                        begin, end);
  });
}

RowView StepRows::view(const NeighborRows& rows) const {
  RowView view = rows.wall_point_rows();
  view.begin = begin_.data();
  view.wall_begin = wall_begin_.data();
  view.end = end_.data();
  view.index = index_.get();
  return view;
}

}  // namespace parapet::solver
