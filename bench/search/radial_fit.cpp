#include "radial_fit.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace parapet::bench::search {
namespace {

Eigen::MatrixXd cubic_kernel(const Eigen::MatrixXd& designs, const Eigen::VectorXd& scale) {
  const Eigen::MatrixXd x = designs * scale.asDiagonal();
  const Eigen::Index n = x.rows();
  Eigen::MatrixXd kernel(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    for (Eigen::Index i = 0; i <= j; ++i) {
      const double r = (x.row(i) - x.row(j)).norm();
      kernel(i, j) = kernel(j, i) = r * r * r;
    }
  }
  return kernel;
}

Eigen::MatrixXd linear_terms(const Eigen::MatrixXd& designs) {
  Eigen::MatrixXd terms(designs.rows(), designs.cols() + 1);
  terms.col(0).setOnes();
  terms.rightCols(designs.cols()) = designs;
  return terms;
}

// The system diagonalised once for all ridges: with Q2 an orthonormal basis of P^T w = 0 and
// Q2^T K Q2 = U diag(e) U^T, the upper left block of the inverse is V diag(1 / (e + ridge)) V^T,
// V = Q2 U.
struct Spectrum {
  Eigen::MatrixXd kernel;       // [n, n]
  Eigen::MatrixXd terms;        // P [n, d + 1]
  Eigen::VectorXd eigenvalues;  // e [n - d - 1]
  Eigen::MatrixXd vectors;      // V [n, n - d - 1]
  Eigen::MatrixXd squares;      // V^2
  Eigen::VectorXd projected;    // V^T values
};

Spectrum diagonalise(const Eigen::MatrixXd& designs, const Eigen::VectorXd& values,
                     const Eigen::VectorXd& scale) {
  Spectrum s;
  s.kernel = cubic_kernel(designs, scale);
  s.terms = linear_terms(designs);
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(s.terms);
  const Eigen::Index n = designs.rows();
  const Eigen::Index m = n - s.terms.cols();
  Eigen::MatrixXd basis = Eigen::MatrixXd::Zero(n, m);
  basis.bottomRows(m).setIdentity();
  basis = qr.householderQ() * basis;
  const Eigen::MatrixXd inner = basis.transpose() * s.kernel * basis;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(inner);
  s.eigenvalues = eigen.eigenvalues().cwiseMax(0.0);  // r^3 is conditionally positive definite
  s.vectors = basis * eigen.eigenvectors();
  s.squares = s.vectors.cwiseAbs2();
  s.projected = s.vectors.transpose() * values;
  return s;
}

// Residual of value i predicted from all others: w_i / (A^-1)_ii (Rippa, Adv. Comput. Math. 11
// (1999) 193-210), which holds with the tail as well.
Eigen::VectorXd leave_one_out(const Spectrum& s, double ridge) {
  const Eigen::VectorXd inverse = (s.eigenvalues.array() + ridge).inverse();
  const Eigen::VectorXd weights = s.vectors * s.projected.cwiseProduct(inverse);
  const Eigen::VectorXd diagonal = s.squares * inverse;
  return weights.cwiseQuotient(diagonal);
}

double root_mean_square(const Eigen::VectorXd& values) {
  return std::sqrt(values.squaredNorm() / static_cast<double>(values.size()));
}

double best_ridge(const Spectrum& s) {
  const double greatest = s.eigenvalues.maxCoeff();
  double best = greatest, least_error = std::numeric_limits<double>::infinity();
  // twelve decades in steps of a third of one: the error is flat around its minimum
  for (int step = 0; step <= 36; ++step) {
    const double ridge = greatest * std::pow(10.0, -step / 3.0);
    const double error = root_mean_square(leave_one_out(s, ridge));
    if (error < least_error) {
      least_error = error;
      best = ridge;
    }
  }
  return best;
}

Eigen::VectorXd choose_scale(const Eigen::MatrixXd& designs, const Eigen::VectorXd& values) {
  const Eigen::Index n = std::min<Eigen::Index>(400, designs.rows());
  const Eigen::MatrixXd some = designs.topRows(n);
  const Eigen::VectorXd theirs = values.head(n);
  const auto error_of = [&](const Eigen::VectorXd& scale) {
    const Spectrum s = diagonalise(some, theirs, scale);
    return root_mean_square(leave_one_out(s, best_ridge(s)));
  };
  Eigen::VectorXd scale = Eigen::VectorXd::Ones(designs.cols());
  double least = error_of(scale);
  for (int turn = 0; turn < 2; ++turn) {
    for (Eigen::Index j = 0; j < scale.size(); ++j) {
      const double old = scale[j];
      double best = old;
      for (const double factor : {0.25, 0.5, 2.0, 4.0}) {
        scale[j] = old * factor;
        const double error = error_of(scale);
        if (error < least) {
          least = error;
          best = scale[j];
        }
      }
      scale[j] = best;
    }
  }
  return scale;
}

}  // namespace

double RadialSurface::at(const Eigen::MatrixXd& designs, const Eigen::VectorXd& u) const {
  double sum = tail[0] + tail.tail(u.size()).dot(u);
  for (Eigen::Index i = 0; i < designs.rows(); ++i) {
    if (weights[i] == 0.0) continue;
    double square = 0.0;
    for (Eigen::Index j = 0; j < u.size(); ++j) {
      const double difference = (u[j] - designs(i, j)) * scale[j];
      square += difference * difference;
    }
    sum += weights[i] * square * std::sqrt(square);
  }
  return sum;
}

RadialFit fit_radial(const Eigen::MatrixXd& designs, const Eigen::VectorXd& values) {
  if (designs.rows() <= designs.cols() + 2) {
    throw std::invalid_argument("a surface in " + std::to_string(designs.cols()) +
                                " variables needs more than " + std::to_string(designs.cols() + 2) +
                                " designs, not " + std::to_string(designs.rows()));
  }
  return fit_radial(designs, values, choose_scale(designs, values));
}

RadialFit fit_radial(const Eigen::MatrixXd& designs, const Eigen::VectorXd& values,
                     const Eigen::VectorXd& scale, std::optional<double> ridge) {
  const Spectrum s = diagonalise(designs, values, scale);
  RadialFit fit;
  fit.ridge = ridge ? *ridge : best_ridge(s);
  fit.leave_one_out = leave_one_out(s, fit.ridge);
  fit.leave_one_out_rms = root_mean_square(fit.leave_one_out);
  const Eigen::VectorXd inverse = (s.eigenvalues.array() + fit.ridge).inverse();
  fit.surface.scale = scale;
  fit.surface.weights = s.vectors * s.projected.cwiseProduct(inverse);
  const Eigen::VectorXd rest =
      values - s.kernel * fit.surface.weights - fit.ridge * fit.surface.weights;
  fit.surface.tail = s.terms.householderQr().solve(rest);
  // residuals are ridge w, and I - H is ridge times the inverse's block
  fit.noise = fit.ridge * fit.surface.weights.norm() / std::sqrt(fit.ridge * inverse.sum());
  const double variance = (values.array() - values.mean()).square().mean();
  fit.q_squared =
      variance > 0.0 ? 1.0 - fit.leave_one_out_rms * fit.leave_one_out_rms / variance : 1.0;
  return fit;
}

}  // namespace parapet::bench::search
