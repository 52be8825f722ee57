/// Numerical uncertainty of a result: how far the metrics move with the particle spacing and with
/// the arrangement of the particles.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "parapet/solver/simulation.hpp"

namespace parapet::solver {

/// The limit of fine spacings and the distance to it, by least squares over several spacings (Eca
/// and Hoekstra 2014, J. Comput. Phys. 262:104-130, after Roache's grid convergence index).
struct DiscretisationError {
  double extrapolated = 0.0;    ///< phi_0 of phi = phi_0 + alpha h^p
  double order = 0.0;           ///< p, observed or assumed
  double coefficient = 0.0;     ///< alpha h^p at the finest spacing
  double deviation = 0.0;       ///< standard deviation of the values about the fit
  bool order_observed = false;  ///< the fit is monotone with 0.5 <= p <= 2.1
  double uncertainty = 0.0;  ///< half width about the finest value: F_s |phi_1 - phi_0| + standard
                             ///< deviation of the fit + |phi_1 - fit|; F_s = 1.25 where the order
                             ///< is observed, else 3
};

/// @param spacings [n >= 3], finest first [m]
/// @param values [n], in the metric's unit
/// @throws std::invalid_argument for fewer than three spacings or arrays of unequal length.
DiscretisationError discretisation_error(std::span<const double> spacings,
                                         std::span<const double> values);

/// Which runs are made: at each ratio of the particle spacing the given number, the first of them
/// on the regular lattice, the others with every particle moved at random.
struct UncertaintyPlan {
  /// The runs at one particle spacing.
  struct Level {
    double spacing_ratio;  ///< over the spacing of the result itself
    int runs;
  };
  /// Together 2.7 times the cost of the result itself.
  std::vector<Level> levels = {{1.0, 1}, {1.4142135623730951, 3}, {2.0, 5}};
  double lattice_jitter = 0.01;  ///< largest offset, as a share of the particle spacing
  int jobs = 1;                  ///< runs side by side; the answer does not depend on it
};

/// simulate(), then the further runs of the plan; the result's metrics carry their uncertainty.
/// The discretisation error is taken from the means of the levels, the scatter from the spread
/// within the levels, pooled (it is assumed not to grow with refinement). A metric that a run
/// lacks, or whose runs failed, gets no uncertainty.
/// @param on_progress share of the whole work that is done; return false to cancel
/// @throws std::invalid_argument as simulate, and for a plan without three levels, with a first
///         ratio other than 1, ratios that do not rise, no runs, or no level with two runs.
Result simulate_with_uncertainty(const Scene& scene, const Numerics& numerics,
                                 const RunOptions& options, const UncertaintyPlan& plan,
                                 const std::function<bool(double)>& on_progress = {},
                                 const std::function<void(const Frame&)>& on_frame = {});

}  // namespace parapet::solver
