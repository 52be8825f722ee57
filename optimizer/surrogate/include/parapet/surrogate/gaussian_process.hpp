/// Gaussian process of one output, over several levels of fidelity (co-kriging).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "parapet/surrogate/output_transform.hpp"

namespace parapet::surrogate {

/// What the columns of the inputs mean. Several columns may share a length scale (the one-hot
/// columns of a choice do). Two rows that are equal in all columns are the same input.
struct Layout {
  std::vector<int> group;  ///< [n_features] length scale of each column, 0 .. n_groups - 1
  int n_levels = 1;        ///< level 0 is the finest, n_levels - 1 the coarsest
  int n_groups() const;    ///< number of length scales
};

/// What is known: observations of one output.
struct Data {
  Eigen::MatrixXd inputs;   ///< [n, n_features], each column within about [0, 1]
  Eigen::VectorXd values;   ///< [n], finite
  std::vector<int> levels;  ///< [n]; empty: all 0
};

/// One level's share of the model, in model units (transformed and standardised outputs).
struct LevelParameters {
  Eigen::VectorXd length_scales;  ///< [n_groups], > 0
  double amplitude = 1.0;         ///< standard deviation of this level's own process, > 0
  double noise = 0.1;             ///< standard deviation of an observation at this level, > 0
  double mean = 0.0;
  double coupling = 0.0;  ///< rho: factor of the next coarser level's process; 0 at the coarsest
};

/// Everything that the likelihood decides.
struct Parameters {
  OutputTransform transform;
  std::vector<LevelParameters> levels;  ///< [n_levels]
};

/// How the parameters are found.
struct FitOptions {
  TransformKind transform = TransformKind::automatic;
  int starts = 4;  ///< starting points of the likelihood's maximisation
  std::uint64_t seed = 1;
  std::vector<double> known_noise;       ///< [n_levels] s.d. in the output's unit; empty: unknown
  std::optional<Parameters> warm_start;  ///< an earlier fit's; the first starting point
  bool keep_parameters = false;          ///< condition on the data with warm_start as it is
};

/// Independent predictions, model units.
struct Prediction {
  Eigen::VectorXd mean;      ///< [m]
  Eigen::VectorXd variance;  ///< [m], of the noise-free value, >= 0
};

/// Joint prediction, model units.
struct JointPrediction {
  Eigen::VectorXd mean;        ///< [m]
  Eigen::MatrixXd covariance;  ///< [m, m], of the noise-free values
};

/// One observation predicted from all others, in the output's own unit.
struct LeaveOneOut {
  Eigen::VectorXd mean;      ///< [n], the median of the prediction
  Eigen::VectorXd lower;     ///< [n], 2.5 % of a new observation
  Eigen::VectorXd upper;     ///< [n], 97.5 %
  Eigen::VectorXd residual;  ///< [n], (z - mean) / s.d. in model units, standard normal if sound
  double q_squared = 0.0;    ///< 1 - sum of squared errors over that of the mean, model units
  double coverage_95 = 0.0;  ///< share of observations within lower .. upper
};

/// Matern 5/2 with one length scale per group of columns; between levels the autoregression of
/// Kennedy and O'Hagan (Biometrika 87 (2000) 1-13): f_l(x) = rho_l f_{l+1}(x) + delta_l(x), all
/// observations in one exact joint process, so that designs need not be nested.
/// Parameters maximise the log marginal likelihood plus log priors from several starts; of more
/// than 150 observations so many, evenly spaced, enter there, and all of them the prediction. Never
/// throws for data that are finite: equal values, repeated inputs, a single observation or an
/// ill-conditioned matrix give a process of large variance, not an error.
class GaussianProcess {
 public:
  /// @throws std::invalid_argument for shapes that do not fit or values that are not finite.
  static GaussianProcess fit(const Layout& layout, const Data& data, const FitOptions& options);

  /// Each value for itself; inputs [m, n_features].
  Prediction predict(const Eigen::MatrixXd& inputs, int level = 0) const;

  /// The means of predict() alone [m], which cost much less.
  Eigen::VectorXd predict_mean(const Eigen::MatrixXd& inputs, int level = 0) const;

  /// The values together, with their covariances; inputs [m, n_features].
  JointPrediction joint(const Eigen::MatrixXd& inputs, int level = 0) const;

