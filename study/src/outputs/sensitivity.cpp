#include "parapet/study/sensitivity.hpp"

#include <algorithm>
#include <cmath>

#include "parapet/optimizer/sobol.hpp"
#include "parapet/records/hashes.hpp"
#include "parapet/study/bayesian_problem.hpp"
#include "parapet/surrogate/sensitivity.hpp"
#include "stored_surrogates.hpp"

namespace parapet::study {
namespace {

using designs::Json;

std::vector<double> row_of(const Eigen::MatrixXd& u, Eigen::Index i) {
  const Eigen::VectorXd row = u.row(i).transpose();
  return {row.begin(), row.end()};
}

Eigen::MatrixXd features_of(const bayesian::Space& space, const Eigen::MatrixXd& u) {
  std::vector<bayesian::Point> points;
  for (Eigen::Index i = 0; i < u.rows(); ++i) points.push_back(space.from_unit(row_of(u, i)));
  return space.features(points);
}

/// Different designs at Sobol' points of the box.
Eigen::MatrixXd anchors(const bayesian::Space& space, int count) {
  std::vector<bayesian::Point> points;
  constexpr auto table = static_cast<std::size_t>(optimizer::SobolSequence::max_dimension);
  const auto dimension = static_cast<int>(std::min(space.size(), table));
  optimizer::SobolSequence sequence(dimension);
  for (int k = 0; k < count; ++k) {
    std::vector<double> u = sequence.next();
    // Beyond the table coordinates repeat, one place on: rare, and these are only anchors.
    for (std::size_t i = u.size(); i < space.size(); ++i) u.push_back(u[(i + 1) % table]);
    const bayesian::Point point = space.from_unit(u);
    const bool known = std::any_of(points.begin(), points.end(), [&](const bayesian::Point& other) {
      return bayesian::same_design(point, other);
    });
    if (!known) points.push_back(point);
  }
  return space.features(points);
}

/// Draws of the surrogate's posterior as functions of the unit cube.
class Draws {
 public:
  Draws(const bayesian::Space& space, const surrogate::GaussianProcess& process,
        const bayesian::Metric& metric, const SensitivityOptions& options)
      : space_(space),
        process_(process),
        metric_(metric),
        samples_(process, anchors(space, options.anchors), options.realisations, options.seed) {}

  /// u [m, n_variables] -> [m, n_realisations], in the metric's unit.
  Eigen::MatrixXd operator()(const Eigen::MatrixXd& u) const {
    Eigen::MatrixXd mean;
    Eigen::VectorXd variance;
    samples_.predict(features_of(space_, u), mean, variance);
    return mean.transpose().unaryExpr([&](double z) {
      return std::clamp(process_.from_model(z), metric_.least, metric_.greatest);
    });
  }

