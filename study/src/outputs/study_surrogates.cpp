#include "parapet/study/study_surrogates.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "companion_file.hpp"
#include "parapet/math/normal.hpp"
#include "parapet/study/bayesian_problem.hpp"
#include "parapet/study/event_model.hpp"
#include "parapet/study/quantity.hpp"
#include "stored_surrogates.hpp"
#include "surrogate_fits.hpp"

namespace parapet::study {
namespace {

using designs::Design;
using designs::Json;
using records::EvaluationRecord;
using surrogate::GaussianProcess;

/// What an expression was in the runs.
RunSamples samples_of(const designs::StudySpec& study, const Quantity& quantity,
                      const std::vector<EvaluationRecord>& runs) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const bool share = quantity.statistic == designs::Statistic::probability;
  RunSamples samples{.least = share ? 0.0 : -infinity, .greatest = share ? 1.0 : infinity};
  for (const EvaluationRecord& run : runs) {
    if (!run.ok) continue;
    const auto value = quantity_value(study, quantity, run.design, events_of(run)).value;
    if (!value) continue;
    samples.designs.push_back(&run.design);
    samples.spacings.push_back(run.spacing);
    samples.values.push_back(*value);
  }
  return samples;
}

/// The same on every platform, unlike std::normal_distribution.
double standard_normal(std::mt19937_64& generator) {
  constexpr double step = 0x1p-53;
  return math::normal_quantile((static_cast<double>(generator() >> 11) + 0.5) * step);
}

/// A factor of a covariance that rounding may have made indefinite.
Eigen::MatrixXd factor_of(Eigen::MatrixXd covariance) {
  double jitter = 1e-12 * std::max(1e-300, covariance.diagonal().maxCoeff());
  for (int k = 0; k < 12; ++k, jitter *= 10.0) {
    covariance.diagonal().array() += jitter;
    const Eigen::LLT<Eigen::MatrixXd> factor(covariance);
    if (factor.info() == Eigen::Success) return factor.matrixL();
  }
  return Eigen::MatrixXd(covariance.diagonal().cwiseMax(0.0).cwiseSqrt().asDiagonal());
}

}  // namespace

std::shared_ptr<const StudySurrogates> StudySurrogates::read(
    const designs::StudySpec& study, const std::filesystem::path& file,
    const std::string& spec_hash, const std::vector<EvaluationRecord>& runs) {
  const Json json = read_companion(file, "parapet-surrogates/1", spec_hash);
  return json.is_null() ? nullptr : of(study, json, runs);
}

std::shared_ptr<const StudySurrogates> StudySurrogates::of(
    const designs::StudySpec& study, const Json& surrogates,
    const std::vector<EvaluationRecord>& runs) {
  const SearchProblem problem = make_search_problem(study);
  try {
    const Json& metrics = surrogates.at("metrics");
    if (metrics.size() != problem.metrics.size()) return nullptr;
    const std::shared_ptr<StudySurrogates> result(
        new StudySurrogates(problem.problem.space, study.variables));
    result->spacings_ = problem.spacings;
    for (std::size_t k = 0; k < metrics.size(); ++k) {
      auto& model = result->models_.emplace_back();
      const bool exact = static_cast<bool>(problem.problem.metrics[k].exact);
      if (problem.problem.metrics[k].composition.value || (has_distribution(study) && !exact)) {
        model = result->model_of(samples_of(study, problem.metrics[k].quantity, runs));
        continue;
      }
      auto process = stored_process(surrogates, metrics[k]);
      if (!process || process->data().values.size() == 0) continue;
      const bayesian::Metric& metric = problem.problem.metrics[k];
      model = Model{.lazy = std::make_shared<Fits>(),
                    .least = metric.least,
                    .greatest = metric.greatest,
                    .noise_freedom = noise_freedom_of(process->data(), problem.spacings.size())};
      model->lazy->stored = std::move(*process);
      model->lazy->noise_known = !metric.known_noise.empty();
    }
    for (const auto& objective : problem.problem.objectives) {
      result->objectives_.push_back(objective.metric);
    }
    for (const auto& limit : problem.problem.limits) result->limits_.push_back(limit.metric);
    return result;
  } catch (const Json::exception&) {
    return nullptr;
  } catch (const std::invalid_argument&) {
    return nullptr;
  }
}

