/// The designs that a gain is measured against, and the draws of their values.
#include <algorithm>
#include <utility>

#include "as_index.hpp"
#include "composed.hpp"
#include "gain.hpp"
#include "parapet/math/pareto.hpp"

namespace parapet::bayesian {
namespace {

/// What one ask costs grows with these. Of more pending designs some places are left for those that
/// are asked for before the next answer.
constexpr std::size_t most_front_designs = 40, most_pending_designs = 64, places_left = 16;

}  // namespace

void Gain::choose_front_designs(const Input& input) {
  std::vector<const Told*> designs;
  for (const Told& t : input.told) {
    if (!t.ok) continue;
    // Of a design evaluated at several levels the finest counts.
    const auto same = [&](const Told* other) { return same_design(other->x, t.x); };
    const auto found = std::find_if(designs.begin(), designs.end(), same);
    if (found == designs.end()) {
      designs.push_back(&t);
    } else if (t.level < (*found)->level) {
      *found = &t;
    }
  }
  std::vector<Point> xs;
  for (const Told* t : designs) xs.push_back(t->x);
  const Eigen::MatrixXd inputs = problem_.space.features(xs);
  Eigen::MatrixXd means(as_index(xs.size()), as_index(objectives_.size()));
  for (std::size_t j = 0; j < objectives_.size() && !xs.empty(); ++j) {
    const ObjectiveView& view = objectives_[j];
    if (view.process != nullptr) {
      const Eigen::VectorXd z = view.process->predict_mean(inputs);
      means.col(as_index(j)) = z.unaryExpr([&](double one) { return view.from_model(one); });
    } else if (problem_.metrics[view.metric].is_composed()) {
      const auto& metrics = problem_.metrics[view.metric].composition.inputs;
      Eigen::MatrixXd z(as_index(xs.size()), as_index(metrics.size()));
      for (std::size_t i = 0; i < metrics.size(); ++i) {
        z.col(as_index(i)) = models_.process(metrics[i])->predict_mean(inputs);
      }
      for (std::size_t k = 0; k < xs.size(); ++k) {
        means(as_index(k), as_index(j)) = view.of_composed(
            of_inputs(problem_, models_, view.metric, xs[k])(z.row(as_index(k)).transpose()));
      }
    } else {
      for (std::size_t k = 0; k < xs.size(); ++k) {
        means(as_index(k), as_index(j)) = view.to_view(exact(view.metric, xs[k]));
      }
    }
  }
  // Layer after layer of the front of the predicted values, likely feasible designs first.
  std::vector<std::size_t> chosen;
  for (const bool want_feasible : {true, false}) {
    std::vector<std::size_t> left;
    for (std::size_t k = 0; k < designs.size(); ++k) {
      if (meets_limits(problem_, designs[k]->values, input.tolerance) == want_feasible)
        left.push_back(k);
    }
    while (!left.empty() && chosen.size() < most_front_designs) {
      std::vector<math::Objectives> points;
      for (const std::size_t k : left) points.emplace_back(means.row(as_index(k)).transpose());
      const auto layer = math::non_dominated(points);
      std::vector<std::size_t> rest;
      for (std::size_t k = 0; k < left.size(); ++k) {
        const bool in_layer = std::find(layer.begin(), layer.end(), k) != layer.end();
        if (in_layer && chosen.size() < most_front_designs) {
          chosen.push_back(left[k]);
        } else if (!in_layer) {
          rest.push_back(left[k]);
        }
      }
      left = std::move(rest);
    }
  }
  std::sort(chosen.begin(), chosen.end());
  for (const std::size_t k : chosen) {
    designs_.push_back(designs[k]->x);
    observed_.push_back(designs[k]->values);
  }
  const bool too_many = input.pending.size() > most_pending_designs;
  const std::size_t newest = too_many ? most_pending_designs - places_left : most_pending_designs;
  for (std::size_t k = 0; k < input.pending.size(); ++k) {
    // The newest ones; of the others only that they are not asked for again matters.
    if (k + newest < input.pending.size()) continue;
    if (in_draws(input.pending[k].x)) continue;
    designs_.push_back(input.pending[k].x);
    observed_.emplace_back();
  }
}

bool Gain::in_draws(const Point& x) const {
  return std::any_of(designs_.begin(), designs_.end(),
                     [&](const Point& other) { return same_design(other, x); });
}

void Gain::add_pending(const Point& x) {
  if (in_draws(x) || designs_.size() >= most_front_designs + most_pending_designs) return;
  designs_.push_back(x);
  observed_.emplace_back();
  const Eigen::RowVectorXd input = problem_.space.features(x);
  for (auto& samples : samples_) {
    if (samples) samples->append(input);
  }
  make_front();
}

double Gain::composed_draw(std::size_t metric, std::size_t design, int sample) const {
  const auto& inputs = problem_.metrics[metric].composition.inputs;
  Eigen::VectorXd z(as_index(inputs.size()));
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    z[as_index(i)] = samples(inputs[i])->values()(sample, as_index(design));
  }
  return of_inputs(problem_, models_, metric, designs_[design])(z);
}

