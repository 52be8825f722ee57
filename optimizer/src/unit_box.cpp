#include "unit_box.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parapet::optimizer {
namespace {

double on_grid(double u) {
  if (!(u > 0.0)) return 0.0;  // a NaN too
  if (u >= 1.0) return 1.0;
  return std::nearbyint(u * 0x1p40) * 0x1p-40;
}

}  // namespace

UnitBox::UnitBox(std::vector<double> lower, std::vector<double> upper)
    : lower_(std::move(lower)), upper_(std::move(upper)) {}

void UnitBox::remember(const std::vector<double>& x) {
  remembered_.try_emplace(to_unit(x), x);
}

std::vector<double> UnitBox::to_unit(const std::vector<double>& x) const {
  std::vector<double> u(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    u[i] = on_grid((x[i] - lower_[i]) / (upper_[i] - lower_[i]));
  }
  return u;
}

std::vector<double> UnitBox::from_unit(const std::vector<double>& u) const {
  std::vector<double> grid(u.size());
  std::transform(u.begin(), u.end(), grid.begin(), on_grid);
  if (const auto found = remembered_.find(grid); found != remembered_.end()) return found->second;
  std::vector<double> x(u.size());
  for (std::size_t i = 0; i < u.size(); ++i) {
    const double inner = lower_[i] + grid[i] * (upper_[i] - lower_[i]);
    x[i] = grid[i] >= 1.0 ? upper_[i] : std::clamp(inner, lower_[i], upper_[i]);
    x[i] += 0.0;  // -0 and +0 are one design
  }
  return x;
}

}  // namespace parapet::optimizer
