/// Several objectives for optimisers that know one: a series of scalarised problems.
#pragma once

#include <vector>

#include "blocking_evaluator.hpp"
#include "parapet/optimizer/optimize.hpp"

namespace parapet::study {

/// One scalarised problem. Objectives are minimised ones, f_j.
struct Subproblem {
  designs::Scalarization kind = designs::Scalarization::augmented_chebyshev;
  std::vector<double> ideal;    ///< [n_objectives] least values seen
  std::vector<double> range;    ///< [n_objectives] greatest minus least, > 0
  std::vector<double> weights;  ///< [n_objectives], sum 1; one of them alone ends the front
  std::vector<double> limits;   ///< [n_objectives - 1] of f_1 ... (epsilon constraint)

  /// The scalar. Augmented Chebyshev (Steuer and Choo, Math. Program. 26 (1983) 326-344):
  /// max_j w_j (f_j - ideal_j)/range_j + 0.05 sum_j (f_j - ideal_j)/range_j, the maximum over the
  /// j with w_j > 0. Epsilon constraint
  /// (Haimes, Lasdon and Wismer, IEEE Trans. Syst. Man Cybern. 1 (1971) 296-297): f_0 / range_0.
  double scalar(const std::vector<double>& objectives) const;

  /// Violations of f_j <= limit_j, over the range [n_objectives - 1]; empty for the other kind.
  std::vector<double> violations(const std::vector<double>& objectives) const;
};

/// Subproblem `number` of `count`, for the ranges of what was evaluated so far. With at least
/// n_objectives of them the first ones look for the ends of the front, one objective each: before,
/// the ranges are those of the starting designs only. The others are spread between the ends.
Subproblem make_subproblem(const designs::StudySpec& study,
                           const std::vector<records::EvaluationRecord>& evaluated, int number,
                           int count);

/// Solves method.pareto_points subproblems, each from the best design known for it. They share the
/// budget of max_evaluations different designs, starting ones included; a design that is known
/// costs nothing. The same sequence follows when an interrupted study is run again.
optimizer::OptimizeResult optimize_scalarized(const designs::StudySpec& study,
                                              BlockingEvaluator& evaluator);

}  // namespace parapet::study
