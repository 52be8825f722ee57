/// Designs of experiments: lists of designs that are laid out before anything is simulated.
#pragma once

#include <string>
#include <vector>

#include "parapet/designs/study_spec.hpp"

namespace parapet::study {

/// What is to be simulated, in this order.
struct Experiments {
  std::vector<designs::Design> designs;  ///< each once; the first n_starts are the spec's
  std::size_t n_starts = 0;
  int refused = 0;  ///< designs that the constraints on formulas refuse
  std::vector<designs::Design> refused_designs = {};  ///< the first of them, as many as are logged
};

/// The spec's starting designs, then
///   SOBOL: points of a Sobol' sequence over the bounds, until there are max_evaluations designs
///   LATIN_HYPERCUBE: the designs of a Latin hypercube (McKay, Beckman and Conover, Technometrics
///     21 (1979) 239-245) of as many points as are left of max_evaluations, drawn from the seed
///   FULL_FACTORIAL: points_per_variable levels of every continuous variable, bounds included,
///     at most as many different values of an integer, and every option of a choice
///   LIST: nothing more
/// Designs that the constraints on formulas refuse are left out and counted. Sobol' goes on until
/// enough are allowed, or 999 of 1000 are refused (19 of 20 where that takes millions of points).
/// @throws designs::InputError when there are more designs than max_evaluations allows, or too many
///         variables for the sequence.
Experiments lay_out_experiments(const designs::StudySpec& study);

/// The same objections without the list: designs are counted, not laid out, wherever no constraint
/// on a formula and no condition of a variable decides which ones there are.
void require_experiments_in_budget(const designs::StudySpec& study);

}  // namespace parapet::study