 private:
  const bayesian::Space& space_;
  const surrogate::GaussianProcess& process_;
  const bayesian::Metric& metric_;
  surrogate::PosteriorSamples samples_;
};

/// An index is a share: what its estimator has beyond 0 and 1 is sampling error.
SobolIndex index_of(const surrogate::Interval& interval) {
  const auto share = [](double value) { return std::clamp(value, 0.0, 1.0); };
  return {.value = share(interval.value),
          .lower_95 = share(interval.lower),
          .upper_95 = share(interval.upper)};
}

/// The place u of a variable.
VariablePlace place_of(const designs::Variable& variable, double u) {
  const double count = variable.upper - variable.lower + 1.0;
  const double step = std::min(std::floor(u * count), count - 1.0);
  if (variable.kind == designs::VariableKind::choice) {
    return variable.options[static_cast<std::size_t>(step)].name;
  }
  if (variable.kind == designs::VariableKind::integer) return variable.lower + step;
  return variable.lower + u * (variable.upper - variable.lower);
}

/// Each option and whole number once.
MainEffect effect_of(const designs::Variable& variable, const surrogate::MainEffect& effect) {
  MainEffect result;
  for (std::size_t k = 0; k < effect.u.size(); ++k) {
    VariablePlace place = place_of(variable, effect.u[k]);
    if (!result.at.empty() && result.at.back() == place) continue;
    result.at.push_back(std::move(place));
    result.mean.push_back(effect.effect[k].value);
    result.lower_95.push_back(effect.effect[k].lower);
    result.upper_95.push_back(effect.effect[k].upper);
  }
  return result;
}

std::vector<VariableSensitivity> variables_of(const designs::StudySpec& study, const Draws& draws,
                                              const SensitivityOptions& options) {
  constexpr int fewest_places = 17;
  int places = fewest_places;  // every option and whole number must be met, where they are not many
  for (const designs::Variable& variable : study.variables) {
    if (variable.kind == designs::VariableKind::continuous) continue;
    const double count = variable.upper - variable.lower + 1.0;
    places = std::max(places, static_cast<int>(std::min(2.0 * count + 1.0, 65.0)));
  }
  const auto n = static_cast<int>(study.variables.size());
  const auto indices = surrogate::sobol_indices(
      draws, n,
      {.base_points = options.base_points, .bootstrap = options.bootstrap, .seed = options.seed});
  const auto effects = surrogate::main_effects(draws, n, places, 256, options.seed);
  std::vector<VariableSensitivity> list;
  for (std::size_t i = 0; i < study.variables.size(); ++i) {
    list.push_back({.name = study.variables[i].name,
                    .first = index_of(indices[i].first),
                    .total = index_of(indices[i].total),
                    .main_effect = effect_of(study.variables[i], effects[i])});
  }
  return list;
}

std::string statistic_words(const designs::StudySpec& study, const Quantity& quantity) {
  if (quantity.statistic == designs::Statistic::probability) return "probability within limits";
  if (!quantity.event.empty()) return "in " + quantity.event;
  if (study.scenarios.size() < 2) return "";
  if (quantity.statistic == designs::Statistic::mean) return "mean over the scenarios";
  const std::string end = quantity.high_is_good ? "lowest" : "highest";
  return quantity.statistic == designs::Statistic::worst ? end + " of the scenarios"
                                                         : "quantile over the scenarios";
}

MetricSensitivity metric_sensitivity(const designs::StudySpec& study, const SearchProblem& problem,
                                     std::size_t k, const surrogate::GaussianProcess& process,
                                     const SensitivityOptions& options) {
  const Draws draws(problem.problem.space, process, problem.problem.metrics[k], options);
  const Quantity& quantity = problem.metrics[k].quantity;
  MetricSensitivity result;
  result.metric = quantity.metric;
  result.statistic = statistic_words(study, quantity);
  result.designs = static_cast<int>(process.data().values.size());
  const double q_squared = process.leave_one_out().q_squared;
  if (std::isfinite(q_squared)) result.q_squared = q_squared;
  result.variables = variables_of(study, draws, options);
  result.varies = std::ranges::any_of(
      result.variables, [](const VariableSensitivity& one) { return one.total.value > 0.0; });
  return result;
}

}  // namespace

Sensitivity study_sensitivity(const designs::StudySpec& study, const Json& surrogates,
                              const std::string& source, const SensitivityOptions& options) {
  const SearchProblem problem = make_search_problem(study);
  Sensitivity result{.study_name = study.name,
                     .spec_hash = records::study_hash(study),
                     .source = source,
                     .domain = "the box of the variables' bounds, uniform and independent",
                     .realisations = options.realisations,
                     .base_points = options.base_points,
                     .metrics = {}};
  const auto refuse = [&](const std::string& problem_words) {
    throw designs::InputError({{source, "/metrics", "", problem_words,
                                "a parapet-surrogates/1 of this study, as parapet optimize writes "
                                "it; without the file the surrogates are fitted again"}});
  };
  try {
    if (surrogates.at("spec_hash") != result.spec_hash ||
        surrogates.at("metrics").size() != problem.metrics.size()) {
      refuse("the surrogates are those of another study");
    }
    for (std::size_t k = 0; k < problem.metrics.size(); ++k) {
      const Json& stored = surrogates["metrics"][k];
      const auto process = stored_process(surrogates, stored);
      if (!process) continue;
      MetricSensitivity one = metric_sensitivity(study, problem, k, *process, options);
      one.name = stored.at("name").get<std::string>();
      result.metrics.push_back(std::move(one));
    }
  } catch (const Json::exception& error) {
    refuse(error.what());
  } catch (const std::invalid_argument& error) {
    refuse(error.what());
  }
  return result;
}

}  // namespace parapet::study
