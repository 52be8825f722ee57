/// A study as the optimizer sees it, and the checks of its method.
#pragma once

#include <vector>

#include "parapet/designs/study_spec.hpp"
#include "parapet/optimizer/optimize.hpp"

namespace parapet::study {

/// Variables, bounds and the constraints that need no simulation. `evaluate` is left to the caller;
/// `study` must outlive the problem.
optimizer::Problem make_problem(const designs::StudySpec& study);

/// The spec's method in the optimizer's terms. An empty local_algorithm of MLSL or AUGLAG becomes
/// COBYLA.
optimizer::Options make_options(const designs::StudySpec& study);

/// Design of a point x [n], in the order of the study's variables. Integers are rounded.
designs::Design to_design(const designs::StudySpec& study, const std::vector<double>& x);

/// What the optimizer says against the study's method, each placed under /method.
std::vector<designs::InputIssue> method_issues(const designs::StudySpec& study);

}  // namespace parapet::study
