#include "parapet/reports/plot_axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace parapet::reports {

Ticks nice_ticks(double lower, double upper, int wanted) {
  const double raw = (upper - lower) / std::max(wanted, 1);
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  const double mantissa = raw / power;
  Ticks ticks;
  // Thresholds are the geometric means of neighbouring steps.
  ticks.step = power * (mantissa < 1.414   ? 1.0
                        : mantissa < 3.162 ? 2.0
                        : mantissa < 7.071 ? 5.0
                                           : 10.0);
  const int exponent = static_cast<int>(std::floor(std::log10(ticks.step) + 1e-9));
  const double largest = std::max(std::abs(lower), std::abs(upper));
  const int magnitude = static_cast<int>(std::floor(std::log10(largest) + 1e-9));
  const bool scientific = exponent < -4 || magnitude >= 6;
  const int decimals = std::max(0, scientific ? magnitude - exponent : -exponent);
  const double slack = 1e-9 * ticks.step;
  const auto first = static_cast<long long>(std::ceil((lower - slack) / ticks.step));
  const auto last = static_cast<long long>(std::floor((upper + slack) / ticks.step));
  for (long long k = first; k <= last; ++k) {
    const double value = static_cast<double>(k) * ticks.step;
    ticks.values.push_back(value);
    std::string label =
        scientific && value != 0.0
            ? fmt::format("{:.{}f}e{}", value / std::pow(10.0, magnitude), decimals, magnitude)
            : fmt::format("{:.{}f}", value, scientific ? 0 : decimals);
    if (label.front() == '-') label.replace(0, 1, "\u2212");
    ticks.labels.push_back(std::move(label));
  }
  return ticks;
}

double round_up(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double mantissa : {1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0}) {
    if (mantissa * power >= value * (1.0 - 1e-9)) return mantissa * power;
  }
  return 10.0 * power;
}

}  // namespace parapet::reports
