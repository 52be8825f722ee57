#include "probit_laplace.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "parapet/math/normal.hpp"
#include "triangular.hpp"

namespace parapet::surrogate {
namespace {

/// First, minus second and third derivative of log Phi(sign f) by f.
struct Derivatives {
  double first, weight, third;
};
Derivatives derivatives(double sign, double f) {
  const double t = sign * f;
  const double h = math::normal_hazard(t);
  const double weight = std::max(h * (h + t), 0.0);
  return {sign * h, weight, sign * (weight * (2.0 * h + t) - h)};
}

/// log posterior of the latent values but for a constant; b = K^-1 (latent - mean).
double objective(const Eigen::VectorXd& signs, const Eigen::VectorXd& latent, double mean,
                 const Eigen::VectorXd& b) {
  double sum = -0.5 * b.dot((latent.array() - mean).matrix());
  for (Eigen::Index i = 0; i < signs.size(); ++i) sum += math::log_normal_cdf(signs(i) * latent(i));
  return sum;
}

void differentiate(const Eigen::VectorXd& signs, LaplaceMode& mode) {
  for (Eigen::Index i = 0; i < signs.size(); ++i) {
    const Derivatives d = derivatives(signs(i), mode.latent(i));
    mode.gradient(i) = d.first;
    mode.root_weights(i) = std::sqrt(d.weight);
    mode.third(i) = d.third;
  }
}

Eigen::MatrixXd factorize(const Eigen::MatrixXd& covariance, const Eigen::VectorXd& root) {
  Eigen::MatrixXd b = root.asDiagonal() * covariance * root.asDiagonal();
  b.diagonal().array() += 1.0;  // eigenvalues of at least 1: always positive definite
  return b.llt().matrixL();
}

/// B^-1 v for the factor of B.
Eigen::MatrixXd solve(const Eigen::MatrixXd& factor, Eigen::MatrixXd v) {
  solve_lower(factor, v);
  solve_lower_transposed(factor, v);
  return v;
}

}  // namespace

LaplaceMode find_mode(const Eigen::MatrixXd& covariance, const Eigen::VectorXd& signs,
                      double mean) {
  const Eigen::Index n = signs.size();
  LaplaceMode mode;
  mode.latent = Eigen::VectorXd::Constant(n, mean);
  mode.gradient = mode.third = mode.root_weights = Eigen::VectorXd::Zero(n);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(n);  // K^-1 (latent - mean)
  double value = objective(signs, mode.latent, mean, b);
  for (int iteration = 0; iteration < 50; ++iteration) {
    differentiate(signs, mode);
    mode.factor = factorize(covariance, mode.root_weights);
    const Eigen::VectorXd w = mode.root_weights.cwiseAbs2();
    const Eigen::VectorXd c = w.cwiseProduct((mode.latent.array() - mean).matrix()) + mode.gradient;
    const Eigen::VectorXd newton =
        c - mode.root_weights.cwiseProduct(
                solve(mode.factor, mode.root_weights.cwiseProduct(covariance * c)).col(0));
    Eigen::VectorXd step = newton - b;
    double gain = 0.0;
    for (int half = 0; half < 10; ++half, step *= 0.5) {
      const Eigen::VectorXd trial = b + step;
      const Eigen::VectorXd latent = (covariance * trial).array() + mean;
      const double next = objective(signs, latent, mean, trial);
      if (!(next > value)) continue;
      gain = next - value;
      b = trial;
      mode.latent = latent;
      value = next;
      break;
    }
    if (gain < 1e-12 * (1.0 + std::abs(value))) break;
  }
  differentiate(signs, mode);
  mode.factor = factorize(covariance, mode.root_weights);
  mode.log_evidence = value - mode.factor.diagonal().array().log().sum();
  return mode;
}

ProbitEvidence::ProbitEvidence(const Layout& layout, const Eigen::MatrixXd& inputs,
                               const Eigen::VectorXd& signs)
    : signs_(signs) {
  const Eigen::Index n = signs.size();
  const int n_groups = layout.n_groups();
  squares_.assign(static_cast<std::size_t>(n_groups), Eigen::ArrayXXd::Zero(n, n));
  for (Eigen::Index f = 0; f < inputs.cols(); ++f) {
    auto& square = squares_[static_cast<std::size_t>(layout.group[static_cast<std::size_t>(f)])];
    for (Eigen::Index i = 0; i < n; ++i) {
      square.col(i) += (inputs.col(f).array() - inputs(i, f)).square();
    }
  }
  // Few failures say little about the parameters, so these priors are narrower than those of
  // GaussianProcess; a failure is expected to warn of half the cube's diagonal and no more.
  const Eigen::Index amplitude = n_groups;
  centre_ = Eigen::VectorXd::Constant(size(), std::log(0.5 * std::sqrt(std::max(1, n_groups))));
  centre_(amplitude) = std::log(1.5);
  deviation_ = Eigen::VectorXd::Constant(size(), 0.8);
  bounds_.lower = Eigen::VectorXd::Constant(size(), std::log(0.02));
  bounds_.upper = Eigen::VectorXd::Constant(size(), std::log(100.0));
  bounds_.upper(amplitude) = std::log(10.0);
  const auto successes = static_cast<double>((signs.array() > 0.0).count());
  // Half a success and half a failure more (Jeffreys), so that the rate is never 0 or 1.
  base_quantile_ = math::normal_quantile((successes + 0.5) / (static_cast<double>(n) + 1.0));
}

Eigen::MatrixXd ProbitEvidence::covariance(const Eigen::VectorXd& x, Eigen::ArrayXXd* slope) const {
  const Eigen::Index n = signs_.size();
  Eigen::ArrayXXd r = Eigen::ArrayXXd::Zero(n, n);
  for (std::size_t g = 0; g < squares_.size(); ++g) {
    r += (5.0 * std::exp(-2.0 * x(static_cast<Eigen::Index>(g)))) * squares_[g];
  }
  r = r.sqrt();
  const double variance = std::exp(2.0 * x(size() - 1));
  const Eigen::ArrayXXd decay = variance * (-r).exp();
  if (slope != nullptr) *slope = (5.0 / 3.0) * (1.0 + r) * decay;
  return ((1.0 + r + r.square() / 3.0) * decay).matrix();
}

LaplaceMode ProbitEvidence::mode(const Eigen::VectorXd& x) const {
  return find_mode(covariance(x, nullptr), signs_, base_quantile_);
}

double ProbitEvidence::evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& gradient) const {
  Eigen::ArrayXXd slope;
  const Eigen::MatrixXd k = covariance(x, &slope);
  const LaplaceMode at = find_mode(k, signs_, base_quantile_);
  const auto root = at.root_weights.asDiagonal();
  // R = (K + W^-1)^-1; C = L^-1 W^1/2 K; the evidence's slope by the latent values through W.
  const Eigen::MatrixXd inverse = root * solve(at.factor, Eigen::MatrixXd(root));
  Eigen::MatrixXd c = root * k;
  solve_lower(at.factor, c);
  const Eigen::VectorXd by_latent =
      0.5 * (k.diagonal() - c.colwise().squaredNorm().transpose()).cwiseProduct(at.third);
  // The mode moves with the parameters: d latent = (I - K R) dK gradient.
  const Eigen::VectorXd moved = by_latent - inverse * (k * by_latent);
  const Eigen::ArrayXXd s = (0.5 * at.gradient * at.gradient.transpose() - 0.5 * inverse +
                             moved * at.gradient.transpose())
                                .array();
  gradient.resize(size());
  for (std::size_t g = 0; g < squares_.size(); ++g) {
    const auto i = static_cast<Eigen::Index>(g);
    gradient(i) = (s * slope * squares_[g]).sum() * std::exp(-2.0 * x(i));
  }
  gradient(size() - 1) = 2.0 * (s * k.array()).sum();
  const Eigen::ArrayXd t = (x - centre_).array() / deviation_.array();
  gradient.array() -= t / deviation_.array();
  return at.log_evidence - 0.5 * t.square().sum();
}

}  // namespace parapet::surrogate