double Gain::objective_draw(const ObjectiveView& view, std::size_t design, int sample) const {
  if (view.process != nullptr) {
    return view.from_model(samples(view.metric)->values()(sample, as_index(design)));
  }
  if (problem_.metrics[view.metric].is_composed()) {
    return view.of_composed(composed_draw(view.metric, design, sample));
  }
  return view.to_view(exact_[design][view.metric]);
}

bool Gain::limits_met(std::size_t design, int sample) const {
  return std::all_of(limits_.begin(), limits_.end(), [&](const LimitView& limit) {
    const bool known = !observed_[design].empty();
    if (known && !observed_[design][limit.metric]) return limit.satisfied_when_absent;
    double value = 0.0;
    if (limit.composed) {
      value = composed_draw(limit.metric, design, sample);
    } else if (samples(limit.metric) != nullptr) {
      value = samples(limit.metric)->values()(sample, as_index(design));
    } else if (problem_.metrics[limit.metric].exact) {
      value = exact_[design][limit.metric];
    } else {
      return limit.satisfied_when_absent;  // never had a value so far
    }
    return limit.lower <= value && value <= limit.upper;
  });
}

void Gain::draw(std::uint64_t seed) {
  const Eigen::MatrixXd inputs = problem_.space.features(designs_);
  samples_.resize(problem_.metrics.size());
  normals_.resize(problem_.metrics.size());
  for (std::size_t metric = 0; metric < samples_.size(); ++metric) {
    const auto* process = models_.process(metric);
    if (process == nullptr) continue;
    samples_[metric] = std::make_unique<surrogate::PosteriorSamples>(*process, inputs, n_samples_,
                                                                     seed + 104729 * metric);
    normals_[metric] = standard_normals(n_samples_, seed, 1000 + metric);
  }
  make_front();
}

/// Exact metrics of the designs: the same in each draw.
void Gain::note_exact() {
  for (std::size_t k = exact_.size(); k < designs_.size(); ++k) {
    auto& values = exact_.emplace_back(problem_.metrics.size(), 0.0);
    for (std::size_t metric = 0; metric < values.size(); ++metric) {
      if (problem_.metrics[metric].exact) values[metric] = exact(metric, designs_[k]);
    }
  }
}

void Gain::make_front() {
  note_exact();
  mean_hypervolume_ = 0.0;
  std::vector<Eigen::MatrixXd> objectives;
  std::vector<Eigen::VectorXi> feasible;
  for (int s = 0; s < n_samples_; ++s) {
    Eigen::MatrixXd y(as_index(designs_.size()), as_index(objectives_.size()));
    Eigen::VectorXi meets(as_index(designs_.size()));
    std::vector<math::Objectives> good;
    for (std::size_t k = 0; k < designs_.size(); ++k) {
      for (std::size_t j = 0; j < objectives_.size(); ++j) {
        y(as_index(k), as_index(j)) = objective_draw(objectives_[j], k, s);
        // A draw beyond what is possible would leave no room for an improvement there.
        y(as_index(k), as_index(j)) = std::max(y(as_index(k), as_index(j)), ideal_[as_index(j)]);
      }
      meets[as_index(k)] = limits_met(k, s) ? 1 : 0;
      if (meets[as_index(k)] == 1) good.emplace_back(y.row(as_index(k)).transpose());
    }
    mean_hypervolume_ += math::hypervolume(good, reference_) / n_samples_;
    objectives.push_back(std::move(y));
    feasible.push_back(std::move(meets));
  }
  front_.emplace(objectives, feasible, reference_, ideal_);
}

}  // namespace parapet::bayesian
