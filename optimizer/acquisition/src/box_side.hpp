/// One factor of a box's share in the expected hypervolume improvement.
#pragma once

#include <limits>

namespace parapet::acquisition {

/// log(E[(upper - y)+] - E[(lower - y)+]) of y ~ N(mean, sd^2), lower < upper: the expected length
/// of [lower, upper] that lies above y. lower may be -infinity.
double log_box_side(double lower, double upper, double mean, double sd);

/// Adds terms given as logarithms; the greatest so far is kept apart, so nothing overflows.
class LogAdder {
 public:
  void add(double log_term);
  double greatest() const { return greatest_; }
  double total() const;  ///< -infinity without terms

 private:
  double greatest_ = -std::numeric_limits<double>::infinity();
  double sum_ = 0.0;  // of exp(term - greatest_)
};

}  // namespace parapet::acquisition
