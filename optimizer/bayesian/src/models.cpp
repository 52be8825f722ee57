#include "models.hpp"

#include <algorithm>
#include <cmath>

namespace parapet::bayesian {

Models::Models(const Problem& problem, std::uint64_t seed)
    : problem_(problem),
      seed_(seed),
      layout_(problem.space.layout(static_cast<int>(problem.levels.size()))),
      processes_(problem.metrics.size()),
      fitted_at_(problem.metrics.size(), 0),
      fits_(problem.metrics.size(), 0) {}

bool Models::due(std::size_t n_data, std::size_t& fitted_at) const {
  constexpr std::size_t always_until = 30, many = 150;
  const std::size_t share = n_data <= many ? 20 : 10;
  const std::size_t wait = n_data <= always_until ? 1 : std::max<std::size_t>(2, n_data / share);
  if (n_data < fitted_at + wait) return false;
  fitted_at = n_data;
  return true;
}

void Models::update(const std::vector<Told>& told, bool revised) {
  for (std::size_t metric = 0; metric < processes_.size(); ++metric) {
    const Metric& spec = problem_.metrics[metric];
    if (!spec.exact && !spec.is_composed()) update_process(metric, told, revised);
  }
  update_success(told);
}

void Models::update_process(std::size_t metric, const std::vector<Told>& told, bool revised) {
  std::vector<Point> xs;
  surrogate::Data data;
  std::vector<double> values;
  for (const Told& t : told) {
    if (!t.ok || !t.values[metric] || !std::isfinite(*t.values[metric])) continue;
    xs.push_back(t.x);
    values.push_back(*t.values[metric]);
    data.levels.push_back(t.level);
  }
  auto& process = processes_[metric];
  if (values.empty() ||
      (process && !revised &&
       process->data().values.size() == static_cast<Eigen::Index>(values.size()))) {
    return;
  }
  data.inputs = problem_.space.features(xs);
  data.values =
      Eigen::Map<Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  surrogate::FitOptions options;
  options.transform = problem_.metrics[metric].transform;
  options.known_noise = problem_.metrics[metric].known_noise;
  options.seed = seed_ + 7919 * metric;
  // A logarithm that was right so far cannot take a value of 0.
  const bool unfit = process &&
                     process->parameters().transform.kind == surrogate::TransformKind::log &&
                     data.values.minCoeff() <= 0.0;
  const bool fits = !process || due(values.size(), fitted_at_[metric]) || unfit;
  if (!process) fitted_at_[metric] = values.size();
  // A start from the last fit keeps its kind of transform and its hill of the likelihood: every
  // fifth fit forgets both.
  const bool forgets = !process || unfit || (fits && fits_[metric] % 5 == 0);
  if (!forgets) options.warm_start = process->parameters();
  options.keep_parameters = !fits;
  constexpr std::size_t many = 150;  // of which one start is enough
  options.starts = forgets ? 4 : (values.size() <= many ? 2 : 1);
  fits_[metric] += fits ? 1 : 0;
  process = surrogate::GaussianProcess::fit(layout_, data, options);
}

void Models::update_success(const std::vector<Told>& told) {
  if (told.empty() || told.size() == success_fitted_at_) return;
  const bool failures = std::any_of(told.begin(), told.end(), [](const Told& t) { return !t.ok; });
  // Without failures the model says 1 everywhere, and with them every new answer is worth a fit.
  if (!failures && success_) return;
  std::vector<Point> xs;
  std::vector<bool> succeeded;
  for (const Told& t : told) {
    xs.push_back(t.x);
    succeeded.push_back(t.ok);
  }
  success_ = surrogate::SuccessModel::fit(layout_, problem_.space.features(xs), succeeded, seed_);
  success_fitted_at_ = told.size();
}

Eigen::VectorXd Models::log_success(const Eigen::MatrixXd& inputs) const {
  if (!success_ || !success_->any_failure()) return Eigen::VectorXd::Zero(inputs.rows());
  return success_->log_probability(inputs);
}

}  // namespace parapet::bayesian
