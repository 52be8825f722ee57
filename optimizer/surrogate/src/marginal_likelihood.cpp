#include "marginal_likelihood.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "covariance.hpp"
#include "fit_constants.hpp"

namespace parapet::surrogate {
namespace {

constexpr Eigen::Index block = 48;

Eigen::Index pairs(Eigen::Index n) {
  return n * (n + 1) / 2;
}

/// Calls visit(level, first pair, count) for the runs of equal level among pairs (0 .. i, i).
template <typename Visit>
void for_runs(const std::vector<Eigen::Index>& end, Eigen::Index i, const Visit& visit) {
  Eigen::Index begin = 0;
  for (std::size_t m = 0; m < end.size() && begin <= i; ++m) {
    const Eigen::Index stop = std::min(end[m], i + 1);
    if (stop > begin) visit(static_cast<Eigen::Index>(m), pairs(i) + begin, stop - begin);
    begin = std::max(begin, stop);
  }
}

}  // namespace

Eigen::MatrixXd inverse_from_factor(const Eigen::MatrixXd& factor) {
  const Eigen::Index n = factor.rows();
  Eigen::MatrixXd lower = Eigen::MatrixXd::Identity(n, n);  // becomes L^-1
  for (Eigen::Index b = 0; b < n; b += block) {
    auto columns = lower.block(b, b, n - b, std::min(block, n - b));
    factor.bottomRightCorner(n - b, n - b).triangularView<Eigen::Lower>().solveInPlace(columns);
  }
  Eigen::MatrixXd inverse(n, n);
  for (Eigen::Index b = 0; b < n; b += block) {
    const Eigen::Index width = std::min(block, n - b);
    inverse.block(b, b, n - b, width).noalias() =
        lower.bottomRightCorner(n - b, n - b).transpose().triangularView<Eigen::Upper>() *
        lower.block(b, b, n - b, width);
  }
  inverse.triangularView<Eigen::StrictlyUpper>() = inverse.transpose();
  return inverse;
}

Eigen::VectorXd best_means(const Eigen::MatrixXd& inverse, const Eigen::VectorXd& z,
                           const std::vector<int>& levels, const Eigen::MatrixXd& mean_precision) {
  const Eigen::Index n_levels = mean_precision.rows();
  Eigen::MatrixXd indicator = Eigen::MatrixXd::Zero(z.size(), n_levels);
  for (Eigen::Index i = 0; i < z.size(); ++i) {
    indicator(i, levels[static_cast<std::size_t>(i)]) = 1.0;
  }
  const Eigen::MatrixXd weighted = inverse * indicator;
  const Eigen::MatrixXd matrix = indicator.transpose() * weighted + mean_precision;
  return matrix.ldlt().solve(weighted.transpose() * z);
}

MarginalLikelihood::MarginalLikelihood(const Layout& layout, const Eigen::MatrixXd& inputs,
                                       const Eigen::VectorXd& z, const std::vector<int>& levels,
                                       const Priors& priors)
    : vector_(layout.n_groups(), layout.n_levels), priors_(priors) {
  const Eigen::Index n = z.size();
  std::vector<Eigen::Index> order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
    return levels[static_cast<std::size_t>(a)] < levels[static_cast<std::size_t>(b)];
  });
  z_.resize(n);
  Eigen::MatrixXd sorted(n, inputs.cols());
  end_.assign(static_cast<std::size_t>(layout.n_levels), 0);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index from = order[static_cast<std::size_t>(i)];
    z_(i) = z(from);
    sorted.row(i) = inputs.row(from);
    const int level = levels[static_cast<std::size_t>(from)];
    levels_.push_back(level);
    for (std::size_t l = static_cast<std::size_t>(level); l < end_.size(); ++l) end_[l] = i + 1;
  }
  squares_ = Eigen::ArrayXXd::Zero(pairs(n), vector_.n_groups());
  for (Eigen::Index f = 0; f < sorted.cols(); ++f) {
    const auto group = layout.group[static_cast<std::size_t>(f)];
    for (Eigen::Index i = 0; i < n; ++i) {
      squares_.col(group).segment(pairs(i), i + 1) +=
          (sorted.col(f).head(i + 1).array() - sorted(i, f)).square();
    }
  }
}

MarginalLikelihood::Process MarginalLikelihood::evaluate_process(const LevelParameters& level,
                                                                 Eigen::Index n_seen) const {
  const Eigen::VectorXd inverse = 5.0 * level.length_scales.array().square().inverse().matrix();
  const Eigen::ArrayXd r = (squares_.topRows(pairs(n_seen)).matrix() * inverse).array().sqrt();
  const Eigen::ArrayXd decay = (-r).exp();
  return {(1.0 + r + r.square() / 3.0) * decay, (5.0 / 3.0) * (1.0 + r) * decay};
}

