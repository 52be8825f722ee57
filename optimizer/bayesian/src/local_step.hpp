/// The last digits: a step from the best design by NLopt on surrogates of its neighbourhood.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "told.hpp"

namespace parapet::bayesian {

/// Where a local step may go: a box around the best feasible design.
struct TrustRegion {
  std::size_t best = 0;     ///< index into what was told
  double half_width = 0.0;  ///< share of each range
};

/// Follows from what was told alone: it grows with every step that improves the best design near
/// its edge, and shrinks by half with every few inside it that do not (Regis and Shoemaker, ORBIT,
/// SIAM J. Sci. Comput. 30 (2008) 3197-3219, with the same rule). Empty before a feasible design of
/// the finest level is known. Of one objective.
std::optional<TrustRegion> trust_region(const Problem& problem, const std::vector<Told>& told,
                                        double tolerance);

/// Evaluations other than local steps since one of them improved the best design.
int idle_evaluations(const Problem& problem, const std::vector<Told>& told, double tolerance);

/// Whether the next evaluation is a local step, and not one of the global search: the kind that has
/// improved the best design more of late, by an average that halves with each of its evaluations.
/// Every fourth evaluation at least is of the other kind.
bool local_turn(const Problem& problem, const std::vector<Told>& told, double tolerance);

/// The design of the least surrogate objective in the trust region that meets the surrogate limits.
/// The surrogates are Gaussian processes of the designs nearest to the best one, fitted on the
/// scale of these: near a smooth optimum each step gains digits, which a process of the whole space
/// does not resolve. Where NLopt comes back to a known design, the design of which the surrogate
/// knows least. Only continuous variables that exist at the best design move. Empty without enough
/// designs, or when the step would gain less than the noise.
std::optional<Point> local_step(const Problem& problem, const std::vector<Told>& told,
                                const TrustRegion& region, double tolerance, std::uint64_t seed);

}  // namespace parapet::bayesian
