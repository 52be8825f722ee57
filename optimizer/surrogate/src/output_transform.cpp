#include "parapet/surrogate/output_transform.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace parapet::surrogate {
namespace {

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Median distance from the median: a spread that few far values do not move. Where most values are
/// equal it is 0, and the largest distance stands in; 1 where all are equal.
double spread(const Eigen::VectorXd& values) {
  const double centre = median({values.begin(), values.end()});
  std::vector<double> distance;
  for (const double value : values) distance.push_back(std::abs(value - centre));
  const double typical = median(distance);
  if (typical > 0.0) return typical;
  const double largest = *std::max_element(distance.begin(), distance.end());
  return largest > 0.0 ? largest : 1.0;
}

double raw(const OutputTransform& transform, double value) {
  switch (transform.kind) {
    case TransformKind::log:
      // Values that the data do not have (0, negative) map to the least there is.
      return std::log(std::max(value, 1e-300));
    case TransformKind::bilog:
      return std::copysign(std::log1p(std::abs(value) / transform.unit), value);
    default:
      return value;
  }
}

}  // namespace

double OutputTransform::to_model(double value) const {
  return (raw(*this, value) - shift) / scale;
}

double OutputTransform::from_model(double z) const {
  const double t = shift + scale * z;
  switch (kind) {
    case TransformKind::log:
      return std::exp(t);
    case TransformKind::bilog:
      return std::copysign(unit * std::expm1(std::abs(t)), t);
    default:
      return t;
  }
}

double OutputTransform::log_slope(double value) const {
  switch (kind) {
    case TransformKind::log:
      return -std::log(std::max(value, 1e-300)) - std::log(scale);
    case TransformKind::bilog:
      return -std::log(unit) - std::log1p(std::abs(value) / unit) - std::log(scale);
    default:
      return -std::log(scale);
  }
}

OutputTransform OutputTransform::standardizing(TransformKind kind, const Eigen::VectorXd& values) {
  OutputTransform transform;
  transform.kind = kind == TransformKind::automatic ? TransformKind::identity : kind;
  if (values.size() == 0) return transform;
  if (kind == TransformKind::log && values.minCoeff() <= 0.0) {
    transform.kind = TransformKind::identity;
  }
  if (kind == TransformKind::bilog) transform.unit = spread(values);
  const Eigen::ArrayXd t = values.unaryExpr([&](double y) { return raw(transform, y); }).array();
  const double largest = std::max(t.abs().maxCoeff(), 1e-300);
  // Divided by the largest, so that squares neither overflow nor vanish.
  const double mean = (t / largest).mean();
  const double deviation = std::sqrt((t / largest - mean).square().mean());
  transform.shift = mean * largest;
  // A deviation of a few units in the last place is rounding, not spread.
  const double scale = deviation * largest;
  if (deviation > 1e-13 && std::isnormal(scale)) transform.scale = scale;
  return transform;
}

}  // namespace parapet::surrogate
