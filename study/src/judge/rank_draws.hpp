/// How often a rule would take each design, over draws of the surrogates' posterior.
#pragma once

#include <functional>
#include <vector>

#include "parapet/study/pick.hpp"

namespace parapet::study {

/// Objectives [n_designs][n_objectives], minimised -> a score for each design; less is better.
using Scores = std::function<std::vector<double>(const std::vector<std::vector<double>>& values)>;

/// Joint draws of the objectives [n_draws][n_designs][n_objectives], minimised: what the surrogates
/// do not know of the noise-free values. Formulas, and objectives without a surrogate, stay as they
/// are expected. None where no objective has a surrogate.
std::vector<std::vector<std::vector<double>>> objective_draws(
    const LoadedStudy& study, const std::vector<Candidate>& candidates);

/// Share and beats of each candidate, where there are draws. The first one is the leader.
void count_draws(const std::vector<std::vector<std::vector<double>>>& draws, const Scores& scores,
                 std::vector<Candidate>& candidates);

}  // namespace parapet::study
