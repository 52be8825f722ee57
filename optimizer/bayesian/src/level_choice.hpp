/// Which particle spacing, or any other level, tells most about a design for its cost.
#pragma once

#include "models.hpp"

namespace parapet::bayesian {

/// Share of the finest level's variance that an observation at this level would settle [m], 0 .. 1:
/// the squared posterior correlation, times what the level's noise leaves of its own variance.
Eigen::VectorXd informative_share(const surrogate::GaussianProcess& process,
                                  const Eigen::MatrixXd& inputs, int level);

/// For a design that is to test the surrogates: the level of the largest gain per second: the gain
/// at the finest level, times the squared correlation of the level with it (how much of that gain
/// the level can show), times what the level's noise leaves of the information, over the level's
/// cost (Huang et al., Struct. Multidiscip. Optim. 32 (2006) 369-382, with the square of the
/// correlation, a share of variance). The least over the objectives and limits that are modelled
/// counts.
/// @param seconds [n_levels] cost of an evaluation
/// @param taken whether the level was evaluated at this design already
int choose_level(const Problem& problem, const Models& models, const Point& x,
                 const std::vector<double>& seconds, const std::vector<bool>& taken);

}  // namespace parapet::bayesian
