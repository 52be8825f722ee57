#include "parapet/study/study_surrogates.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "companion_file.hpp"
#include "parapet/math/normal.hpp"
#include "parapet/study/bayesian_problem.hpp"
#include "stored_surrogates.hpp"

namespace parapet::study {
namespace {

using designs::Design;
using designs::Json;
using surrogate::GaussianProcess;

/// By how much designs left out lie farther off than a process says, at a level; at least 1. Of a
/// level with fewer than five runs nothing can be said: all runs stand for it.
double inflation_at(const GaussianProcess& process, int level) {
  constexpr int fewest = 5;
  const surrogate::LeaveOneOut left_out = process.leave_one_out();
  const std::vector<int>& levels = process.data().levels;
  const bool all = std::ranges::count(levels, level) < fewest;
  double squares = 0.0, count = 0.0;
  for (std::size_t k = 0; k < levels.size(); ++k) {
    const double residual = left_out.residual(static_cast<Eigen::Index>(k));
    if ((!all && levels[k] != level) || !std::isfinite(residual)) continue;
    squares += residual * residual;
    count += 1.0;
  }
  return count > 0.0 ? std::max(1.0, std::sqrt(squares / count)) : 1.0;
}

/// Half of what a value moves by when the model's moves by `deviation` either way.
double in_unit(const GaussianProcess& process, double z, double deviation) {
  return 0.5 * (process.from_model(z + deviation) - process.from_model(z - deviation));
}

/// Mean squares of the difference between two levels at the inputs, in the output's unit.
Eigen::VectorXd grid_squares(const GaussianProcess& process, const Eigen::MatrixXd& inputs,
                             int level) {
  const surrogate::Prediction here = process.predict(inputs, level);
  const surrogate::Prediction coarser = process.predict(inputs, level + 1);
  Eigen::VectorXd squares(inputs.rows());
  for (Eigen::Index k = 0; k < inputs.rows(); ++k) {
    const Eigen::MatrixXd at = inputs.row(k);
    const double covariance = process.covariance(at, level, at, level + 1)(0, 0);
    const double variance =
        std::max(0.0, here.variance[k] + coarser.variance[k] - 2.0 * covariance);
    const double apart = process.from_model(here.mean[k]) - process.from_model(coarser.mean[k]);
    const double deviation = in_unit(process, here.mean[k], std::sqrt(variance));
    squares[k] = apart * apart + deviation * deviation;
  }
  return squares;
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

std::shared_ptr<const StudySurrogates> StudySurrogates::read(const designs::StudySpec& study,
                                                             const std::filesystem::path& file,
                                                             const std::string& spec_hash) {
  const Json json = read_companion(file, "parapet-surrogates/1", spec_hash);
  return json.is_null() ? nullptr : of(study, json);
}

std::shared_ptr<const StudySurrogates> StudySurrogates::of(const designs::StudySpec& study,
                                                           const Json& surrogates) {
  const SearchProblem problem = make_search_problem(study);
  try {
    const Json& metrics = surrogates.at("metrics");
    if (metrics.size() != problem.metrics.size()) return nullptr;
    const std::shared_ptr<StudySurrogates> result(
        new StudySurrogates(problem.problem.space, study.variables));
    result->spacings_ = problem.spacings;
    for (std::size_t k = 0; k < metrics.size(); ++k) {
      auto& model = result->models_.emplace_back();
      auto process = stored_process(surrogates, metrics[k]);
      if (!process || process->data().values.size() == 0) continue;
      const bayesian::Metric& metric = problem.problem.metrics[k];
      model =
          Model{.process = std::move(*process), .least = metric.least, .greatest = metric.greatest};
      for (int level = 0; level < model->process.layout().n_levels; ++level) {
        const auto runs =
            static_cast<double>(std::ranges::count(model->process.data().levels, level));
        model->inflation.push_back(inflation_at(model->process, level));
        model->noise_freedom.push_back(std::max(2.0, 0.5 * runs));
      }
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

std::vector<SurrogateBelief> StudySurrogates::beliefs(const GoalPlace& goal,
                                                      const std::vector<const Design*>& designs,
                                                      double spacing) const {
  const Model* model = find(goal);
  const std::optional<int> at = level(spacing);
  if (model == nullptr || !at || designs.empty()) return {};
  const GaussianProcess& process = model->process;
  const auto place = static_cast<std::size_t>(*at);
  const Eigen::MatrixXd inputs = features(designs);
  const surrogate::Prediction prediction = process.predict(inputs, *at);
  const bool coarser =
      *at + 1 < process.layout().n_levels && std::ranges::count(process.data().levels, *at + 1) > 0;
  const Eigen::VectorXd grid =
      coarser ? grid_squares(process, inputs, *at) : Eigen::VectorXd::Zero(inputs.rows());
  std::vector<SurrogateBelief> list;
  for (Eigen::Index k = 0; k < inputs.rows(); ++k) {
    const double z = prediction.mean[k], inflation = model->inflation[place];
    const double deviation = inflation * std::sqrt(std::max(0.0, prediction.variance[k]));
    SurrogateBelief& belief = list.emplace_back();
    belief.mean = std::clamp(process.from_model(z), model->least, model->greatest);
    belief.deviation = in_unit(process, z, deviation);
    belief.noise = in_unit(process, z, inflation * process.noise(*at));
    belief.noise_freedom = model->noise_freedom[place];
    if (coarser) belief.grid = std::sqrt(grid[k]);
  }
  return list;
}

Eigen::MatrixXd StudySurrogates::draws(const GoalPlace& goal,
                                       const std::vector<const Design*>& designs, double spacing,
                                       int count, std::uint64_t seed) const {
  const Model* model = find(goal);
  const std::optional<int> at = level(spacing);
  if (model == nullptr || !at || designs.empty()) return Eigen::MatrixXd(count, 0);
  const GaussianProcess& process = model->process;
  const surrogate::JointPrediction joint = process.joint(features(designs), *at);
  const Eigen::MatrixXd factor =
      model->inflation[static_cast<std::size_t>(*at)] * factor_of(joint.covariance);
  std::mt19937_64 generator(seed);
  Eigen::MatrixXd values(count, joint.mean.size());
  Eigen::VectorXd normals(joint.mean.size());
  for (Eigen::Index row = 0; row < values.rows(); ++row) {
    for (double& normal : normals) normal = standard_normal(generator);
    const Eigen::VectorXd z = joint.mean + factor * normals;
    for (Eigen::Index k = 0; k < z.size(); ++k) {
      values(row, k) = std::clamp(process.from_model(z[k]), model->least, model->greatest);
    }
  }
  return values;
}

}  // namespace parapet::study