Eigen::MatrixXd MarginalLikelihood::assemble(const std::vector<LevelParameters>& levels,
                                             const Eigen::MatrixXd& shares,
                                             const std::vector<Process>& processes) const {
  const Eigen::Index n = z_.size();
  Eigen::MatrixXd upper = Eigen::MatrixXd::Zero(n, n);
  for (std::size_t k = 0; k < processes.size(); ++k) {
    const double variance = levels[k].amplitude * levels[k].amplitude;
    const auto column = static_cast<Eigen::Index>(k);
    for (Eigen::Index i = 0; i < end_[k]; ++i) {
      const double share = shares(levels_[static_cast<std::size_t>(i)], column) * variance;
      for_runs(end_, i, [&](Eigen::Index m, Eigen::Index first, Eigen::Index count) {
        upper.col(i).segment(first - pairs(i), count).array() +=
            share * shares(m, column) * processes[k].correlation.segment(first, count);
      });
    }
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    const double noise =
        levels[static_cast<std::size_t>(levels_[static_cast<std::size_t>(i)])].noise;
    upper(i, i) += noise * noise;
  }
  return upper;
}

Eigen::ArrayXd MarginalLikelihood::sensitivity(const Eigen::MatrixXd& inverse,
                                               const Eigen::VectorXd& alpha) const {
  const Eigen::Index n = z_.size();
  Eigen::ArrayXd s(pairs(n));
  for (Eigen::Index i = 0; i < n; ++i) {
    // Twice for a pair and its mirror image, half from tr(S dK) / 2.
    auto part = s.segment(pairs(i), i + 1);
    part = (alpha(i) * alpha.head(i + 1) - inverse.col(i).head(i + 1)).array();
    part(i) *= 0.5;
  }
  return s;
}

void MarginalLikelihood::add_process_gradient(int k, const std::vector<LevelParameters>& levels,
                                              const Eigen::MatrixXd& shares, const Process& process,
                                              const Eigen::ArrayXd& s,
                                              Eigen::VectorXd& gradient) const {
  const LevelParameters& own = levels[static_cast<std::size_t>(k)];
  const double variance = own.amplitude * own.amplitude;
  const Eigen::Index n_seen = end_[static_cast<std::size_t>(k)];
  Eigen::VectorXd weight(pairs(n_seen));                       // dK / d correlation times s
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(k + 1, k + 1);  // of s M over pairs of levels
  for (Eigen::Index i = 0; i < n_seen; ++i) {
    const int l = levels_[static_cast<std::size_t>(i)];
    for_runs(end_, i, [&](Eigen::Index m, Eigen::Index first, Eigen::Index count) {
      const auto part = s.segment(first, count);
      sums(l, m) += (part * process.correlation.segment(first, count)).sum();
      weight.segment(first, count) =
          (variance * shares(l, k) * shares(m, k) * part * process.slope.segment(first, count))
              .matrix();
    });
  }
  const Eigen::VectorXd by_group = squares_.topRows(pairs(n_seen)).matrix().transpose() * weight;
  for (int g = 0; g < vector_.n_groups(); ++g) {
    gradient(vector_.length(k, g)) += by_group(g) / (own.length_scales(g) * own.length_scales(g));
  }
  const Eigen::VectorXd share = shares.col(k).head(k + 1);
  gradient(vector_.amplitude(k)) += 2.0 * variance * share.dot(sums * share);
  for (int q = 0; q < k; ++q) {
    // d share(l, k) / d rho_q for the levels l <= q below: share(l, q) share(q + 1, k).
    Eigen::VectorXd change = Eigen::VectorXd::Zero(k + 1);
    change.head(q + 1) = shares.col(q).head(q + 1) * shares(q + 1, k);
    gradient(vector_.coupling(q)) +=
        variance * (change.dot(sums * share) + share.dot(sums * change));
  }
}

double MarginalLikelihood::evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& gradient) const {
  const std::vector<LevelParameters> levels = vector_.unpack(x);
  const Eigen::MatrixXd shares = process_shares(levels);
  std::vector<Process> processes;
  for (std::size_t k = 0; k < levels.size(); ++k) {
    processes.push_back(evaluate_process(levels[k], end_[k]));
  }
  Eigen::MatrixXd factor = assemble(levels, shares, processes).transpose();
  const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> cholesky(factor);
  gradient = Eigen::VectorXd::Zero(vector_.size());
  if (cholesky.info() != Eigen::Success) return -std::numeric_limits<double>::infinity();
  const Eigen::MatrixXd inverse = inverse_from_factor(factor);
  const Eigen::VectorXd means = best_means(inverse, z_, levels_, priors_.mean_precision);
  Eigen::VectorXd residual = z_;
  for (Eigen::Index i = 0; i < z_.size(); ++i) {
    residual(i) -= means(levels_[static_cast<std::size_t>(i)]);
  }
  const Eigen::VectorXd alpha = inverse * residual;
  const Eigen::ArrayXd s = sensitivity(inverse, alpha);
  for (int k = 0; k < vector_.n_levels(); ++k) {
    add_process_gradient(k, levels, shares, processes[static_cast<std::size_t>(k)], s, gradient);
  }
  for (Eigen::Index i = 0; i < z_.size(); ++i) {
    const int l = levels_[static_cast<std::size_t>(i)];
    const double noise = levels[static_cast<std::size_t>(l)].noise;
    gradient(vector_.noise(l)) += 2.0 * noise * noise * s(pairs(i) + i);
  }
  const double log_likelihood = -0.5 * residual.dot(alpha) - factor.diagonal().array().log().sum() -
                                0.5 * static_cast<double>(z_.size()) * log_two_pi;
  return log_likelihood - 0.5 * means.dot(priors_.mean_precision * means) +
         priors_.log_density(x, gradient);
}

}  // namespace parapet::surrogate
