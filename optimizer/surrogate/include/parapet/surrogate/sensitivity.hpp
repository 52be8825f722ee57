/// Which variables an output depends on: main effects and Sobol' indices.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

namespace parapet::surrogate {

/// Several realisations of an output at points of the unit cube: u [m, n_variables] in, [m,
/// n_realisations] out. One column for a known function; several posterior draws for a surrogate.
using Realisations = std::function<Eigen::MatrixXd(const Eigen::MatrixXd& u)>;

/// A number with what is known of its error.
struct Interval {
  double value = 0.0, lower = 0.0, upper = 0.0;  ///< estimate and its 95 % interval
};

/// What one variable explains of the output's variance, as shares of 1.
struct SobolIndices {
  Interval first;  ///< share of the variance that the variable explains alone
  Interval total;  ///< with all its interactions
};

/// How much is spent on an estimate.
struct SensitivityOptions {
  int base_points = 1024;  ///< N; the model is asked at N (n_variables + 2) points
  int bootstrap = 200;
  std::uint64_t seed = 1;
};

/// First-order and total indices [n_variables] for inputs that are independent and uniform: the
/// estimators of Saltelli et al. (Comput. Phys. Commun. 181 (2010) 259-270; Jansen's for totals) on
/// scrambled Sobol' points. The intervals cover the sampling (bootstrap) and the spread over the
/// realisations. All zero where the output does not vary.
std::vector<SobolIndices> sobol_indices(const Realisations& model, int n_variables,
                                        const SensitivityOptions& options = {});

/// The mean output as a function of one variable, all others averaged over the cube.
struct MainEffect {
  std::vector<double> u;         ///< [n_grid] places in [0, 1]
  std::vector<Interval> effect;  ///< [n_grid], in the output's unit; spread over the realisations
};

/// The main effect of every variable [n_variables], for inputs that are independent and uniform.
/// @param n_grid places per variable
/// @param n_points over which the others are averaged
std::vector<MainEffect> main_effects(const Realisations& model, int n_variables, int n_grid = 17,
                                     int n_points = 512, std::uint64_t seed = 1);

}  // namespace parapet::surrogate
