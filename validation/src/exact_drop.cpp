#include "exact_drop.hpp"

#include <cmath>
#include <numbers>

namespace parapet::validation::exact_drop {
namespace {

// Semi-axes of the exact drop.
struct Ellipse {
  double a = radius, b = radius, s = rate;
};

Ellipse slope(const Ellipse& e) {
  const double a2 = e.a * e.a, b2 = e.b * e.b;
  return {e.s * e.a, -e.s * e.b, (e.s * e.s + rate * rate) * (b2 - a2) / (a2 + b2)};
}

// A step of fourth-order Runge-Kutta.
Ellipse stepped(const Ellipse& e, double dt) {
  const auto moved = [&](const Ellipse& k, double by) {
    return Ellipse{e.a + by * k.a, e.b + by * k.b, e.s + by * k.s};
  };
  const Ellipse k1 = slope(e), k2 = slope(moved(k1, 0.5 * dt)), k3 = slope(moved(k2, 0.5 * dt)),
                k4 = slope(moved(k3, dt));
  const auto mean = [](double p, double q, double r, double t) {
    return (p + 2.0 * q + 2.0 * r + t) / 6.0;
  };
  return {e.a + dt * mean(k1.a, k2.a, k3.a, k4.a), e.b + dt * mean(k1.b, k2.b, k3.b, k4.b),
          e.s + dt * mean(k1.s, k2.s, k3.s, k4.s)};
}

constexpr double exact_step = 1e-3;  // [s]

}  // namespace

// Energy, (s^2 + A^2)(a^2 + b^2) = 4 A^2 R^2, leaves a^2 + b^2 = 4 R^2 where s = 0: then
// a^2 = (2 + sqrt 3) R^2 and ln(a/b) has its extreme.
double largest_elongation() {
  return std::log(2.0 + std::numbers::sqrt3);
}

double elongation(double time) {
  Ellipse e;
  const auto steps = static_cast<int>(std::ceil(time / exact_step));
  for (int k = 0; k < steps; ++k) e = stepped(e, time / steps);
  return std::log(e.a / e.b);
}

std::vector<double> passages(const std::vector<double>& time, const std::vector<double>& value) {
  std::vector<double> found;
  for (std::size_t k = 2; k < time.size(); ++k) {
    if (value[k - 1] * value[k] > 0.0) continue;
    found.push_back(time[k - 1] +
                    (time[k] - time[k - 1]) * value[k - 1] / (value[k - 1] - value[k]));
  }
  return found;
}

double friction_scale(double period) {
  double sum = 0.0;
  Ellipse e;
  const auto steps = static_cast<int>(std::ceil(period / exact_step));
  const double dt = period / steps;
  for (int k = 0; k < steps; ++k) {
    const double c = 2.0 * (e.s * e.s + rate * rate) / (1.0 / (e.a * e.a) + 1.0 / (e.b * e.b));
    // the pressure's mean over the ellipse is rho C/4
    sum += dt * 0.25 * density * c * 2.0 * std::abs(e.s);
    e = stepped(e, dt);
  }
  return sum * std::numbers::pi * radius * radius;
}

double period() {
  std::vector<double> time, value;
  Ellipse e;
  for (int k = 0; k < 6000; ++k) {
    time.push_back(k * exact_step);
    value.push_back(std::log(e.a / e.b));
    e = stepped(e, exact_step);
  }
  const std::vector<double> found = passages(time, value);
  return 2.0 * found.front();  // from the disc through the ellipse to the disc is half a period
}

}  // namespace parapet::validation::exact_drop
