#include "frame_clock.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "parapet/flow/stage_timer.hpp"

namespace parapet::solver {
namespace {

/// Steps end within this share of a sample's interval of where they should.
constexpr double rounding = 1e-9;

Frame frame_of(const Flow& flow, double time) {
  const Fluid& f = flow.fluid();
  const auto n = static_cast<std::size_t>(f.n);
  const std::size_t points = flow.walls().size();
  const auto part = [](const std::vector<double>& values, std::size_t count) {
    return std::span<const double>(values.data(), count);
  };
  return {.time = time,
          .last = false,
          .x = part(f.x, n),
          .z = part(f.z, n),
          .u = part(f.u, n),
          .w = part(f.w, n),
          .density = part(f.density, n),
          .pressure = part(f.pressure, n),
          .viscosity = part(f.viscosity, n),
          .id = std::span<const std::int32_t>(f.id.data(), n),
          .wall_x = part(flow.walls().x, points),
          .wall_z = part(flow.walls().z, points),
          .mass = part(f.mass, n)};
}

void copy(std::vector<double>& to, std::span<const double> from) {
  to.assign(from.begin(), from.end());
}

}  // namespace

FrameClock::FrameClock(const RunOptions& options, const Callbacks& callbacks)
    : options_(options),
      callbacks_(callbacks),
      wanted_(callbacks.on_frame && frames_wanted(options)) {}

// Three times 0.05 s is 0.15000000000000002 s: the decimal number is taken that is meant, where
// there is one within rounding.
double FrameClock::regular_time() const {
  const double time = static_cast<double>(regular_) * options_.frame_interval;
  const double meant = std::round(time * 1e9) / 1e9;
  return std::abs(meant - time) <= 4.0 * std::numeric_limits<double>::epsilon() * time ? meant
                                                                                       : time;
}

double FrameClock::next_time() const {
  double next = std::numeric_limits<double>::infinity();
  if (options_.frame_interval > 0.0) next = regular_time();
  if (chosen_ < options_.frame_times.size()) next = std::min(next, options_.frame_times[chosen_]);
  return next;
}

// One time may be asked for twice.
void FrameClock::advance() {
  const double time = next_time();
  if (options_.frame_interval > 0.0 && regular_time() <= time) ++regular_;
  while (chosen_ < options_.frame_times.size() && options_.frame_times[chosen_] <= time) ++chosen_;
}

void FrameClock::begin(Flow& flow) {
  if (!wanted_) return;
  while (next_time() <= flow.time()) {
    show(flow, next_time(), false);
    advance();
  }
}

void FrameClock::before_step(Flow& flow, double reached) {
  kept_ = wanted_ && next_time() < reached;
  if (kept_) keep(flow);
}

void FrameClock::after_step(Flow& flow) {
  if (!wanted_) return;
  const double now = flow.time(), near = rounding * options_.series_interval;
  for (double next = next_time(); next <= now + near; next = next_time()) {
    if (next >= now - near || !kept_) {
      show(flow, next, false);  // the step ends there, but for rounding
    } else {
      show_between(flow, next);
    }
    advance();
  }
}

void FrameClock::end(Flow& flow) {
  if (!wanted_) return;
  const bool shown = std::abs(flow.time() - last_shown_) <= rounding * options_.series_interval;
  show(flow, shown ? last_shown_ : flow.time(), true);
}

void FrameClock::show(Flow& flow, double time, bool last) {
  const StageScope scope(flow.setup().timer, Stage::output);
  flow.refresh();
  Frame frame = frame_of(flow, time);
  frame.last = last;
  callbacks_.on_frame(frame);
  last_shown_ = time;
}

void FrameClock::keep(Flow& flow) {
  const StageScope scope(flow.setup().timer, Stage::output);
  flow.refresh();
  const Frame frame = frame_of(flow, flow.time());
  before_.time = frame.time;
  copy(before_.x, frame.x);
  copy(before_.z, frame.z);
  copy(before_.u, frame.u);
  copy(before_.w, frame.w);
  copy(before_.density, frame.density);
  copy(before_.pressure, frame.pressure);
  copy(before_.viscosity, frame.viscosity);
  before_.id.assign(frame.id.begin(), frame.id.end());
}

// Steps sort the particles; who has left by the end of the step is left out.
void FrameClock::show_between(Flow& flow, double time) {
  const StageScope scope(flow.setup().timer, Stage::output);
  flow.refresh();
  Frame frame = frame_of(flow, time);
  const double share = (time - before_.time) / (flow.time() - before_.time);
  std::int32_t most = -1;
  for (const std::int32_t id : before_.id) most = std::max(most, id);
  place_.assign(static_cast<std::size_t>(most) + 1, -1);
  for (std::size_t k = 0; k < before_.id.size(); ++k) {
    place_[static_cast<std::size_t>(before_.id[k])] = static_cast<std::int32_t>(k);
  }
  const auto blend = [&](std::vector<double>& to, const std::vector<double>& from,
                         std::span<const double>& view) {
    to.resize(view.size());
    for (std::size_t k = 0; k < view.size(); ++k) {
      const auto old = static_cast<std::size_t>(place_[static_cast<std::size_t>(frame.id[k])]);
      to[k] = from[old] + share * (view[k] - from[old]);
    }
    view = to;
  };
  blend(between_.x, before_.x, frame.x);
  blend(between_.z, before_.z, frame.z);
  blend(between_.u, before_.u, frame.u);
  blend(between_.w, before_.w, frame.w);
  blend(between_.density, before_.density, frame.density);
  blend(between_.pressure, before_.pressure, frame.pressure);
  blend(between_.viscosity, before_.viscosity, frame.viscosity);
  callbacks_.on_frame(frame);
}

}  // namespace parapet::solver
