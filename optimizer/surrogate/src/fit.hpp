/// Parameters of a Gaussian process by maximum a posteriori.
#pragma once

#include "parapet/surrogate/gaussian_process.hpp"

namespace parapet::surrogate {

/// Inverse covariance of the levels' means under the prior [n_levels, n_levels].
Eigen::MatrixXd mean_precision(int n_levels);

/// Standard deviations of noise in model units [n_levels]; empty where they are not known. A slope
/// that varies with the value (log, bilog) is averaged geometrically over the level's data.
std::vector<double> noise_in_model_units(const Data& data, int n_levels,
                                         const OutputTransform& transform,
                                         const std::vector<double>& known_noise);

/// The kind among identity, log (all values positive, largest more than 10 times the least) and
/// bilog under which the data are likeliest, Jacobian included; identity unless another is better
/// by 2 nats.
TransformKind likeliest_transform(const Layout& layout, const Data& data,
                                  const std::vector<double>& known_noise);

/// The levels' parameters (means left at 0) for values z [n] in model units; the priors' centre
/// where z does not vary or no start has a positive definite matrix. Of more than
/// most_for_parameters observations every k-th decides.
std::vector<LevelParameters> likeliest_parameters(const Layout& layout, const Data& data,
                                                  const Eigen::VectorXd& z,
                                                  const std::vector<double>& model_noise,
                                                  const FitOptions& options);

}  // namespace parapet::surrogate