const StudySurrogates::Model* StudySurrogates::find(const GoalPlace& goal) const {
  const auto& places = goal.kind == GoalPlace::Kind::objective ? objectives_ : limits_;
  if (goal.number >= places.size() || places[goal.number] >= models_.size()) return nullptr;
  const auto& model = models_[places[goal.number]];
  return model ? &*model : nullptr;
}

std::optional<int> StudySurrogates::level(double spacing) const {
  const auto found = std::ranges::find(spacings_, spacing);
  if (found == spacings_.end()) return std::nullopt;
  return static_cast<int>(found - spacings_.begin());
}

Eigen::MatrixXd StudySurrogates::features(const std::vector<const Design*>& designs) const {
  std::vector<bayesian::Point> points;
  for (const Design* design : designs) {
    bayesian::Point point;
    for (const designs::Variable& variable : variables_) {
      const auto found = design->find(variable.name);
      point.push_back(found == design->end() ? std::numeric_limits<double>::quiet_NaN()
                                             : found->second);
    }
    points.push_back(std::move(point));
  }
  return space_.features(points);
}

const std::vector<StudySurrogates::Fit>& StudySurrogates::fits_of(const Model& model) {
  Fits& lazy = *model.lazy;
  std::call_once(lazy.made, [&] {
    if (lazy.data) lazy.stored = GaussianProcess::fit(lazy.layout, *lazy.data, {});
    lazy.data.reset();
    lazy.fits = make_fits(std::move(*lazy.stored), lazy.noise_known);
    lazy.stored.reset();
  });
  return lazy.fits;
}

std::vector<StudySurrogates::Fit> StudySurrogates::make_fits(GaussianProcess process,
                                                             bool noise_known) {
  constexpr Eigen::Index most_runs = 150;  // from here on the noise is known well
  std::vector<Fit> fits;
  const bool varies = process.data().values.maxCoeff() > process.data().values.minCoeff();
  if (!noise_known && varies && process.data().values.size() <= most_runs) {
    for (const double noise : {0.05, 0.1, 0.2, 0.4}) {
      fits.push_back({.process = with_noise(process, noise)});
    }
  }
  fits.push_back({.process = std::move(process)});
  double best = -std::numeric_limits<double>::infinity(), sum = 0.0;
  for (const Fit& fit : fits) best = std::max(best, fit.process.log_likelihood());
  for (Fit& fit : fits) {
    fit.weight = std::exp(fit.process.log_likelihood() - best);
    sum += fit.weight;
    for (int level = 0; level < fit.process.layout().n_levels; ++level) {
      fit.inflation.push_back(inflation_at(fit.process, level));
    }
  }
  for (Fit& fit : fits) fit.weight /= sum;
  return fits;
}

std::vector<double> StudySurrogates::noise_freedom_of(const surrogate::Data& data,
                                                      std::size_t levels) {
  std::vector<double> freedom;
  for (std::size_t level = 0; level < levels; ++level) {
    const auto runs = static_cast<double>(std::ranges::count(data.levels, static_cast<int>(level)));
    freedom.push_back(std::max(2.0, 0.25 * runs));
  }
  return freedom;
}

std::vector<SurrogateBelief> StudySurrogates::beliefs(const GoalPlace& goal,
                                                      const std::vector<const Design*>& designs,
                                                      double spacing) const {
  const Model* model = find(goal);
  const std::optional<int> at = level(spacing);
  if (model == nullptr || !at || designs.empty()) return {};
  return beliefs_of(*model, designs, *at);
}

std::optional<StudySurrogates::Model> StudySurrogates::model_of(const RunSamples& samples) const {
  constexpr Eigen::Index fewest = 5;
  surrogate::Data data;
  std::vector<const Design*> designs;
  std::vector<double> values;
  for (std::size_t k = 0; k < samples.values.size(); ++k) {
    const std::optional<int> own = level(samples.spacings[k]);
    if (!own || !std::isfinite(samples.values[k])) continue;
    designs.push_back(samples.designs[k]);
    values.push_back(samples.values[k]);
    data.levels.push_back(*own);
  }
  data.values =
      Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  if (data.values.size() < fewest) return std::nullopt;
  data.inputs = features(designs);
  Model model{.lazy = std::make_shared<Fits>(),
              .least = samples.least,
              .greatest = samples.greatest,
              .noise_freedom = noise_freedom_of(data, spacings_.size())};
  model.lazy->layout = space_.layout(static_cast<int>(spacings_.size()));
  model.lazy->data = std::move(data);
  return model;
}

