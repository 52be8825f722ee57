/// The search happens in the unit box, so that steps and tolerances are shares of each range.
#pragma once

#include <map>
#include <vector>

namespace parapet::optimizer {

/// x = lower + u (upper - lower), with u rounded to multiples of 2^-40. The rounding makes a point
/// that an algorithm rebuilds with an error of a few ulp the same point, to the bit: its
/// evaluation is then found in the cache. 2^-40 of a range is far below any sensible tolerance.
class UnitBox {
 public:
  UnitBox(std::vector<double> lower, std::vector<double> upper);

  /// Makes from_unit(to_unit(x)) return exactly x (the first one where two round to the same u).
  void remember(const std::vector<double>& x);

  /// u [n] on the grid; x outside the bounds is clipped.
  std::vector<double> to_unit(const std::vector<double>& x) const;

  /// x [n], never outside the bounds; exactly lower at u <= 0 and upper at u >= 1.
  std::vector<double> from_unit(const std::vector<double>& u) const;

 private:
  std::vector<double> lower_, upper_;
  std::map<std::vector<double>, std::vector<double>> remembered_;  // u on the grid -> x
};

}  // namespace parapet::optimizer
