#include "scalarized.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <limits>

#include "parapet/optimizer/sobol.hpp"
#include "parapet/study/problem.hpp"
#include "parapet/study/scoring.hpp"

namespace parapet::study {
namespace {

using optimizer::Termination;
using records::EvaluationRecord;

/// Point `number` of `count` spread over the inside of the unit cube [n]; on a line in equal steps.
std::vector<double> spread(int number, int count, std::size_t n) {
  if (n == 1) return {static_cast<double>(number + 1) / static_cast<double>(count + 1)};
  optimizer::SobolSequence sequence(static_cast<int>(n));
  std::vector<double> point;
  for (int k = 0; k <= number; ++k) point = sequence.next();
  return point;
}

/// Weights of sum 1, uniform over the simplex, from a point of the cube [n_objectives - 1]: the
/// gaps between its sorted coordinates.
std::vector<double> simplex_weights(std::vector<double> u) {
  std::sort(u.begin(), u.end());
  u.push_back(1.0);
  std::vector<double> weights;
  double before = 0.0;
  for (const double edge : u) {
    weights.push_back(edge - before);
    before = edge;
  }
  return weights;
}

/// What the evaluated designs span; the feasible ones where there are any.
void set_ranges(const std::vector<EvaluationRecord>& evaluated, std::size_t n, Subproblem& result) {
  const bool any = std::any_of(evaluated.begin(), evaluated.end(),
                               [](const EvaluationRecord& record) { return record.feasible; });
  constexpr double infinity = std::numeric_limits<double>::infinity();
  result.ideal.assign(n, infinity);
  std::vector<double> worst(n, -infinity);
  for (const EvaluationRecord& record : evaluated) {
    const auto f = minimized_objectives(record);
    if (!record.ok || f.size() != n || (any && !record.feasible)) continue;
    for (std::size_t j = 0; j < n; ++j) {
      result.ideal[j] = std::min(result.ideal[j], f[j]);
      worst[j] = std::max(worst[j], f[j]);
    }
  }
  for (std::size_t j = 0; j < n; ++j) {
    if (result.ideal[j] == infinity) result.ideal[j] = worst[j] = 0.0;
    result.range.push_back(worst[j] > result.ideal[j] ? worst[j] - result.ideal[j] : 1.0);
  }
}

/// The evaluated record that is best for a subproblem: least violation first, then least scalar.
const EvaluationRecord* best_start(const std::vector<EvaluationRecord>& evaluated,
                                   const Scalarizer& scalarizer) {
  const EvaluationRecord* best = nullptr;
  double best_violation = 0.0, best_scalar = 0.0;
  for (const EvaluationRecord& record : evaluated) {
    if (!record.ok) continue;
    const optimizer::Evaluation evaluation = scalarizer(record);
    if (!evaluation.ok) continue;
    double violation = 0.0;
    for (const double g : evaluation.constraints) {
      if (g > feasibility_tolerance) violation += g;
    }
    const bool better = best == nullptr || violation < best_violation ||
                        (violation == best_violation && evaluation.objective < best_scalar);
    if (!better) continue;
    best = &record;
    best_violation = violation;
    best_scalar = evaluation.objective;
  }
  return best;
}

Scalarizer scalarizer_of(const designs::StudySpec& study, const Subproblem& subproblem) {
  return [&study, subproblem](const EvaluationRecord& record) {
    optimizer::Evaluation evaluation;
    const auto f = minimized_objectives(record);
    if (f.empty()) {
      evaluation.reason = "an objective has no value";
      return evaluation;
    }
    evaluation.ok = true;
    evaluation.objective = subproblem.scalar(f);
    evaluation.constraints = score(study, record.design, events_of(record)).metric_violations;
    const auto more = subproblem.violations(f);
    evaluation.constraints.insert(evaluation.constraints.end(), more.begin(), more.end());
    return evaluation;
  };
}

/// One run of an optimiser on one subproblem.
optimizer::OptimizeResult solve(const designs::StudySpec& study, BlockingEvaluator& evaluator,
                                const Scalarizer& scalarizer, std::size_t n_constraints,
                                optimizer::Options options, std::size_t most_asked,
                                const std::string& stage) {
  optimizer::Problem problem = make_problem(study);
  problem.n_constraints = static_cast<int>(n_constraints);
  problem.evaluate = [&](const std::vector<double>& x) {
    return evaluator.evaluate({x}, stage, scalarizer).front();
  };
  problem.evaluate_batch = [&](const std::vector<std::vector<double>>& xs) {
    return evaluator.evaluate(xs, "start", scalarizer);
  };
  // Its own count includes designs that are known, which cost nothing here.
  const int share = static_cast<int>(most_asked - std::min(most_asked, evaluator.asked()));
  const int whole = options.max_evaluations;
  options.max_evaluations = std::min(whole, 2 * (share + 1));
  if (!optimizer::problem_errors(problem, options).empty()) options.max_evaluations = whole;
  options.cancelled = [&, most_asked] {
    return evaluator.stopped() || evaluator.asked() >= most_asked;
  };
  options.on_refused = [&](const std::vector<double>& x) { evaluator.refused(x); };
  return optimizer::optimize(problem, options);
}

std::vector<double> to_x(const designs::StudySpec& study, const designs::Design& design) {
  std::vector<double> x;
  for (const designs::Variable& variable : study.variables) x.push_back(design.at(variable.name));
  return x;
}

/// Runs the subproblems one after the other.
class Series {
 public:
  Series(const designs::StudySpec& study, BlockingEvaluator& evaluator)
      : study_(study), evaluator_(evaluator), options_(make_options(study)) {}

