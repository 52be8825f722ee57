#include "response_fit.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "parapet/math/student.hpp"

namespace parapet::reports {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int spare_points = 3;

// A point that the fit follows this closely was not predicted by the others: the model has no right
// to a judgement of itself.
constexpr double most_leverage = 0.95;

/// Columns 1, x_i, then x_i^2, then x_i x_j, as far as the model has them.
MatrixXd design_matrix(const MatrixXd& x, ResponseModel model) {
  const Index n = x.rows(), d = x.cols();
  const bool curved = model != ResponseModel::linear;
  const bool mixed = model == ResponseModel::with_interaction;
  MatrixXd a(n, 1 + d + (curved ? d : 0) + (mixed ? d * (d - 1) / 2 : 0));
  a.col(0).setOnes();
  a.middleCols(1, d) = x;
  if (curved) a.middleCols(1 + d, d) = x.array().square().matrix();
  if (!mixed) return a;
  Index column = 1 + 2 * d;
  for (Index i = 0; i < d; ++i) {
    for (Index j = i + 1; j < d; ++j) a.col(column++) = x.col(i).cwiseProduct(x.col(j));
  }
  return a;
}

struct Fit {
  VectorXd coefficients, errors;  // [terms]
  double r2 = 0.0, r2_left_out = 0.0, scatter = 0.0;
  Index freedom = 0;
};

std::optional<Fit> least_squares(const MatrixXd& a, const VectorXd& y) {
  const Index n = a.rows(), terms = a.cols();
  if (n < terms + spare_points) return std::nullopt;
  Eigen::ColPivHouseholderQR<MatrixXd> qr(a);
  qr.setThreshold(1e-7);
  if (qr.rank() < terms) return std::nullopt;
  Fit fit;
  fit.coefficients = qr.solve(y);
  const VectorXd residuals = y - a * fit.coefficients;
  const MatrixXd inverse = (a.transpose() * a).inverse();
  const double variance_sum = (y.array() - y.mean()).square().sum();
  fit.freedom = n - terms;
  fit.scatter = std::sqrt(residuals.squaredNorm() / static_cast<double>(fit.freedom));
  fit.errors = fit.scatter * inverse.diagonal().cwiseMax(0.0).cwiseSqrt();
  fit.r2 = 1.0 - residuals.squaredNorm() / variance_sum;
  double left_out = 0.0;  // sum of squares of the errors at points left out of the fit
  for (Index k = 0; k < n; ++k) {
    const double leverage = a.row(k) * inverse * a.row(k).transpose();
    if (leverage > most_leverage) return std::nullopt;
    const double error = residuals(k) / (1.0 - leverage);
    left_out += error * error;
  }
  fit.r2_left_out = 1.0 - left_out / variance_sum;
  if (!fit.coefficients.allFinite() || !fit.errors.allFinite()) return std::nullopt;
  return fit;
}

double pearson(const VectorXd& a, const VectorXd& b) {
  const VectorXd u = a.array() - a.mean();
  const VectorXd v = b.array() - b.mean();
  return u.dot(v) / (u.norm() * v.norm());
}

double deviation(const VectorXd& a) {
  return std::sqrt((a.array() - a.mean()).square().sum() / static_cast<double>(a.size() - 1));
}

/// Effects of the fitted coefficients; `varied` maps the model's columns to variables.
void read_effects(const Fit& fit, ResponseModel model, const MatrixXd& scaled,
                  const std::vector<std::size_t>& varied, double y_deviation, ResponseFit& out) {
  const double quantile = math::student_quantile(0.975, static_cast<double>(fit.freedom));
  const Index d = scaled.cols();
  for (Index k = 0; k < d; ++k) {
    VariableEffect& effect = out.effects[varied[static_cast<std::size_t>(k)]];
    const double slope = fit.coefficients(1 + k);
    effect.change = 2.0 * slope;
    effect.standard_error = 2.0 * fit.errors(1 + k);
    effect.standardised = slope * deviation(scaled.col(k)) / y_deviation;
    effect.change_clear = std::abs(*effect.change) > quantile * effect.standard_error;
    if (model == ResponseModel::linear) continue;
    effect.bend = fit.coefficients(1 + d + k);
    effect.bend_clear = std::abs(effect.bend) > quantile * fit.errors(1 + d + k);
  }
}

/// Each varied variable on -1..1 over the span in which it was tried.
MatrixXd scaled_variables(const MatrixXd& x, ResponseFit& out, std::vector<std::size_t>& varied) {
  MatrixXd scaled(x.rows(), 0);
  for (Index k = 0; k < x.cols(); ++k) {
    const double from = x.col(k).minCoeff(), to = x.col(k).maxCoeff();
    out.effects[static_cast<std::size_t>(k)].tried_from = from;
    out.effects[static_cast<std::size_t>(k)].tried_to = to;
    if (to - from <= 1e-9 * std::max(std::abs(from), std::abs(to))) continue;
    varied.push_back(static_cast<std::size_t>(k));
    scaled.conservativeResize(Eigen::NoChange, scaled.cols() + 1);
    scaled.col(scaled.cols() - 1) = (2.0 * x.col(k).array() - from - to) / (to - from);
  }
  return scaled;
}

}  // namespace

