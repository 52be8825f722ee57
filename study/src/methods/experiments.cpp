#include "parapet/study/experiments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <set>

#include "parapet/optimizer/sobol.hpp"
#include "parapet/records/study_folder.hpp"
#include "parapet/study/bayesian_problem.hpp"
#include "parapet/study/problem.hpp"
#include "parapet/study/scoring.hpp"

namespace parapet::study {
namespace {

using designs::StudySpec;

[[noreturn]] void refuse(const StudySpec& study, const std::string& member,
                         const std::string& value, const std::string& problem,
                         const std::string& allowed) {
  throw designs::InputError({{.file = study.source_file,
                              .pointer = "/method/" + member,
                              .value = value,
                              .problem = problem,
                              .allowed = allowed}});
}

bool has_conditions(const StudySpec& study) {
  return std::ranges::any_of(study.variables,
                             [](const auto& variable) { return variable.active_when.has_value(); });
}

/// Collects allowed designs, each once.
class Layout {
 public:
  explicit Layout(const StudySpec& study) : study_(study), space_(make_space(study)) {}

  const bayesian::Space& space() const { return space_; }
  std::size_t size() const { return result_.designs.size(); }

  void add(const designs::Design& design) {
    if (seen_.contains(design)) return;
    const auto g = expression_violations(study_, design);
    const bool allowed =
        std::all_of(g.begin(), g.end(), [](double v) { return v <= feasibility_tolerance; });
    if (allowed) {
      result_.designs.push_back(design);
    } else {
      ++result_.refused;
      if (result_.refused_designs.size() < records::most_refused_designs) {
        result_.refused_designs.push_back(design);
      }
    }
    // A refused design comes again only where variables may be inactive.
    if (allowed || may_repeat_) seen_.insert(design);
  }

  void add_unit(const std::vector<double>& u) {
    add(to_design(study_, space_, space_.from_unit(u)));
  }

  void end_of_starts() { result_.n_starts = size(); }
  Experiments take() { return std::move(result_); }

