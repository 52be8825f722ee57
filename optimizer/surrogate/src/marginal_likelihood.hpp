/// Log marginal likelihood of a Gaussian process and its gradient.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "parameter_vector.hpp"

namespace parapet::surrogate {

/// Inverse [n, n] (both triangles) of L L' for a lower triangular L [n, n]; about n^3 / 3
/// multiplications each for the inverse of L and for its square.
Eigen::MatrixXd inverse_from_factor(const Eigen::MatrixXd& factor);

/// The levels' means [n_levels] that maximise the likelihood and their prior, given the inverse of
/// the covariance [n, n] (generalised least squares).
Eigen::VectorXd best_means(const Eigen::MatrixXd& inverse, const Eigen::VectorXd& z,
                           const std::vector<int>& levels, const Eigen::MatrixXd& mean_precision);

/// log N(z; H m, K + noise) + log prior as a function of the parameter vector, with
/// the means m at their best. Costs n^3 + n^2 n_groups n_levels, the gradient included: with
/// S = alpha alpha' - (K + noise)^-1 every derivative is tr(S dK) / 2 (Rasmussen and Williams,
/// 2006, eq. 5.9). The observations are kept sorted by level, so that process k, which only levels
/// 0 .. k see, covers a leading block.
class MarginalLikelihood {
 public:
  /// inputs [n, n_features], z [n] model units, levels [n]; n >= 1.
  MarginalLikelihood(const Layout& layout, const Eigen::MatrixXd& inputs, const Eigen::VectorXd& z,
                     const std::vector<int>& levels, const Priors& priors);

  /// Log likelihood plus log prior at x; -infinity where the matrix is not positive definite.
  /// gradient [size of the vector].
  double evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& gradient) const;

 private:
  struct Process {
    Eigen::ArrayXd correlation;  // [pairs seen] Matern 5/2
    Eigen::ArrayXd slope;  // [pairs seen] d correlation / d log l = slope * (difference / l)^2
  };
  Process evaluate_process(const LevelParameters& level, Eigen::Index n_seen) const;
  Eigen::MatrixXd assemble(const std::vector<LevelParameters>& levels,
                           const Eigen::MatrixXd& shares,
                           const std::vector<Process>& processes) const;
  Eigen::ArrayXd sensitivity(const Eigen::MatrixXd& inverse, const Eigen::VectorXd& alpha) const;
  void add_process_gradient(int k, const std::vector<LevelParameters>& levels,
                            const Eigen::MatrixXd& shares, const Process& process,
                            const Eigen::ArrayXd& s, Eigen::VectorXd& gradient) const;

  ParameterVector vector_;
  const Priors& priors_;
  Eigen::VectorXd z_;              // [n] sorted by level
  std::vector<int> levels_;        // [n] ascending
  std::vector<Eigen::Index> end_;  // [n_levels] observations of levels 0 .. l
  // [n (n + 1) / 2, n_groups] squared differences; pair (j, i), j <= i, in row i (i + 1) / 2 + j.
  Eigen::ArrayXXd squares_;
};

}  // namespace parapet::surrogate