  optimizer::OptimizeResult run() {
    const int count = std::max(1, study_.method.pareto_points);
    total_ = evaluate_starts();
    if (total_.termination != Termination::cancelled) return total_;
    for (int number = 0; number < count && !over(); ++number) run_one(number, count);
    total_.evaluations = static_cast<int>(evaluator_.asked());
    if (evaluator_.stopped()) {
      total_.termination = Termination::cancelled;
    } else if (time_is_up()) {
      total_.termination = Termination::time_limit;
    } else if (evaluator_.asked() >= budget()) {
      total_.termination = Termination::budget;
    } else {
      total_.termination = Termination::converged;
    }
    total_.message = fmt::format("{} of {} scalarised problems begun; {}", begun_, count,
                                 optimizer::to_string(total_.termination));
    return total_;
  }

 private:
  std::size_t budget() const { return static_cast<std::size_t>(study_.method.max_evaluations); }
  bool time_is_up() const {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
    return options_.max_time_s > 0.0 && elapsed.count() >= options_.max_time_s;
  }
  bool over() const {
    return evaluator_.stopped() || time_is_up() || evaluator_.asked() >= budget();
  }

  /// The starting designs and nothing else: `cancelled` when that went well.
  optimizer::OptimizeResult evaluate_starts() {
    return solve(study_, evaluator_, weighted_sum(study_),
                 static_cast<std::size_t>(metric_limit_count(study_)), options_, 1, "start");
  }

  void run_one(int number, int count) {
    const std::size_t used = evaluator_.asked();
    const std::size_t left = budget() - used;
    const std::size_t share =
        std::max<std::size_t>(1, left / static_cast<std::size_t>(count - number));
    const auto evaluated = evaluator_.records();
    const Subproblem subproblem = make_subproblem(study_, evaluated, number, count);
    const Scalarizer scalarizer = scalarizer_of(study_, subproblem);
    optimizer::Options options = options_;
    if (options_.max_time_s > 0.0) {
      const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
      options.max_time_s = std::max(1e-3, options_.max_time_s - elapsed.count());
    }
    if (const EvaluationRecord* start = best_start(evaluated, scalarizer)) {
      options.starts = {to_x(study_, start->design)};
      options.start_count = 0;
    }
    const std::size_t limits =
        static_cast<std::size_t>(metric_limit_count(study_)) + subproblem.limits.size();
    const optimizer::OptimizeResult result =
        solve(study_, evaluator_, scalarizer, limits, options, used + share, "search");
    total_.cache_hits += result.cache_hits;
    total_.rejected += result.rejected;
    ++begun_;
  }

  const designs::StudySpec& study_;
  BlockingEvaluator& evaluator_;
  optimizer::Options options_;
  optimizer::OptimizeResult total_;
  int begun_ = 0;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace

double Subproblem::scalar(const std::vector<double>& objectives) const {
  if (kind == designs::Scalarization::epsilon_constraint) return objectives[0] / range[0];
  constexpr double augmentation = 0.05;
  double largest = -std::numeric_limits<double>::infinity(), sum = 0.0;
  for (std::size_t j = 0; j < objectives.size(); ++j) {
    const double distance = (objectives[j] - ideal[j]) / range[j];
    if (weights[j] > 0.0) largest = std::max(largest, weights[j] * distance);
    sum += distance;
  }
  return largest + augmentation * sum;
}

std::vector<double> Subproblem::violations(const std::vector<double>& objectives) const {
  std::vector<double> result;
  for (std::size_t j = 0; j < limits.size(); ++j) {
    result.push_back((objectives[j + 1] - limits[j]) / range[j + 1]);
  }
  return result;
}

Subproblem make_subproblem(const designs::StudySpec& study,
                           const std::vector<EvaluationRecord>& evaluated, int number, int count) {
  const std::size_t n = study.objectives.size();
  const auto ends = static_cast<int>(n) <= count ? static_cast<int>(n) : 0;
  Subproblem result;
  set_ranges(evaluated, n, result);
  if (number < ends) {
    result.weights.assign(n, 0.0);
    result.weights[static_cast<std::size_t>(number)] = 1.0;
    return result;
  }
  result.kind = study.method.scalarization;
  const auto u = spread(number - ends, count - ends, n - 1);
  if (result.kind == designs::Scalarization::epsilon_constraint) {
    for (std::size_t j = 1; j < n; ++j) {
      result.limits.push_back(result.ideal[j] + u[j - 1] * result.range[j]);
    }
  } else {
    result.weights = simplex_weights(u);
  }
  return result;
}

optimizer::OptimizeResult optimize_scalarized(const designs::StudySpec& study,
                                              BlockingEvaluator& evaluator) {
  return Series(study, evaluator).run();
}

}  // namespace parapet::study
