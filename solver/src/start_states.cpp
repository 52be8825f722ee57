#include "parapet/solver/start_states.hpp"

#include <algorithm>
#include <utility>

#include "start_store.hpp"

namespace parapet::solver {
namespace {

constexpr std::size_t most_starts = 32;  // of one flow

std::size_t bytes_of(const Start& start) {
  return start.flow.bytes() + start.record.samples.size() * sizeof(RecordedStart::Sample) +
         start.record.steps.size() * sizeof(RecordedStart::Step);
}

}  // namespace

SharedFlow::SharedFlow(const Scene& scene, const Numerics& flow_numerics, const RunOptions& options)
    : channel(scene),
      numerics(flow_numerics),
      series_interval(options.series_interval),
      retention_change(options.settled.retention_change),
      kinetic_energy_share(options.settled.kinetic_energy_share),
      front_mass_share(options.gauges.front_mass_share) {
  channel.barriers.clear();
  channel.monitor_x = 0.0;
}

std::list<StartStates::Store::Known>::iterator StartStates::Store::find(const SharedFlow& flow) {
  const auto known =
      std::find_if(flows_.begin(), flows_.end(), [&](const Known& k) { return k.flow == flow; });
  if (known != flows_.end()) flows_.splice(flows_.begin(), flows_, known);
  return known;
}

std::shared_ptr<const Start> StartStates::Store::latest(const SharedFlow& flow,
                                                        const GaugeSight& sight,
                                                        std::size_t most_samples) {
  const std::scoped_lock guard(mutex_);
  const auto known = find(flow);
  if (known == flows_.end()) return nullptr;
  for (auto place = known->starts.rbegin(); place != known->starts.rend(); ++place) {
    const Start& start = *place->second;
    if (place->first >= most_samples || !start.record.unseen(sight)) continue;
    ++use_.runs;
    use_.steps += start.flow.progress.statistics.steps;
    return place->second;
  }
  return nullptr;
}

bool StartStates::Store::wants(const SharedFlow& flow, std::size_t samples) {
  const std::scoped_lock guard(mutex_);
  const auto known = find(flow);
  if (known == flows_.end()) return true;
  return samples % known->every == 0 && !known->starts.contains(samples);
}

void StartStates::Store::drop(Known& known, std::size_t samples) {
  const auto place = known.starts.find(samples);
  known.bytes -= bytes_of(*place->second);
  known.starts.erase(place);
}

void StartStates::Store::thin_out(Known& known) {
  while (known.starts.size() > most_starts) {
    known.every *= 2;
    for (auto place = known.starts.begin(); place != known.starts.end();) {
      const std::size_t samples = place->first;
      ++place;
      if (samples % known.every != 0) drop(known, samples);
    }
  }
}

// The newest start stays even where it alone is too large: the next design will ask for it.
void StartStates::Store::make_room(const Known& newest) {
  std::size_t bytes = 0;
  for (const Known& known : flows_) bytes += known.bytes;
  while (bytes > most_bytes_ && &flows_.back() != &newest) {
    bytes -= flows_.back().bytes;
    flows_.pop_back();
  }
  Known& only = flows_.front();
  while (only.bytes > most_bytes_ && only.starts.size() > 1) drop(only, only.starts.begin()->first);
}

void StartStates::Store::add(const SharedFlow& flow, std::shared_ptr<const Start> start) {
  const std::scoped_lock guard(mutex_);
  auto known = find(flow);
  if (known == flows_.end()) {
    flows_.push_front({flow, 1, {}, 0});
    known = flows_.begin();
  }
  const std::size_t samples = start->record.samples.size();
  const std::size_t bytes = bytes_of(*start);
  if (!known->starts.emplace(samples, std::move(start)).second) return;
  known->bytes += bytes;
  thin_out(*known);
  make_room(*known);
}

StartStates::Use StartStates::Store::use() const {
  const std::scoped_lock guard(mutex_);
  return use_;
}

StartStates::StartStates(std::size_t most_bytes) : store_(std::make_unique<Store>(most_bytes)) {}
StartStates::~StartStates() = default;

StartStates::Use StartStates::use() const {
  return store_->use();
}

}  // namespace parapet::solver
