#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "parapet/solver/uncertainty.hpp"

namespace parapet::solver {
namespace {

struct Fit {
  double limit = 0.0, slope = 0.0, order = 0.0;
  double deviation = 0.0;  // standard deviation of the residuals
  double residual = 0.0;   // sum of their squares

  double operator()(double h) const { return limit + slope * std::pow(h, order); }
};

// Least squares of phi = limit + slope h^order for a given order; parameters counts what is fitted.
Fit fit_order(std::span<const double> h, std::span<const double> phi, double order,
              int parameters) {
  const auto n = static_cast<double>(h.size());
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (std::size_t k = 0; k < h.size(); ++k) {
    const double x = std::pow(h[k], order);
    sx += x;
    sy += phi[k];
    sxx += x * x;
    sxy += x * phi[k];
  }
  Fit fit;
  fit.order = order;
  fit.slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
  fit.limit = (sy - fit.slope * sx) / n;
  for (std::size_t k = 0; k < h.size(); ++k) {
    fit.residual += (phi[k] - fit(h[k])) * (phi[k] - fit(h[k]));
  }
  const double freedom = n - parameters;
  fit.deviation = freedom > 0.0 ? std::sqrt(fit.residual / freedom) : 0.0;
  return fit;
}

// The order that fits best, by scanning.
Fit fit_best(std::span<const double> h, std::span<const double> phi) {
  constexpr double least = 0.05, most = 6.0, step = 0.01;
  Fit best;
  best.residual = std::numeric_limits<double>::infinity();
  for (double order = least; order <= most; order += step) {
    const Fit fit = fit_order(h, phi, order, 3);
    if (fit.residual < best.residual) best = fit;
  }
  return best;
}

}  // namespace

DiscretisationError discretisation_error(std::span<const double> spacings,
                                         std::span<const double> values) {
  if (spacings.size() < 3 || spacings.size() != values.size()) {
    throw std::invalid_argument(
        "a discretisation error needs at least three spacings, and a value "
        "for each");
  }
  std::vector<double> h;  // relative, so that powers stay near 1
  for (const double spacing : spacings) h.push_back(spacing / spacings.front());
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double range = (*high - *low) / static_cast<double>(values.size() - 1);
  DiscretisationError error;
  error.extrapolated = values.front();
  error.order = 1.0;
  if (range == 0.0) return error;

  bool rises = true, falls = true;
  for (std::size_t k = 1; k < values.size(); ++k) {
    rises = rises && values[k] >= values[k - 1];
    falls = falls && values[k] <= values[k - 1];
  }
  Fit fit = fit_best(h, values);
  error.order_observed = (rises || falls) && fit.order >= 0.5 && fit.order <= 2.1;
  if (!error.order_observed) {
    // the better of first and second order, as Eca and Hoekstra do
    const Fit first = fit_order(h, values, 1.0, 2), second = fit_order(h, values, 2.0, 2);
    fit = first.residual <= second.residual ? first : second;
  }
  error.extrapolated = fit.limit;
  error.order = fit.order;
  error.coefficient = fit.slope;
  error.deviation = fit.deviation;
  const double safety = error.order_observed && fit.deviation < range ? 1.25 : 3.0;
  error.uncertainty = safety * std::abs(values.front() - fit.limit) + fit.deviation +
                      std::abs(values.front() - fit(h.front()));
  return error;
}

}  // namespace parapet::solver
