/// What a design is expected to bring: the acquisition function, in log space.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "models.hpp"
#include "parapet/acquisition/improvement.hpp"
#include "parapet/surrogate/gaussian_process.hpp"

namespace parapet::bayesian {

/// How an objective is seen by the acquisition: model units, minimised.
struct ObjectiveView {
  std::size_t metric = 0;
  double sign = 1.0;  ///< -1 for what is maximised
  surrogate::OutputTransform transform;
  const surrogate::GaussianProcess* process = nullptr;  ///< null: exact

  double to_view(double value) const { return sign * transform.to_model(value); }
};

/// Noisy expected hypervolume improvement at the finest level, times the probabilities of meeting
/// the limits and of the evaluation succeeding. Every metric is a process of its own; given them,
/// outcomes are independent, except that a limit on an objective's own metric moves the reference
/// point. While no design meets the limits in any draw, the gain is the probability of meeting
/// them.
///
/// The draws are joint over the designs of the finest level that may matter (told) and those
/// pending.
class Gain {
 public:
  struct Input {
    const Problem& problem;
    const Models& models;
    const std::vector<Told>& told;
    const std::vector<Suggestion>& pending;
    Eigen::VectorXd reference;  ///< [n_objectives], minimised, metrics' units
    int n_samples = 64;
    std::uint64_t seed = 1;
    double tolerance = 0.0;
  };

  /// All that the input refers to must outlive this. Every objective needs a model or to be exact.
  explicit Gain(const Input& input);

  /// log of the expected gain [m] at designs that are not evaluated yet.
  Eigen::VectorXd log_gain(const std::vector<Point>& xs) const;

  /// log of (largest variance of an objective, model units, times the probabilities of meeting the
  /// limits and of success) [m].
  Eigen::VectorXd log_ignorance(const std::vector<Point>& xs) const;

  /// The hypervolume of the front, mean over the draws, model units. To compare gains with.
  double mean_hypervolume() const { return mean_hypervolume_; }

  const std::vector<Point>& front_designs() const { return designs_; }
  bool any_feasible() const { return front_->any_feasible(); }

  /// The same unit for a standard deviation of noise: the volume of a box with sides of one s.d.
  double noise_volume() const;

 private:
  struct LimitView {
    std::size_t metric = 0;
    double lower = 0.0, upper = 0.0;  ///< model units, or the metric's own for an exact one
    bool satisfied_when_absent = true;
    bool in_reference = false;  ///< the reference point says it already
  };

  /// What the draws say about designs that are not evaluated yet.
  struct Given {
    std::vector<Eigen::MatrixXd> means;       ///< [n_metrics] of [n_samples, m], or empty
    std::vector<Eigen::VectorXd> deviations;  ///< [n_metrics] of [m], or empty
    Eigen::VectorXd log_success;              ///< [m]
  };

  Given predict(const std::vector<Point>& xs) const;
  Eigen::VectorXd log_feasible(const Given& given, Eigen::Index k, const Point& x,
                               bool all_limits) const;
  void view_objectives(const Input& input);
  void view_limits(const Input& input);
  void choose_front_designs(const Input& input);
  void draw(const Input& input);
  bool limits_met(std::size_t design, int sample) const;
  double exact(std::size_t metric, const Point& x) const;
  const surrogate::PosteriorSamples* samples(std::size_t metric) const {
    return samples_[metric].get();
  }

  const Problem& problem_;
  const Models& models_;
  Eigen::VectorXd reference_, ideal_;  // [n_objectives], view units
  std::vector<ObjectiveView> objectives_;
  std::vector<LimitView> limits_;
  std::vector<Point> designs_;                                         // [p]
  std::vector<std::vector<std::optional<double>>> observed_;           // [p]; empty: pending
  std::vector<std::unique_ptr<surrogate::PosteriorSamples>> samples_;  // [n_metrics]
  std::optional<acquisition::NoisyFront> front_;
  int n_samples_;
  double mean_hypervolume_ = 0.0;
};

}  // namespace parapet::bayesian
