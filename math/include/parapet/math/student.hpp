/// Student's t distribution.
#pragma once

namespace parapet::math {

/// P(T <= t) with so many degrees of freedom, which need not be whole: the regularised incomplete
/// beta function by its continued fraction (Abramowitz and Stegun, 26.5.8 and 26.7.1).
/// @param freedom > 0; infinity gives the normal distribution
double student_cdf(double t, double freedom);

/// t with P(T <= t) = p.
/// @param p 0 < p < 1
double student_quantile(double p, double freedom);

}  // namespace parapet::math
