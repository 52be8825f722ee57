/// How the acquisition sees an objective: in the metric's own unit, scaled, to be minimised.
#pragma once

#include <cstddef>

#include "models.hpp"

namespace parapet::bayesian {

/// The hypervolume of several objectives is measured in their units; so is what a design is
/// expected to add. The surrogate may work on a logarithm: its draws are brought back before they
/// are compared. One objective alone is left in model units: its order is the same there, and a
/// logarithm goes on promising something where the digits are small.
struct ObjectiveView {
  std::size_t metric = 0;
  double sign = 1.0;  ///< -1 for what is maximised
  double shift = 0.0, scale = 1.0;
  double least = 0.0, greatest = 0.0;  ///< values beyond are as good as these (the metric's unit)
  const surrogate::GaussianProcess* process = nullptr;  ///< null: exact or composed

  bool in_model_units = false;

  double to_view(double value) const;

  /// Of a composed metric's value; what has none is as bad as can be.
  double of_composed(double value) const;

  /// Of a value in model units.
  double from_model(double z) const;

  /// Standard deviation in view units of a value N(z, deviation^2) in model units, on the side
  /// where it improves: the distance between the median and the quantile one deviation better. The
  /// improvement comes from there; for small deviations, and without a transform, it is the
  /// standard deviation.
  double deviation(double z, double deviation) const;
};

/// The view of objective `j`. Scaled by the spread of the values told.
ObjectiveView view_of(const Problem& problem, const Models& models, const std::vector<Told>& told,
                      std::size_t j);

}  // namespace parapet::bayesian
