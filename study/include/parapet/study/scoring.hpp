/// From metrics to what an optimiser needs: one scalar objective and scaled constraints.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "parapet/designs/study_spec.hpp"
#include "parapet/records/evaluation_log.hpp"
#include "parapet/solver/result.hpp"
#include "parapet/study/quantity.hpp"

namespace parapet::study {

/// A scaled violation up to this counts as satisfied; optimizer::Options has the same default.
constexpr double feasibility_tolerance = 1e-9;

/// What a design is worth.
struct Score {
  std::vector<records::ObjectiveRecord> objectives;
  std::optional<double> objective_scalar;  ///< minimised; empty when an objective has no value
  std::string problem;                     ///< why there is no scalar
  std::vector<records::ConstraintRecord> constraints;  ///< in the spec's order
  std::vector<double>
      metric_violations;  ///< <= 0 when satisfied; one per limit that needs a simulation
  bool feasible = false;  ///< every constraint, expressions too
  std::vector<records::TermRecord> terms = {};  ///< in the order of their names
};

/// Scores a design whose simulations ended well.
///
/// Objectives and constraints that need a simulation are statistics over the events (see Quantity).
/// The scalar is the sum of -weight value/scale (maximise) or +weight value/scale (minimise). The
/// violation of a limit is (value - upper)/scale or (lower - value)/scale; that of a quantity
/// without a value is -1 when it is then satisfied and +1 otherwise. A constraint with the
/// statistic probability is one limit, (quantile - probability).
/// @param events [n_events] at least one, all weights together 1
Score score(const designs::StudySpec& study, const designs::Design& design,
            const std::vector<Event>& events);

/// The same for a study with the base event alone.
Score score(const designs::StudySpec& study, const designs::Design& design,
            const std::vector<solver::Metric>& metrics);

/// Value of a formula at a design; a variable that does not exist there counts as 0. Empty where
/// it is not finite.
std::optional<double> formula_value(const designs::StudySpec& study, const std::string& expression,
                                    const designs::Design& design);

/// Scaled violations of a constraint on the design alone, one per limit, lower before upper: those
/// of expression_violations() with the expression's value given.
std::vector<double> limit_violations(const designs::Constraint& constraint,
                                     std::optional<double> value);

/// What reports call an objective.
std::string objective_name(const designs::Objective& objective);

/// Objectives of a record as numbers to be minimised [n_objectives], unscaled; empty when one has
/// no value.
std::vector<double> minimized_objectives(const records::EvaluationRecord& record);

/// What the constraints that need no simulation say; the others are left out.
std::vector<records::ConstraintRecord> score_expressions(const designs::StudySpec& study,
                                                         const designs::Design& design);

/// Scaled violations of the constraints on the design alone, one per limit: these need no
/// simulation. An
/// expression without a finite value is a violation.
std::vector<double> expression_violations(const designs::StudySpec& study,
                                          const designs::Design& design);

/// Number of limits that need a simulation.
int metric_limit_count(const designs::StudySpec& study);

/// Number of limits that need none.
int expression_limit_count(const designs::StudySpec& study);

}  // namespace parapet::study
