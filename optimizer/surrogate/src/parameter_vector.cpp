#include "parameter_vector.hpp"

#include <algorithm>
#include <cmath>

namespace parapet::surrogate {
namespace {

constexpr double least_noise = 1e-4;  // of an output's standard deviation
constexpr double greatest_noise = 3.0;

void set_length_priors(const ParameterVector& vector, int level, Priors& priors) {
  // Distances in the unit cube grow as sqrt(d), and so does the scale on which a function of d
  // variables is expected to change (Hvarfner, Hellsten and Nardi, Vanilla Bayesian optimization
  // performs great in high dimensions, ICML 2024). Their log-normal has median 4.1 sqrt(d) and mode
  // 0.2 sqrt(d); on the log scale, where the maximum is sought here, the centre lies between.
  const double d = std::max(1, vector.n_groups());
  for (int group = 0; group < vector.n_groups(); ++group) {
    const Eigen::Index i = vector.length(level, group);
    priors.centre(i) = 0.5 * std::log(d);
    priors.deviation(i) = 1.2;
    priors.bounds.lower(i) = std::log(0.01);
    priors.bounds.upper(i) = std::log(300.0);
  }
}

void set_noise_prior(Eigen::Index i, const double* known, Priors& priors) {
  priors.centre(i) = std::log(0.05);
  priors.deviation(i) = 1.2;
  if (known != nullptr) {
    priors.centre(i) = std::log(std::clamp(*known, least_noise, greatest_noise));
    priors.deviation(i) = 0.1;
  }
  priors.bounds.lower(i) = std::log(least_noise);
  priors.bounds.upper(i) = std::log(greatest_noise);
}

/// The coarsest mean is N(0, 1); each finer one differs from the next coarser one by N(0, 0.5^2).
Eigen::MatrixXd precision_of_means(Eigen::Index n_levels) {
  Eigen::MatrixXd precision = Eigen::MatrixXd::Zero(n_levels, n_levels);
  precision(n_levels - 1, n_levels - 1) = 1.0;
  for (Eigen::Index l = 0; l + 1 < n_levels; ++l) {
    precision(l, l) += 4.0;
    precision(l + 1, l + 1) += 4.0;
    precision(l, l + 1) -= 4.0;
    precision(l + 1, l) -= 4.0;
  }
  return precision;
}

}  // namespace

Eigen::VectorXd ParameterVector::pack(const std::vector<LevelParameters>& levels) const {
  Eigen::VectorXd x(size());
  for (int l = 0; l < n_levels_; ++l) {
    const LevelParameters& level = levels[static_cast<std::size_t>(l)];
    x.segment(length(l, 0), n_groups_) = level.length_scales.array().log().matrix();
    x(amplitude(l)) = std::log(level.amplitude);
    x(noise(l)) = std::log(level.noise);
    x(coupling(l)) = level.coupling;
  }
  return x;
}

std::vector<LevelParameters> ParameterVector::unpack(const Eigen::VectorXd& x) const {
  std::vector<LevelParameters> levels(static_cast<std::size_t>(n_levels_));
  for (int l = 0; l < n_levels_; ++l) {
    LevelParameters& level = levels[static_cast<std::size_t>(l)];
    level.length_scales = x.segment(length(l, 0), n_groups_).array().exp().matrix();
    level.amplitude = std::exp(x(amplitude(l)));
    level.noise = std::exp(x(noise(l)));
    level.coupling = x(coupling(l));
  }
  return levels;
}

double Priors::log_density(const Eigen::VectorXd& x, Eigen::VectorXd& gradient) const {
  const Eigen::ArrayXd t = (x - centre).array() / deviation.array();
  gradient.array() -= t / deviation.array();
  return -0.5 * t.square().sum();
}

Priors make_priors(const ParameterVector& vector, const std::vector<double>& known_noise) {
  Priors priors;
  const Eigen::Index n = vector.size();
  priors.centre = priors.bounds.lower = priors.bounds.upper = Eigen::VectorXd::Zero(n);
  priors.deviation = Eigen::VectorXd::Ones(n);
  const int coarsest = vector.n_levels() - 1;
  for (int l = 0; l <= coarsest; ++l) {
    set_length_priors(vector, l, priors);
    // What a finer level adds to its coarser neighbour is expected to be the smaller part.
    const Eigen::Index a = vector.amplitude(l);
    priors.centre(a) = l == coarsest ? 0.0 : std::log(0.4);
    priors.deviation(a) = 0.7;
    priors.bounds.lower(a) = std::log(0.005);
    priors.bounds.upper(a) = std::log(20.0);
    const auto s = static_cast<std::size_t>(l);
    set_noise_prior(vector.noise(l), known_noise.empty() ? nullptr : &known_noise[s], priors);
    if (l == coarsest) continue;  // its coupling stays 0
    const Eigen::Index c = vector.coupling(l);
    priors.centre(c) = 1.0;  // the levels share one transform
    priors.deviation(c) = 0.3;
    priors.bounds.lower(c) = -1.0;
    priors.bounds.upper(c) = 3.0;
  }
  priors.mean_precision = precision_of_means(vector.n_levels());
  return priors;
}

}  // namespace parapet::surrogate
