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

/// Collects allowed designs, each once.
class Layout {
 public:
  explicit Layout(const StudySpec& study) : study_(study), space_(make_space(study)) {}

  const bayesian::Space& space() const { return space_; }
  std::size_t size() const { return result_.designs.size(); }

  void add(const designs::Design& design) {
    if (!seen_.insert(design).second) return;
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
  Experiments result_;
};

std::size_t budget(const StudySpec& study) {
  return static_cast<std::size_t>(std::max(0, study.method.max_evaluations));
}

void add_sobol(const StudySpec& study, Layout& layout) {
  const auto n = static_cast<int>(study.variables.size());
  if (n > optimizer::SobolSequence::max_dimension) {
    refuse(study, "algorithm", study.method.algorithm,
           fmt::format("is known for fewer than {} variables", n),
           fmt::format("at most {} variables, or LATIN_HYPERCUBE",
                       optimizer::SobolSequence::max_dimension));
  }
  constexpr std::size_t tries_per_design = 1000;
  optimizer::SobolSequence sequence(n);
  for (std::size_t k = 0; k < tries_per_design * budget(study); ++k) {
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

/// Values of one variable in a full factorial.
std::vector<double> factor_levels(const designs::Variable& variable, int points) {
  std::vector<double> levels;
  const bool whole = variable.kind != designs::VariableKind::continuous;
  const double range = variable.upper - variable.lower;
  if (whole && (variable.kind == designs::VariableKind::choice || range + 1.0 <= points)) {
    for (double value = variable.lower; value <= variable.upper; value += 1.0) {
      levels.push_back(value);
    }
    return levels;
  }
  for (int k = 0; k < points; ++k) {
    const double share = points == 1 ? 0.5 : static_cast<double>(k) / (points - 1);
    const double value = k > 0 && k + 1 == points ? variable.upper : variable.lower + share * range;
    levels.push_back(whole ? std::round(value) : value);
  }
  return levels;
}

void add_full_factorial(const StudySpec& study, Layout& layout) {
  constexpr std::size_t most = 10'000'000;
  std::vector<std::vector<double>> levels;
  std::size_t count = 1;
  for (const designs::Variable& variable : study.variables) {
    levels.push_back(factor_levels(variable, study.method.points_per_variable));
    count *= levels.back().size();
    if (count > most) {
      refuse(study, "points_per_variable", std::to_string(study.method.points_per_variable),
             fmt::format("gives more than {} designs", most),
             "fewer levels or variables, or another algorithm");
    }
  }
  for (std::size_t number = 0; number < count; ++number) {
    bayesian::Point point;
    std::size_t rest = number;
    for (const auto& values : levels) {
      point.push_back(values[rest % values.size()]);
      rest /= values.size();
    }
    layout.add(to_design(study, layout.space(), point));
  }
}

}  // namespace

Experiments lay_out_experiments(const StudySpec& study) {
  Layout layout(study);
  for (const designs::Design& start : study.method.starts) layout.add(start);
  layout.end_of_starts();
  const std::string name = designs::algorithm_name(study);
  if (name == "SOBOL") add_sobol(study, layout);
  if (name == "LATIN_HYPERCUBE") add_latin_hypercube(study, layout);
  if (name == "FULL_FACTORIAL") add_full_factorial(study, layout);
  if (layout.size() > budget(study)) {
    refuse(study, "max_evaluations", std::to_string(study.method.max_evaluations),
           fmt::format("does not allow the {} designs of {}", layout.size(), name),
           fmt::format("at least {}", layout.size()));
  }
  return layout.take();
}

}  // namespace parapet::study
