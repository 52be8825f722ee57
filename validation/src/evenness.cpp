#include "evenness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "parapet/flow/kernel.hpp"

namespace parapet::validation {

using solver::Fluid;

Evenness evenness(const solver::Flow& flow) {
  const Fluid& f = flow.fluid();
  const double dx = flow.setup().numerics.spacing, h = flow.smoothing_length();
  const solver::Kernel kernel = solver::make_kernel(h, dx);
  const auto n = static_cast<std::size_t>(f.n);
  // along z sorted, so that only the particles of a band are compared
  std::vector<std::size_t> order(n);
  for (std::size_t i = 0; i < n; ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return f.z[a] < f.z[b]; });
  std::vector<double> unity(n, 0.0), places(n, 0.0);
  double closest2 = std::numeric_limits<double>::infinity();
  const double period = flow.setup().periodic_length;
  for (std::size_t a = 0; a < n; ++a) {
    const std::size_t i = order[a];
    unity[i] += kernel.alpha * f.volume[i];
    places[i] += kernel.alpha * dx * dx;
    for (std::size_t b = a + 1; b < n && f.z[order[b]] - f.z[i] < 2.0 * h; ++b) {
      const std::size_t j = order[b];
      double rx = f.x[j] - f.x[i];
      if (period > 0.0) rx -= period * std::round(rx / period);
      const double rz = f.z[j] - f.z[i], r2 = rx * rx + rz * rz;
      if (r2 >= 4.0 * h * h) continue;
      closest2 = std::min(closest2, r2);
      const double w = kernel.alpha * solver::kernel_shape(std::sqrt(r2) / h);
      unity[i] += w * f.volume[j];
      unity[j] += w * f.volume[i];
      places[i] += w * dx * dx;
      places[j] += w * dx * dx;
    }
  }
  const double lowest = f.z[order.front()] + 2.0 * h, highest = f.z[order.back()] - 2.0 * h;
  const auto deviation = [&](const std::vector<double>& sums) {
    double sum = 0.0, square = 0.0, count = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      if (f.z[i] < lowest || f.z[i] > highest) continue;
      sum += sums[i];
      square += sums[i] * sums[i];
      count += 1.0;
    }
    const double mean = sum / count;
    return std::sqrt(std::max(square / count - mean * mean, 0.0));
  };
  return {std::sqrt(closest2) / dx, deviation(unity), deviation(places)};
}

}  // namespace parapet::validation
