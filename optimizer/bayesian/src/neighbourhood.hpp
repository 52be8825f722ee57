/// Surrogates of the designs near the best one, for local steps.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "composed.hpp"
#include "local_step.hpp"
#include "parapet/optimizer/optimize.hpp"

namespace parapet::bayesian {

/// Largest difference of a coordinate.
double distance(const std::vector<double>& u, const std::vector<double>& v);

/// Whether two designs differ in free variables only.
bool same_kind(const Space& space, const Point& a, const Point& b);

/// Surrogates of one neighbourhood. Inputs are the free variables, scaled to its size.
class Neighbourhood {
 public:
  Neighbourhood(const Problem& problem, const std::vector<Told>& told, const TrustRegion& region,
                std::uint64_t seed);

  bool enough() const { return !free_.empty() && designs_.size() >= free_.size() + 2; }
  bool modelled() const;
  std::size_t n_free() const { return free_.size(); }

  /// The design at v [n_free], 0 .. 1 across the trust region.
  Point design(const std::vector<double>& v) const;

  /// v of the best design.
  std::vector<double> middle() const;

  /// Objective, minimised, in model units (a composed one: over its spread), and violations of the
  /// limits over their deviation there.
  optimizer::Evaluation predict(const std::vector<double>& v) const;

  std::size_t n_constraints() const { return predict(middle()).constraints.size(); }

  double deviation(const std::vector<double>& v) const;

  /// Of the best design as observed, in the unit of predict().
  double best_objective() const;
  double noise() const;

 private:
  double sign() const { return problem_.objectives.front().maximize ? -1.0 : 1.0; }
  std::size_t objective_metric() const { return problem_.objectives.front().metric; }

  bool predictable(std::size_t metric) const;

  /// A composed metric of its inputs in the local models' units.
  OfInputs local_inputs(std::size_t metric, const Point& x) const;

  /// Predictions of a metric's inputs: mean and deviation [n_inputs].
  std::pair<Eigen::VectorXd, Eigen::VectorXd> predict_inputs(std::size_t metric,
                                                             const Eigen::MatrixXd& at) const;

  /// Model units, of a composed metric its own.
  double mean_of(std::size_t metric, const Point& x, const Eigen::MatrixXd& at) const;
  double deviation_of(std::size_t metric, const Point& x, const Eigen::MatrixXd& at) const;

  /// Standard deviation of a composed metric over the designs taken.
  double spread_of(std::size_t metric) const;

  void choose_designs(const std::vector<Told>& told);

  Eigen::RowVectorXd inputs_of(const Point& x) const;

  /// Objectives far worse than the best few are as bad as they need to be: a cliff, or a steep wall
  /// of a valley, would else decide the scales of the model.
  void limit_the_worst(Eigen::VectorXd& values) const;

  void fit(std::uint64_t seed);

  const Problem& problem_;
  const Told& best_;
  std::vector<double> center_;
  std::vector<std::size_t> free_;
  double half_width_;
  std::vector<std::size_t> objective_inputs_;  // metrics with surrogates that it hangs on
  double scale_ = 1.0;                         // of a composed objective, else 1
  double reach_ = 1.0;                         // of the designs taken, share of each range
  std::vector<const Told*> designs_;           // nearest first
  std::vector<std::optional<surrogate::GaussianProcess>> processes_;  // [n_metrics]
};

}  // namespace parapet::bayesian
