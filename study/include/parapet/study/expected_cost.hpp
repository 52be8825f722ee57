/// What a case or a study will cost, before anything is simulated.
#pragma once

#include <vector>

#include "parapet/designs/study_spec.hpp"
#include "parapet/solver/expected_cost.hpp"

namespace parapet::study {

/// Of one simulation.
struct CaseCost {
  double spacing = 0.0;  ///< particle spacing [m]
  solver::ExpectedCost counts;
  double seconds = 0.0;  ///< of one core at 2.6 GHz, if the run goes on to its stop time
};

/// Of a study: the base case, under the scenario that costs most in memory and over the mean of all
/// in time.
struct StudyCost {
  std::vector<CaseCost> levels;  ///< of the study's fidelity, finest first
  double designs = 0.0;          ///< at most, by the budgets that count designs
  double events = 1.0;           ///< simulations of each design
  double seconds = 0.0;          ///< at most, of one core, all at the finest spacing
};

/// Of one case, to its stop time.
CaseCost case_cost(const designs::CaseSpec& spec);
/// Of a study, by its budgets; designs that end early make it less.
StudyCost study_cost(const designs::StudySpec& study);

/// Why a case cannot run: more particles, walls or neighbours than the solver can number, or more
/// memory than there is. Empty when it can.
/// @param memory of the machine [bytes]
/// @param prefix of the case in its file: "" or "/case"
std::vector<designs::InputIssue> cost_issues(const CaseCost& cost, double memory,
                                             const std::string& file, const std::string& prefix);

/// Memory of this machine that the program may use [bytes].
double machine_memory();

}  // namespace parapet::study
