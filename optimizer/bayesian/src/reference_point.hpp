/// Where the hypervolume is measured from.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "told.hpp"

namespace parapet::bayesian {

/// The reference point, objectives minimised, in the metrics' units. What the problem gives is
/// taken. Otherwise the worse of two: the worst value on the observed front (finest level, feasible
/// designs, or all where none is) plus a tenth of the front's range, as Ishibuchi et al. (Evol.
/// Comput. 26 (2018) 411-440) advise; and the value that 90 % of the observed designs reach or
/// better. For one objective the worst value observed. It moves as designs are told. Empty while
/// nothing was observed.
std::optional<Eigen::VectorXd> reference_point(const Problem& problem,
                                               const std::vector<Told>& told, double tolerance);

}  // namespace parapet::bayesian
