#include "surrogate_fits.hpp"

#include <algorithm>
#include <cmath>

namespace parapet::study {

using surrogate::GaussianProcess;

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

double in_unit(const GaussianProcess& process, double z, double deviation) {
  return 0.5 * (process.from_model(z + deviation) - process.from_model(z - deviation));
}

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

double typical_grid_square(const GaussianProcess& process, int level) {
  const std::vector<int>& levels = process.data().levels;
  Eigen::MatrixXd inputs(std::ranges::count(levels, level), process.data().inputs.cols());
  Eigen::Index row = 0;
  for (std::size_t k = 0; k < levels.size(); ++k) {
    if (levels[k] != level) continue;
    inputs.row(row++) = process.data().inputs.row(static_cast<Eigen::Index>(k));
  }
  return row == 0 ? 0.0 : grid_squares(process, inputs, level).mean();
}

GaussianProcess with_noise(const GaussianProcess& process, double noise) {
  const surrogate::Parameters& parameters = process.parameters();
  const surrogate::Data& data = process.data();
  surrogate::FitOptions options;
  options.transform = parameters.transform.kind;
  options.warm_start = parameters;
  options.starts = 2;
  for (int level = 0; level < process.layout().n_levels; ++level) {
    // What the fit will turn into `noise` again: it takes the mean slope at the level.
    double slope = 0.0, anywhere = 0.0, count = 0.0;
    for (Eigen::Index k = 0; k < data.values.size(); ++k) {
      const double log_slope = parameters.transform.log_slope(data.values[k]);
      anywhere += log_slope / static_cast<double>(data.values.size());
      if (data.levels[static_cast<std::size_t>(k)] != level) continue;
      slope += log_slope;
      count += 1.0;
    }
    options.known_noise.push_back(noise * std::exp(count > 0.0 ? -slope / count : -anywhere));
  }
  return GaussianProcess::fit(process.layout(), data, options);
}

}  // namespace parapet::study
