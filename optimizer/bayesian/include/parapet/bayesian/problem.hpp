/// What a Bayesian search is asked. Knows nothing of barriers or particles.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "parapet/bayesian/space.hpp"

namespace parapet::bayesian {

/// How a metric follows from others that have surrogates: the surrogates model those, not it.
struct Composition {
  std::vector<std::size_t> inputs = {};  ///< metrics of the problem, neither exact nor composed
  /// Of a design and the values of the inputs [n_inputs]; not finite where it has no value.
  std::function<double(const Point& x, const std::vector<double>& values)> value = {};
};

/// One number that an evaluation gives.
struct Metric {
  std::string name;
  surrogate::TransformKind transform = surrogate::TransformKind::automatic;
  std::vector<double> known_noise = {};  ///< [n_levels] s.d. of an observation; empty: estimated
  /// A metric that needs no evaluation (a formula of the design): known exactly at every design.
  std::function<double(const Point& x)> exact = {};
  /// Values beyond these are impossible (a share is at most 1).
  double least = -std::numeric_limits<double>::infinity();
  double greatest = std::numeric_limits<double>::infinity();
  /// A formula of other metrics: has no value where one of them has none.
  Composition composition = {};

  bool is_composed() const { return static_cast<bool>(composition.value); }  ///< of other metrics
};

/// A metric that is to be as small, or as large, as possible.
struct Objective {
  std::size_t metric = 0;
  bool maximize = false;
  /// In the metric's unit; chosen from the first designs if empty.
  std::optional<double> reference = {};
};

/// lower <= metric <= upper.
struct Limit {
  std::size_t metric = 0;
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool satisfied_when_absent = true;
};

/// A level of fidelity: 0 is the finest, the one that counts.
struct Level {
  double seconds = 1.0;  ///< guess of an evaluation's cost; replaced by what is measured
};

/// The question: a space of designs, what an evaluation answers, and what is wanted of it.
struct Problem {
  Space space{{}};
  std::vector<Metric> metrics;
  std::vector<Objective> objectives;  ///< at least one
  std::vector<Limit> limits;
  std::vector<Level> levels{Level{}};
  /// c [n_cheap] <= 0 allows a design; needs no evaluation. May be empty.
  std::function<std::vector<double>(const Point& x)> cheap_constraints;
};

/// An answer. `values` [n_metrics]: empty where the metric has no value at this design (nothing
/// overflowed, so nothing landed), is exact or is composed.
struct Observation {
  bool ok = false;
  std::vector<std::optional<double>> values = {};
  double seconds = 0.0;  ///< what it cost
};

}  // namespace parapet::bayesian
