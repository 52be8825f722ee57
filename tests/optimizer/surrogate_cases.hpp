/// Layouts, parameters and data that several tests of the surrogates use.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>
#include <cstdint>
#include <vector>

#include "covariance.hpp"
#include "parapet/math/normal.hpp"
#include "parapet/surrogate/gaussian_process.hpp"
#include "unit_points.hpp"

namespace parapet::surrogate {

/// Every column its own length scale.
inline Layout plain_layout(int n_columns, int n_levels = 1) {
  Layout layout;
  for (int i = 0; i < n_columns; ++i) layout.group.push_back(i);
  layout.n_levels = n_levels;
  return layout;
}

inline LevelParameters level_parameters(const std::vector<double>& lengths, double amplitude,
                                        double noise, double mean, double coupling = 0.0) {
  LevelParameters level;
  level.length_scales =
      Eigen::Map<const Eigen::VectorXd>(lengths.data(), static_cast<Eigen::Index>(lengths.size()));
  level.amplitude = amplitude;
  level.noise = noise;
  level.mean = mean;
  level.coupling = coupling;
  return level;
}

/// Options that condition on the data with these parameters in the output's own unit.
inline FitOptions with_parameters(const std::vector<LevelParameters>& levels) {
  FitOptions options;
  options.warm_start = Parameters{OutputTransform{}, levels};
  options.keep_parameters = true;
  return options;
}

inline Eigen::MatrixXd column(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// Independent standard normals [n].
inline Eigen::VectorXd normals(Eigen::Index n, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  Eigen::VectorXd draws(n);
  for (double& draw : draws) draw = math::normal_quantile(uniform(generator));
  return draws;
}

/// A noise-free draw [n] of a one-level process at inputs [n, n_features], parameters as given.
inline Eigen::VectorXd draw_process(const Layout& layout, const LevelParameters& level,
                                    const Eigen::MatrixXd& inputs, std::uint64_t seed) {
  Eigen::MatrixXd k =
      level.amplitude * level.amplitude * matern(layout.group, level.length_scales, inputs, inputs);
  k.diagonal().array() += 1e-10;
  const Eigen::MatrixXd factor = k.llt().matrixL();
  return (factor * normals(inputs.rows(), seed)).array() + level.mean;
}

}  // namespace parapet::surrogate
