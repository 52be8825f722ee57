/// The standard normal distribution.
#pragma once

namespace parapet::surrogate {

/// Phi(t).
double normal_cdf(double t);

/// log Phi(t), accurate in the far lower tail.
double log_normal_cdf(double t);

/// phi(t) / Phi(t), the inverse Mills ratio of -t; accurate in the far lower tail.
double normal_hazard(double t);

/// t with Phi(t) = p, 0 < p < 1: algorithm AS 241, routine PPND16 (Wichura, Appl. Stat. 37 (1988)
/// 477-484), relative error about 1e-16.
double normal_quantile(double p);

}  // namespace parapet::surrogate
