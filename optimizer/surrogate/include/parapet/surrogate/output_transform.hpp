/// Monotone transforms that make an output look more like a Gaussian process.
#pragma once

#include <Eigen/Core>

namespace parapet::surrogate {

/// Which function t is applied to an output.
enum class TransformKind {
  automatic,  ///< chosen by the likelihood, Jacobian included
  identity,
  log,    ///< log(y), for positive outputs over decades
  bilog,  ///< sign(y) log(1 + |y|), y in units of the spread
};

/// z = (t(y) - shift) / scale, increasing. `unit` divides y before bilog.
struct OutputTransform {
  TransformKind kind = TransformKind::identity;  ///< never automatic
  double unit = 1.0;
  double shift = 0.0;
  double scale = 1.0;

  double to_model(double value) const;   ///< z of y
  double from_model(double z) const;     ///< y of z
  double log_slope(double value) const;  ///< log dz/dy

  /// The transform of this kind that gives `values` [n] mean 0 and s.d. 1 (scale 1 where they are
  /// all equal). log falls back to identity when a value is not positive.
  static OutputTransform standardizing(TransformKind kind, const Eigen::VectorXd& values);
};

}  // namespace parapet::surrogate
