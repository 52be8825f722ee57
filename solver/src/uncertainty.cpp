#include "parapet/solver/uncertainty.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

namespace parapet::solver {
namespace {

void require_sound_plan(const UncertaintyPlan& plan) {
  const auto& levels = plan.levels;
  bool sound = levels.size() >= 3 && levels.front().spacing_ratio == 1.0, repeated = false;
  for (std::size_t k = 0; k < levels.size(); ++k) {
    sound = sound && levels[k].runs >= 1 &&
            (k == 0 || levels[k].spacing_ratio > levels[k - 1].spacing_ratio);
    repeated = repeated || levels[k].runs >= 2;
  }
  if (!sound || !repeated || !(plan.lattice_jitter > 0.0) || plan.jobs < 1) {
    throw std::invalid_argument(
        "an uncertainty needs at least three levels with rising spacing ratios, the first of them "
        "1, "
        "a run at each and two at one of them, a positive lattice jitter and at least one job");
  }
}

struct Run {
  std::size_t level;
  Numerics numerics;
  double cost;  // relative
  Result result;
};

std::vector<Run> planned_runs(const Numerics& numerics, const UncertaintyPlan& plan) {
  std::vector<Run> runs;
  for (std::size_t level = 0; level < plan.levels.size(); ++level) {
    const auto& [ratio, count] = plan.levels[level];
    for (int k = 0; k < count; ++k) {
      Run run{level, numerics, 1.0 / (ratio * ratio * ratio), {}};
      run.numerics.spacing *= ratio;
      if (k > 0) {
        run.numerics.lattice_jitter = plan.lattice_jitter;
        run.numerics.lattice_seed = numerics.lattice_seed + static_cast<unsigned>(k);
      }
      runs.push_back(run);
    }
  }
  return runs;
}

// Share of all work; runs go on side by side.
class Progressed {
 public:
  Progressed(const std::vector<Run>& runs, const std::function<bool(double)>& tell)
      : share_(runs.size(), 0.0), tell_(tell) {
    for (const Run& run : runs) costs_.push_back(run.cost);
  }
  bool report(std::size_t run, double share) {
    const std::scoped_lock lock(mutex_);
    share_[run] = share;
    double done = 0.0, all = 0.0;
    for (std::size_t k = 0; k < costs_.size(); ++k) {
      done += share_[k] * costs_[k];
      all += costs_[k];
    }
    if (tell_ && !tell_(done / all)) cancelled_ = true;
    return !cancelled_;
  }
  bool cancelled() const { return cancelled_; }

 private:
  std::mutex mutex_;
  std::vector<double> share_, costs_;
  const std::function<bool(double)>& tell_;
  std::atomic<bool> cancelled_ = false;
};

std::optional<MetricUncertainty> uncertainty_of(const std::string& key,
                                                const std::vector<Run>& runs,
                                                const UncertaintyPlan& plan) {
  const std::size_t n_levels = plan.levels.size();
  std::vector<double> sum(n_levels, 0.0), square(n_levels, 0.0), count(n_levels, 0.0), spacing;
  for (const Run& run : runs) {
    const Metric* metric = run.result.find_metric(key);
    if (run.result.status != Status::ok || !metric || !metric->value) return std::nullopt;
    sum[run.level] += *metric->value;
    count[run.level] += 1.0;
  }
  for (std::size_t k = 0; k < n_levels; ++k) {
    sum[k] /= count[k];
    spacing.push_back(plan.levels[k].spacing_ratio);
  }
  double spread = 0.0, freedom = 0.0;
  for (const Run& run : runs) {
    const double off = *run.result.find_metric(key)->value - sum[run.level];
    spread += off * off;
  }
  for (const double n : count) freedom += n - 1.0;
  const DiscretisationError error = discretisation_error(spacing, sum);
  MetricUncertainty u;
  u.discretisation = error.uncertainty;
  u.scatter = std::sqrt(spread / freedom);
  u.expanded = std::hypot(u.discretisation, 2.0 * u.scatter);
  u.extrapolated = error.extrapolated;
  u.order = error.order;
  u.order_observed = error.order_observed;
  u.runs = static_cast<int>(runs.size());
  for (double& ratio : spacing) ratio *= runs.front().numerics.spacing;
  u.level_spacing = std::move(spacing);
  u.level_mean = std::move(sum);
  return u;
}

}  // namespace

Result simulate_with_uncertainty(const Scene& scene, const Numerics& numerics,
                                 const RunOptions& options, const UncertaintyPlan& plan,
                                 const std::function<bool(double)>& on_progress,
                                 const std::function<void(const Frame&)>& on_frame) {
  require_sound_plan(plan);
  std::vector<Run> runs = planned_runs(numerics, plan);
  Progressed progressed(runs, on_progress);
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::exception_ptr failure;
  const auto work = [&] {
    for (std::size_t k = next++; k < runs.size(); k = next++) {
      try {
        Callbacks callbacks;
        callbacks.on_progress = [&](const Progress& p) {
          return progressed.report(k, p.time / p.stop_time);
        };
        RunOptions own = options;
        if (k == 0) {
          callbacks.on_frame = on_frame;
        } else {
          own.frame_interval = 0.0;
          own.frame_times.clear();
        }
        if (progressed.cancelled() && k > 0) return;
        runs[k].result = simulate(scene, runs[k].numerics, own, callbacks);
        progressed.report(k, 1.0);
      } catch (...) {
        const std::scoped_lock lock(mutex);
        if (!failure) failure = std::current_exception();
        return;
      }
    }
  };
  {
    std::vector<std::jthread> others;
    for (int j = 1; j < plan.jobs; ++j) others.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
  Result result = runs.front().result;
  if (progressed.cancelled()) {
    result.status = Status::cancelled;
    result.stop_reason = StopReason::cancelled;
    return result;
  }
  for (Metric& metric : result.metrics) {
    metric.uncertainty = uncertainty_of(metric.key, runs, plan);
  }
  return result;
}

}  // namespace parapet::solver
