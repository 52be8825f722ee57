/// What a repeat of a built design would give: one number with the doubt of one more run.
#pragma once

#include <limits>
#include <optional>
#include <vector>

namespace parapet::study {

/// What a surrogate says of a quantity at one design, in the quantity's unit. The runs that taught
/// it are in it; runs made later are not.
struct SurrogateBelief {
  double mean = 0.0;           ///< median of the noise-free value
  double deviation = 0.0;      ///< s.d. of the noise-free value
  double noise = 0.0;          ///< s.d. of a run about it
  double noise_freedom = 2.0;  ///< degrees of freedom of that s.d.
  /// Root mean square of the difference between this spacing and the next coarser one, at this
  /// design or over the study's runs at this spacing, whichever is more: where it passes through 0
  /// nothing has converged. Empty: the study has no coarser spacing.
  std::optional<double> grid = {};
};

/// What is known of one quantity at one design.
struct RepeatEvidence {
  std::optional<SurrogateBelief> surrogate = {};
  std::optional<double> own = {};    ///< of the study's own run: the surrogate has seen it
  std::vector<double> again = {};    ///< of runs made since at the same spacing
  std::optional<double> finer = {};  ///< of a run at another spacing, a finer one if there is one
  /// The values that the quantity can have at all.
  double least = -std::numeric_limits<double>::infinity();
  double greatest = std::numeric_limits<double>::infinity();
};

/// Where a grid uncertainty comes from.
enum class GridSource {
  none,      ///< it is not known
  levels,    ///< the surrogate of the study's spacings
  other_run  ///< the design simulated at another spacing
};

/// What one more run of the design would give, scattered as Student's t about the mean and limited
/// to the possible values: what lies beyond them counts at the limit.
struct RepeatEstimate {
  double mean = 0.0;
  int runs = 0;                   ///< of the design and those near it that went into it
  std::optional<double> scatter;  ///< s.d. of a run about the mean; empty: not known
  double mean_uncertainty = 0.0;  ///< standard uncertainty of the mean
  std::optional<double> grid;     ///< standard uncertainty of the spacing; empty: not known
  GridSource grid_source = GridSource::none;
  double freedom = std::numeric_limits<double>::infinity();  ///< of the standard uncertainty
  double least = -std::numeric_limits<double>::infinity();
  double greatest = std::numeric_limits<double>::infinity();

  /// Root of the sum of squares of scatter, mean's and grid's; empty without a scatter.
  std::optional<double> standard_uncertainty() const;
  /// The ends of the 95 % interval, never impossible values; empty without a scatter.
  std::optional<double> lower_95() const;
  std::optional<double> upper_95() const;  ///< likewise
  /// Probability that one more run lies within; empty without a scatter.
  std::optional<double> probability_within(const std::optional<double>& lower,
                                           const std::optional<double>& upper) const;
};

/// The estimate from all that is known; empty without a surrogate and without a run.
///
/// Scatter: the surrogate's noise and the squares of the runs about their mean, pooled by their
/// degrees of freedom; where that is more than the surrogate's noise, its doubt of the mean grows
/// by the same factor. Mean: the surrogate's and the later runs', by their precisions; without a
/// surrogate the mean of all runs. The study's own run was chosen for being good: it counts through
/// the surrogate alone where there is one. Grid: the difference to the run at another spacing, else
/// between the surrogate's spacings, as one standard uncertainty. Degrees of freedom by
/// Welch-Satterthwaite (Biometrics Bull. 2 (1946) 110-114), the grid's without limit.
std::optional<RepeatEstimate> repeat_estimate(const RepeatEvidence& evidence);

/// An exact value, such as a formula's.
RepeatEstimate exact_estimate(double value);

/// What the runs to come are predicted to give: the surrogate alone, no run made since. Empty
/// without a surrogate.
std::optional<RepeatEstimate> prediction(const RepeatEvidence& evidence);

}  // namespace parapet::study
