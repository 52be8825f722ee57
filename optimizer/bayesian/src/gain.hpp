/// What a design is expected to bring: the acquisition function, in log space.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "models.hpp"
#include "objective_view.hpp"
#include "parapet/acquisition/improvement.hpp"
#include "parapet/surrogate/gaussian_process.hpp"

namespace parapet::bayesian {

/// Noisy expected hypervolume improvement at the finest level, times the probabilities of meeting
/// the limits and of the evaluation succeeding, of an evaluation at any level. Every metric is a
/// process of its own; given them, outcomes are independent, except that a limit on an objective's
/// own metric moves the reference point. A composed metric is evaluated on the draws of its inputs;
/// of a design that is not evaluated it is a normal variable about such values, see NormalSplit.
/// While no design meets the limits in any draw, the gain is the probability of meeting them.
///
/// The draws are joint over the designs that may matter (told, at any level) and those pending, of
/// their values at the finest level. So the front holds designs known through coarse evaluations,
/// with their uncertainty.
///
/// With several levels an evaluation shows a share r of the variance of a value at the finest level
/// (informative_share), and the gain is that of the mean after it: deviations are multiplied by
/// sqrt(r). A limit that the mean breaks is met after the evaluation only if that shows it, so
/// there sqrt(r) enters too: a level that tells nothing about a load cannot find a design that
/// bears it.
class Gain {
 public:
  struct Input {
    const Problem& problem;
    const Models& models;
    const std::vector<Told>& told;
    const std::vector<Suggestion>& pending;
    Eigen::VectorXd reference;               ///< [n_objectives], minimised, metrics' units
    std::vector<double> level_cost = {1.0};  ///< [n_levels]
    int n_samples = 64;
    std::uint64_t seed = 1;
    double tolerance = 0.0;
  };

  /// All that the input refers to must outlive this. Every objective needs a model or to be exact.
  explicit Gain(const Input& input);

  /// Designs weighed: the best level of each.
  struct Value {
    Eigen::VectorXd log_gain_per_cost;  ///< [m]
    std::vector<int> level;             ///< [m]
  };

  /// Designs with what the models alone say of them.
  struct Prepared {
    std::vector<Point> xs;                          ///< [m]
    std::vector<surrogate::PreparedInputs> inputs;  ///< [n_metrics]; empty where not wanted
    Eigen::VectorXd log_success;                    ///< [m]
    /// [n_levels][n_metrics] of [m]: what an evaluation shows of the variance; empty for one level
    std::vector<std::vector<Eigen::VectorXd>> shares;

    /// Of the standard deviation.
    double shown(std::size_t level, std::size_t metric, Eigen::Index k) const {
      return shares.empty() ? 1.0 : std::sqrt(shares[level][metric][k]);
    }
  };
  Prepared prepare(std::vector<Point> xs) const;

  /// Of designs that are not evaluated yet: log of the expected gain over the level's cost, at the
  /// level where it is largest.
  Value value(const Prepared& prepared) const { return value(prepared, n_samples_); }
  Value value(const std::vector<Point>& xs) const { return value(prepare(xs)); }

  /// A rough value, by the first few draws alone.
  Value screen(const std::vector<Point>& xs) const;

  /// A design becomes pending: its outcome joins the draws, which else stay as they are.
  void add_pending(const Point& x);

  /// log of (largest variance of an objective, model units, times the probabilities of meeting the
  /// limits and of success) [m].
  Eigen::VectorXd log_ignorance(const std::vector<Point>& xs) const;

  /// The hypervolume of the front, mean over the draws, in the unit of the gains.
  double mean_hypervolume() const { return mean_hypervolume_; }

  const std::vector<Point>& front_designs() const { return designs_; }
  double level_cost(std::size_t level) const { return level_cost_[level]; }  ///< as given
  bool any_feasible() const { return front_->any_feasible(); }

  /// The same unit for a standard deviation of noise: the volume of a box with sides of one s.d.
  double noise_volume() const;

 private:
  struct LimitView {
    std::size_t metric = 0;
    double lower = 0.0, upper = 0.0;  ///< model units, or the metric's own for an exact one
    bool satisfied_when_absent = true;
    bool in_reference = false;  ///< the reference point says it already
    bool composed = false;
  };

  /// A composed metric of one design at one level.
  struct Composed {
    Eigen::VectorXd values;  ///< [n_draws], NaN where it has none
    double deviation = 0.0;
  };

  /// What the draws say about designs that are not evaluated yet.
  struct Given {
    std::vector<Eigen::MatrixXd> means;       ///< [n_metrics] of [n_samples, m], or empty
    std::vector<Eigen::VectorXd> deviations;  ///< [n_metrics] of [m], or empty
  };

  Given predict(const Prepared& prepared) const;
  Eigen::VectorXd log_feasible(const Prepared& prepared, const Given& given, Eigen::Index k,
                               bool all_limits, std::size_t level, int draws) const;
  Eigen::VectorXd log_gain(const Prepared& prepared, const Given& given, std::size_t level,
                           int draws) const;
  Value value(const Prepared& prepared, int draws) const;
  bool wanted(std::size_t metric) const;
  void view_objectives(const Input& input);
  void view_limits(const Input& input);
  void choose_front_designs(const Input& input);
  bool in_draws(const Point& x) const;
  void draw(std::uint64_t seed);
  void make_front();
  bool limits_met(std::size_t design, int sample) const;
  double exact(std::size_t metric, const Point& x) const;
  void note_exact();
  Composed composed(std::size_t metric, const Prepared& prepared, const Given& given,
                    Eigen::Index k, std::size_t level, int draws) const;
  double composed_draw(std::size_t metric, std::size_t design, int sample) const;
  double objective_draw(const ObjectiveView& view, std::size_t design, int sample) const;
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
  std::vector<std::vector<double>> exact_;                             // [p] of [n_metrics]
  std::vector<std::unique_ptr<surrogate::PosteriorSamples>> samples_;  // [n_metrics]
  std::vector<Eigen::VectorXd> normals_;  // [n_metrics] of [n_samples]; of inputs of composed ones
  std::optional<acquisition::NoisyFront> front_;
  std::vector<double> level_cost_;
  int n_samples_;
  double mean_hypervolume_ = 0.0;
};

}  // namespace parapet::bayesian
