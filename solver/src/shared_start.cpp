#include "shared_start.hpp"

#include <algorithm>
#include <utility>

#include "parapet/flow/index.hpp"

namespace parapet::solver {

SharedStart::SharedStart(StartStates* starts, const Scene& scene, const Numerics& numerics,
                         const RunOptions& options)
    : store_(starts != nullptr ? &starts->store() : nullptr) {
  if (store_ != nullptr) shared_.emplace(scene, numerics, options);
}

std::int64_t SharedStart::resume(Flow& flow, Recorder& recorder, std::int64_t samples) {
  if (store_ == nullptr) return 0;
  const Numerics& numerics = flow.setup().numerics;
  const double reach = (2.0 + numerics.skin_ratio) * flow.smoothing_length();
  sight_.emplace(recorder.gauge(), reach);
  const auto start = store_->latest(*shared_, *sight_, static_cast<std::size_t>(samples));
  if (start == nullptr) return 0;
  flow.resume(start->flow);
  recorder.catch_up(start->record);
  record_ = start->record;
  return static_cast<std::int64_t>(record_.samples.size());
}

void SharedStart::stepped(const Flow& flow) {
  if (store_ == nullptr) return;
  const Fluid& f = flow.fluid();
  for (std::size_t i = 0; i < at(f.n); ++i) {
    reach_.x = std::max(reach_.x, f.x[i]);
    reach_.z = std::max(reach_.z, f.z[i]);
  }
  record_.steps.push_back({flow.last_time_step(), flow.time()});
}

void SharedStart::sampled(const Flow& flow, const Recorder& recorder) {
  if (store_ == nullptr) return;
  record_.samples.push_back(recorder.last_sample());
  record_.reaches.push_back(std::exchange(reach_, {0.0, 0.0}));
  // at the release nothing moves yet
  if (flow.time() == 0.0) return;
  const RecordedStart::Reach& reach = record_.reaches.back();
  if (!sight_->clear(reach.x, reach.z) || !recorder.all_moving(flow)) {
    store_ = nullptr;
    return;
  }
  if (!store_->wants(*shared_, record_.samples.size())) return;
  store_->add(*shared_, std::make_shared<const Start>(Start{flow.state(), record_}));
}

}  // namespace parapet::solver
