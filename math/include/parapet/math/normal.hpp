/// The standard normal distribution.
#pragma once

namespace parapet::math {

/// Phi(t).
double normal_cdf(double t);

/// log phi(t).
double log_normal_density(double t);

/// Mills' ratio (1 - Phi(t)) / phi(t) of t >= 0.
double mills_ratio(double t);

/// log Phi(t), accurate in the far lower tail.
double log_normal_cdf(double t);

/// phi(t) / Phi(t), the inverse Mills ratio of -t; accurate in the far lower tail.
double normal_hazard(double t);

/// t with Phi(t) = p, 0 < p < 1: algorithm AS 241, routine PPND16 (Wichura, Appl. Stat. 37 (1988)
/// 477-484), relative error about 1e-16.
double normal_quantile(double p);

}  // namespace parapet::math
