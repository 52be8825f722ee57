#include "rule_scores.hpp"

#include <cmath>

#include "parapet/study/knee.hpp"
#include "parapet/study/scoring.hpp"

namespace parapet::study {
namespace {

std::vector<double> knee_scores(const std::vector<std::vector<double>>& values) {
  std::vector<double> scores;
  for (const double distance : knee_of(values).distance) {
    // The ends lie on the plane but for rounding, which must not decide between them.
    scores.push_back(std::abs(distance) < 1e-12 ? -0.0 : -distance);
  }
  return scores;
}

/// The spec's weighted sum, as objective_scalar.
Scores weighted_sum(const designs::StudySpec& study) {
  return [&study](const std::vector<std::vector<double>>& values) {
    std::vector<double> scores;
    for (const std::vector<double>& point : values) {
      double sum = 0.0;
      for (std::size_t j = 0; j < point.size(); ++j) {
        sum += study.objectives[j].weight * point[j] / study.objectives[j].scale;
      }
      scores.push_back(sum);
    }
    return scores;
  };
}

Scores weighted_ranges(const LoadedStudy& study, const PickRule& rule) {
  std::vector<double> weights(study.spec.objectives.size(), 0.0);
  for (const auto& [name, weight] : rule.weights) {
    weights[objective_index(study.spec, name, "--weights")] = weight;
  }
  return [weights](const std::vector<std::vector<double>>& values) {
    const FrontRange range = range_of(values);
    std::vector<double> scores;
    for (const std::vector<double>& point : values) {
      const std::vector<double> scaled = range.normalised(point);
      double sum = 0.0;
      for (std::size_t j = 0; j < scaled.size(); ++j) sum += weights[j] * scaled[j];
      scores.push_back(sum);
    }
    return scores;
  };
}

std::vector<double> first_objectives(const std::vector<std::vector<double>>& values) {
  std::vector<double> scores;
  for (const std::vector<double>& point : values) scores.push_back(point.front());
  return scores;
}

}  // namespace

std::size_t objective_index(const designs::StudySpec& study, const std::string& name,
                            const char* option) {
  std::string names;
  for (std::size_t j = 0; j < study.objectives.size(); ++j) {
    const designs::Objective& objective = study.objectives[j];
    const std::string own = objective_name(objective);
    const std::string& of = objective.metric.empty() ? objective.expression : objective.metric;
    if (own == name || of == name) return j;
    names += j == 0 ? "" : j + 1 == study.objectives.size() ? " and " : ", ";
    names += own;
  }
  throw designs::InputError(
      {{option, "", name, "the study has no objective of that name", "one of " + names}});
}

Scores scores_of(const LoadedStudy& study, const PickRule& rule, RuleKind kind) {
  switch (kind) {
    case RuleKind::knee:
      return knee_scores;
    case RuleKind::balanced:
      return largest_objectives;
    case RuleKind::weights:
      return weighted_ranges(study, rule);
    case RuleKind::limits:
      return first_objectives;
    case RuleKind::automatic:
    case RuleKind::best:
      break;
  }
  return weighted_sum(study.spec);
}

}  // namespace parapet::study