std::string to_string(ResponseModel model) {
  switch (model) {
    case ResponseModel::linear:
      return "linear";
    case ResponseModel::curved:
      return "quadratic without interactions";
    case ResponseModel::with_interaction:
      return "full quadratic";
    case ResponseModel::none:
      break;
  }
  return "none";
}

ResponseFit fit_response(const std::vector<std::vector<double>>& x, const std::vector<double>& y) {
  ResponseFit out;
  out.points = static_cast<int>(y.size());
  if (y.empty()) {
    out.why_none = "no design has a value";
    return out;
  }
  const auto n = static_cast<Index>(y.size());
  const auto d = static_cast<Index>(x.front().size());
  out.effects.resize(x.front().size());
  MatrixXd raw(n, d);
  for (Index i = 0; i < n; ++i) {
    const std::vector<double>& row = x[static_cast<std::size_t>(i)];
    raw.row(i) = Eigen::Map<const Eigen::RowVectorXd>(row.data(), d);
  }
  const VectorXd response = Eigen::Map<const VectorXd>(y.data(), n);
  std::vector<std::size_t> varied;
  const MatrixXd scaled = scaled_variables(raw, out, varied);
  const double y_deviation = n > 1 ? deviation(response) : 0.0;
  if (varied.empty() || y_deviation <= 1e-12 * response.cwiseAbs().maxCoeff()) {
    out.why_none = n < 2            ? "only one design has a value"
                   : varied.empty() ? "no variable was varied"
                                    : "its value never changed";
    return out;
  }
  for (std::size_t k = 0; k < varied.size() && n >= 4; ++k) {
    out.effects[varied[k]].correlation = pearson(scaled.col(static_cast<Index>(k)), response);
  }
  std::optional<Fit> best;
  for (const ResponseModel model :
       {ResponseModel::linear, ResponseModel::curved, ResponseModel::with_interaction}) {
    const std::optional<Fit> fit = least_squares(design_matrix(scaled, model), response);
    if (!fit || (best && fit->r2_left_out <= best->r2_left_out + 1e-9)) continue;
    best = fit;
    out.model = model;
  }
  if (!best) {
    out.why_none = fmt::format(
        "{} designs are too few, or too alike, for {} variables (at least {} are needed)", n,
        varied.size(), varied.size() + 1 + spare_points);
    return out;
  }
  out.r2 = best->r2;
  out.r2_left_out = best->r2_left_out;
  out.scatter = best->scatter;
  read_effects(*best, out.model, scaled, varied, y_deviation, out);
  return out;
}

}  // namespace parapet::reports