std::optional<SurrogateBelief> StudySurrogates::fitted_belief(const RunSamples& samples,
                                                              const Design& design,
                                                              double spacing) const {
  const std::optional<int> at = level(spacing);
  const std::optional<Model> model = model_of(samples);
  if (!at || !model) return std::nullopt;
  return beliefs_of(*model, {&design}, *at).front();
}

std::vector<SurrogateBelief> StudySurrogates::beliefs_of(const Model& model,
                                                         const std::vector<const Design*>& designs,
                                                         int level) const {
  const auto place = static_cast<std::size_t>(level);
  const Eigen::MatrixXd inputs = features(designs);
  const std::vector<Fit>& fits = fits_of(model);
  const surrogate::GaussianProcess& any = fits.front().process;
  const bool coarser =
      level + 1 < any.layout().n_levels && std::ranges::count(any.data().levels, level + 1) > 0;
  const Eigen::Index n = inputs.rows();
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(n), square = mean, noise = mean, grid = mean;
  for (const Fit& fit : fits) {
    const surrogate::Prediction prediction = fit.process.predict(inputs, level);
    const double inflation = fit.inflation[place];
    for (Eigen::Index k = 0; k < n; ++k) {
      const double z = prediction.mean[k];
      const double middle = std::clamp(fit.process.from_model(z), model.least, model.greatest);
      const double deviation =
          in_unit(fit.process, z, inflation * std::sqrt(std::max(0.0, prediction.variance[k])));
      const double of_run = in_unit(fit.process, z, inflation * fit.process.noise(level));
      mean[k] += fit.weight * middle;
      square[k] += fit.weight * (middle * middle + deviation * deviation);
      noise[k] += fit.weight * of_run * of_run;
    }
    if (!coarser) continue;
    const Eigen::VectorXd here = grid_squares(fit.process, inputs, level);
    grid += fit.weight * here.cwiseMax(typical_grid_square(fit.process, level));
  }
  std::vector<SurrogateBelief> list;
  for (Eigen::Index k = 0; k < n; ++k) {
    list.push_back({.mean = mean[k],
                    .deviation = std::sqrt(std::max(0.0, square[k] - mean[k] * mean[k])),
                    .noise = std::sqrt(noise[k]),
                    .noise_freedom = model.noise_freedom[place],
                    .grid = coarser ? std::optional(std::sqrt(grid[k])) : std::nullopt});
  }
  return list;
}

Eigen::MatrixXd StudySurrogates::draws(const GoalPlace& goal,
                                       const std::vector<const Design*>& designs, double spacing,
                                       int count, std::uint64_t seed) const {
  const Model* model = find(goal);
  const std::optional<int> at = level(spacing);
  if (model == nullptr || !at || designs.empty()) return Eigen::MatrixXd(count, 0);
  const Eigen::MatrixXd inputs = features(designs);
  std::mt19937_64 generator(seed);
  Eigen::MatrixXd values(count, inputs.rows());
  Eigen::VectorXd normals(inputs.rows());
  Eigen::Index row = 0;
  double share = 0.0;
  const std::vector<Fit>& fits = fits_of(*model);
  for (const Fit& fit : fits) {
    share += fit.weight;
    const bool last = &fit == &fits.back();
    const auto end = last ? values.rows() : static_cast<Eigen::Index>(std::lround(share * count));
    if (end <= row) continue;
    const surrogate::JointPrediction joint = fit.process.joint(inputs, *at);
    const Eigen::MatrixXd factor =
        fit.inflation[static_cast<std::size_t>(*at)] * factor_of(joint.covariance);
    for (; row < end; ++row) {
      for (double& normal : normals) normal = standard_normal(generator);
      const Eigen::VectorXd z = joint.mean + factor * normals;
      for (Eigen::Index k = 0; k < z.size(); ++k) {
        values(row, k) = std::clamp(fit.process.from_model(z[k]), model->least, model->greatest);
      }
    }
  }
  return values;
}

}  // namespace parapet::study