 private:
  const StudySpec& study_;
  bayesian::Space space_;
  std::set<designs::Design> seen_;
  bool may_repeat_ = has_conditions(study_);
  Experiments result_;
};

std::size_t budget(const StudySpec& study) {
  return static_cast<std::size_t>(std::max(0, study.method.max_evaluations));
}

void require_sobol_dimensions(const StudySpec& study) {
  const auto n = static_cast<int>(study.variables.size());
  if (n > optimizer::SobolSequence::max_dimension) {
    refuse(study, "algorithm", study.method.algorithm,
           fmt::format("is known for fewer than {} variables", n),
           fmt::format("at most {} variables, or LATIN_HYPERCUBE",
                       optimizer::SobolSequence::max_dimension));
  }
}

void add_sobol(const StudySpec& study, Layout& layout) {
  constexpr std::size_t tries_per_design = 1000, many_tries = 1'000'000, least_per_design = 20;
  const std::size_t tries = std::min(tries_per_design * budget(study),
                                     std::max(many_tries, least_per_design * budget(study)));
  optimizer::SobolSequence sequence(static_cast<int>(study.variables.size()));
  for (std::size_t k = 0; k < tries; ++k) {
    if (layout.size() >= budget(study)) return;
    layout.add_unit(sequence.next());
  }
}

void add_latin_hypercube(const StudySpec& study, Layout& layout) {
  if (layout.size() >= budget(study)) return;
  const std::size_t n = budget(study) - layout.size();
  std::mt19937_64 generator(study.method.seed);
  const auto uniform = [&] {  // [0, 1), 53 bits
    return static_cast<double>(generator() >> 11) * 0x1.0p-53;
  };
  std::vector<std::vector<double>> points(n, std::vector<double>(study.variables.size()));
  for (std::size_t i = 0; i < study.variables.size(); ++i) {
    std::vector<std::size_t> stratum(n);
    for (std::size_t k = 0; k < n; ++k) stratum[k] = k;
    for (std::size_t k = n; k-- > 1;) {
      const auto other = static_cast<std::size_t>(uniform() * static_cast<double>(k + 1));
      std::swap(stratum[k], stratum[other]);
    }
    for (std::size_t k = 0; k < n; ++k) {
      points[k][i] = (static_cast<double>(stratum[k]) + uniform()) / static_cast<double>(n);
    }
  }
  for (const auto& point : points) layout.add_unit(point);
}

/// Whether a full factorial takes every value of a variable.
bool takes_every_value(const designs::Variable& variable, int points) {
  const bool whole = variable.kind != designs::VariableKind::continuous;
  return whole && (variable.kind == designs::VariableKind::choice ||
                   variable.upper - variable.lower + 1.0 <= points);
}

/// Values of one variable in a full factorial.
std::vector<double> factor_levels(const designs::Variable& variable, int points) {
  std::vector<double> levels;
  if (takes_every_value(variable, points)) {
    for (double value = variable.lower; value <= variable.upper; value += 1.0) {
      levels.push_back(value);
    }
    return levels;
  }
  const bool whole = variable.kind != designs::VariableKind::continuous;
  const double range = variable.upper - variable.lower;
  for (int k = 0; k < points; ++k) {
    const double share = points == 1 ? 0.5 : static_cast<double>(k) / (points - 1);
    const double value = k > 0 && k + 1 == points ? variable.upper : variable.lower + share * range;
    levels.push_back(whole ? std::round(value) : value);
  }
  return levels;
}

std::vector<std::vector<double>> all_levels(const StudySpec& study) {
  std::vector<std::vector<double>> levels;
  for (const designs::Variable& variable : study.variables) {
    levels.push_back(factor_levels(variable, study.method.points_per_variable));
  }
  return levels;
}

/// Starts that are not among the designs of the factorial.
std::size_t starts_beside(const StudySpec& study, const std::vector<std::vector<double>>& levels) {
  const auto on_levels = [&](const designs::Design& start) {
    for (std::size_t i = 0; i < levels.size(); ++i) {
      const auto found = start.find(study.variables[i].name);
      if (found == start.end() || std::ranges::find(levels[i], found->second) == levels[i].end()) {
        return false;
      }
    }
    return true;
  };
  const std::set<designs::Design> starts(study.method.starts.begin(), study.method.starts.end());
  return static_cast<std::size_t>(std::ranges::count_if(
      starts, [&](const designs::Design& start) { return !on_levels(start); }));
}

[[noreturn]] void refuse_budget(const StudySpec& study, const std::string& designs,
                                const std::string& allowed) {
  refuse(
      study, "max_evaluations", std::to_string(study.method.max_evaluations),
      fmt::format("does not allow the {} designs of {}", designs, designs::algorithm_name(study)),
      allowed);
}

/// Compares a full factorial with the budget. Where constraints or inactive variables leave designs
/// out, it is compared while it is laid out.
void require_factorial_in_budget(const StudySpec& study) {
  constexpr double most = 1e6;  // the largest budget
  double count = 1.0;
  for (const designs::Variable& variable : study.variables) {
    const int points = study.method.points_per_variable;
    count *= takes_every_value(variable, points) ? variable.upper - variable.lower + 1.0 : points;
  }
  if (count > most) {
    refuse(study, "points_per_variable", std::to_string(study.method.points_per_variable),
           fmt::format("gives {:.4g} designs, more than {:.0f}", count, most),
           "fewer levels or variables, or another algorithm");
  }
  if (expression_limit_count(study) > 0 || has_conditions(study)) return;
  const std::size_t all = static_cast<std::size_t>(count) + starts_beside(study, all_levels(study));
  if (all > budget(study)) {
    refuse_budget(study, std::to_string(all), fmt::format("at least {}", all));
  }
}

void add_full_factorial(const StudySpec& study, Layout& layout) {
  const std::vector<std::vector<double>> levels = all_levels(study);
  std::size_t count = 1;
  for (const auto& values : levels) count *= values.size();
  for (std::size_t number = 0; number < count && layout.size() <= budget(study); ++number) {
    bayesian::Point point;
    std::size_t rest = number;
    for (const auto& values : levels) {
      point.push_back(values[rest % values.size()]);
      rest /= values.size();
    }
    layout.add(to_design(study, layout.space(), point));
  }
}

/// The starts, and what is compared with the budget while it is laid out.
void add_counted(const StudySpec& study, Layout& layout) {
  const std::string name = designs::algorithm_name(study);
  for (const designs::Design& start : study.method.starts) layout.add(start);
  layout.end_of_starts();
  if (name == "FULL_FACTORIAL") add_full_factorial(study, layout);
  if (layout.size() <= budget(study)) return;
  const bool whole = name != "FULL_FACTORIAL";
  refuse_budget(study, whole ? std::to_string(layout.size()) : "more",
                whole ? fmt::format("at least {}", layout.size())
                      : "a larger budget, fewer levels or variables, or another algorithm");
}

/// What can be said from counts alone.
void require_counts(const StudySpec& study) {
  const std::string name = designs::algorithm_name(study);
  if (name == "SOBOL") require_sobol_dimensions(study);
  if (name == "FULL_FACTORIAL") require_factorial_in_budget(study);
}

}  // namespace

void require_experiments_in_budget(const StudySpec& study) {
  require_counts(study);
  const bool counted = expression_limit_count(study) == 0 && !has_conditions(study) &&
                       designs::algorithm_name(study) == "FULL_FACTORIAL";
  if (counted) return;
  Layout layout(study);
  add_counted(study, layout);
}

Experiments lay_out_experiments(const StudySpec& study) {
  require_counts(study);
  Layout layout(study);
  add_counted(study, layout);
  const std::string name = designs::algorithm_name(study);
  if (name == "SOBOL") add_sobol(study, layout);
  if (name == "LATIN_HYPERCUBE") add_latin_hypercube(study, layout);
  return layout.take();
}

}  // namespace parapet::study
