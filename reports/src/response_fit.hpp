/// What the evaluated designs say about each variable: a least-squares response of one metric.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace parapet::reports {

enum class ResponseModel {
  none,             ///< too few points, or none of the models can be told from the data
  linear,           ///< 1, x_i
  curved,           ///< and x_i^2
  with_interaction  ///< and x_i x_j
};

/// The effect of one variable, over the span in which it was tried.
struct VariableEffect {
  double tried_from = 0.0, tried_to = 0.0;
  std::optional<double> change;  ///< of the response from one end of the span to the other,
                                 ///< the other variables in the middle of theirs
  double standard_error = 0.0;   ///< of that change
  double standardised = 0.0;     ///< in standard deviations of the response per one of the
                                 ///< variable
  double bend = 0.0;             ///< coefficient of the square: end minus middle
  bool change_clear = false;     ///< beyond its 95 % interval
  bool bend_clear = false;
  std::optional<double> correlation;  ///< Pearson's, with this variable alone
};

struct ResponseFit {
  ResponseModel model = ResponseModel::none;
  std::string why_none;  ///< in words, when there is no model
  int points = 0;
  double r2 = 0.0;                      ///< share of the variance that the model explains
  double r2_left_out = 0.0;             ///< the same for points left out of the fit one at a time
  double scatter = 0.0;                 ///< standard deviation of the residuals
  std::vector<VariableEffect> effects;  ///< [n_variables]
};

/// Fits the model that best predicts points left out of it, among those with at least three points
/// more than coefficients.
/// @param x [n_points][n_variables]
/// @param y [n_points], finite
ResponseFit fit_response(const std::vector<std::vector<double>>& x, const std::vector<double>& y);

std::string to_string(ResponseModel model);

}  // namespace parapet::reports