  /// Posterior covariance [m, k] between f_level(a) and f_other(b); a [m, n_features].
  Eigen::MatrixXd covariance(const Eigen::MatrixXd& a, int level, const Eigen::MatrixXd& b,
                             int other) const;

  /// Squared posterior correlation [m] of f_level with f_0 at the same inputs; 1 at level 0.
  Eigen::VectorXd correlation_squared(const Eigen::MatrixXd& inputs, int level) const;

  /// Correlation of f_level(x) with f_0(x) over all x, by the prior with the parameters found,
  /// noise aside: -1 .. 1.
  double level_correlation(int level) const;

  /// Standard deviation of an observation's noise, model units.
  double noise(int level = 0) const {
    return parameters_.levels[static_cast<std::size_t>(level)].noise;
  }

  /// From the output's unit to model units; increasing.
  double to_model(double value) const { return parameters_.transform.to_model(value); }

  /// The inverse of to_model.
  double from_model(double z) const { return parameters_.transform.from_model(z); }

  /// Every observation predicted from the others, without a new fit.
  LeaveOneOut leave_one_out() const;
  double log_likelihood() const { return log_likelihood_; }  ///< model units, without priors

  const Layout& layout() const { return layout_; }              ///< as given
  const Data& data() const { return data_; }                    ///< as given, levels filled in
  const Parameters& parameters() const { return parameters_; }  ///< as found

 private:
  friend class PosteriorSamples;
  void condition(bool keep_means);
  void require_features(const Eigen::MatrixXd& inputs, int level) const;
  /// L^-1 k(data, inputs) [n, m] for f_level at the inputs.
  Eigen::MatrixXd whitened(const Eigen::MatrixXd& inputs, int level) const;

  Layout layout_;
  Data data_;  // levels filled in
  Parameters parameters_;
  Eigen::MatrixXd factor_;   // [n, n] lower Cholesky factor of K + noise
  Eigen::VectorXd weights_;  // [n] (K + noise)^-1 (z - mean)
  double log_likelihood_ = 0.0;
};

/// What a process alone says of inputs, kept so that it is computed once for many sets of draws.
struct PreparedInputs {
  Eigen::MatrixXd inputs;    ///< [m, n_features]
  Eigen::VectorXd mean;      ///< [m], model units
  Eigen::VectorXd variance;  ///< [m]
  Eigen::MatrixXd whitened;  ///< [n, m] covariance with the data, divided by their Cholesky factor
};

/// Joint draws of the noise-free values at some inputs, and what other inputs look like given them.
/// This is what an acquisition under noise integrates over.
class PosteriorSamples {
 public:
  /// at: [p, n_features], level 0; p may be 0. The same arguments give the same draws.
  PosteriorSamples(const GaussianProcess& process, const Eigen::MatrixXd& at, int n_samples,
                   std::uint64_t seed);

  /// One more input, in the draws of the others: these stay as they are. Costs n^2, not n^3.
  void append(const Eigen::RowVectorXd& input);

  const Eigen::MatrixXd& values() const { return values_; }  ///< [n_samples, p], model units

  /// Of inputs [m, n_features] what does not depend on the draws.
  PreparedInputs prepare(const Eigen::MatrixXd& inputs) const;

  /// Predictions at prepared inputs given each draw: mean [n_samples, m]; the variance [m] is the
  /// same for every draw. The process must still live.
  void predict(const PreparedInputs& prepared, Eigen::MatrixXd& mean,
               Eigen::VectorXd& variance) const;

  /// The same of inputs [m, n_features].
  void predict(const Eigen::MatrixXd& inputs, Eigen::MatrixXd& mean,
               Eigen::VectorXd& variance) const;

 private:
  const GaussianProcess& process_;
  std::uint64_t seed_;
  Eigen::MatrixXd at_;        // [p, n_features]
  Eigen::MatrixXd values_;    // [n_samples, p]
  Eigen::MatrixXd factor_;    // [p, p] Cholesky factor of the posterior covariance
  Eigen::MatrixXd normals_;   // [p, n_samples]
  Eigen::MatrixXd weights_;   // [p, n_samples] C^-1 (values - mean)
  Eigen::MatrixXd whitened_;  // [n, p] the process's data against these inputs
};

}  // namespace parapet::surrogate
