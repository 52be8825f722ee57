#include "effects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "key_text.hpp"
#include "parapet/study/comparable.hpp"
#include "response_fit.hpp"

namespace parapet::reports {
namespace {

/// Metrics of the objectives, then of the constraints, each once.
std::vector<std::string> asked_metrics(const designs::StudySpec& study) {
  std::vector<std::string> keys;
  const auto add = [&](const std::string& key) {
    if (!key.empty() && std::ranges::find(keys, key) == keys.end()) keys.push_back(key);
  };
  for (const designs::Objective& objective : study.objectives) add(objective.metric);
  for (const designs::Constraint& constraint : study.constraints) add(constraint.metric);
  return keys;
}

/// One sentence on a variable, no stronger than the data.
std::string sentence(const VariableEffect& effect, const ResponseFit& fit,
                     const std::string& metric, const std::string& variable) {
  if (effect.tried_from == effect.tried_to) return "was not varied";
  if (fit.model == ResponseModel::none || !effect.change) return "the data cannot tell";
  if (fit.r2_left_out < rough_r2) return "the data cannot tell (the fit does not predict)";
  std::string words;
  if (effect.change_clear) {
    words =
        fmt::format("{} by {} ± {} from {} to {}", *effect.change > 0.0 ? "rises" : "falls",
                    number_text(std::abs(*effect.change)), with_unit(effect.standard_error, metric),
                    with_unit(effect.tried_from, variable), with_unit(effect.tried_to, variable));
  }
  if (effect.bend_clear) {
    words += words.empty() ? "" : "; ";
    words += effect.bend > 0.0 ? "lowest inside the range tried, or flattening there"
                               : "highest inside the range tried, or flattening there";
  }
  if (words.empty()) words = "no effect that the data can tell from the scatter";
  return words;
}

std::string verdict(const ResponseFit& fit) {
  if (fit.model == ResponseModel::none) return fmt::format("no fit: {}", fit.why_none);
  if (fit.r2_left_out >= trusted_r2) return "the fit predicts designs left out of it well";
  if (fit.r2_left_out >= rough_r2) {
    return "the fit predicts designs left out of it only roughly; read it as a trend";
  }
  return "the fit does not predict designs left out of it: the data cannot tell what the variables "
         "do";
}

ResponseFit fit_metric(const study::LoadedStudy& study, const std::string& metric) {
  std::vector<std::vector<double>> x;
  std::vector<double> y;
  for (const records::EvaluationRecord* record : study::comparable_designs(study)) {
    const auto found = std::ranges::find(record->metrics, metric, &solver::Metric::key);
    if (found == record->metrics.end() || !found->value || !std::isfinite(*found->value)) continue;
    std::vector<double> row;
    for (const designs::Variable& variable : study.spec.variables) {
      row.push_back(record->design.at(variable.name));
    }
    x.push_back(std::move(row));
    y.push_back(*found->value);
  }
  return fit_response(x, y);
}

VariableResponse variable_response(const VariableEffect& effect, const ResponseFit& fit,
                                   const std::string& metric, const std::string& variable) {
  const auto with_change = [&](double value) {
    return effect.change ? std::optional(value) : std::nullopt;
  };
  return {.variable = variable,
          .tried_from = effect.tried_from,
          .tried_to = effect.tried_to,
          .change = effect.change,
          .standard_error = with_change(effect.standard_error),
          .standardised = with_change(effect.standardised),
          .bend = with_change(effect.bend),
          .clear = effect.change_clear || effect.bend_clear,
          .correlation = effect.correlation,
          .says = sentence(effect, fit, metric, variable)};
}

MetricResponse metric_response(const study::LoadedStudy& study, const std::string& metric) {
  const ResponseFit fit = fit_metric(study, metric);
  const auto fitted = [&](double value) {
    return fit.model == ResponseModel::none ? std::nullopt : std::optional(value);
  };
  MetricResponse result{.metric = metric,
                        .points = fit.points,
                        .model = to_string(fit.model),
                        .r2 = fitted(fit.r2),
                        .r2_left_out = fitted(fit.r2_left_out),
                        .scatter = fitted(fit.scatter),
                        .verdict = verdict(fit),
                        .variables = {}};
  for (std::size_t k = 0; k < fit.effects.size(); ++k) {
    result.variables.push_back(
        variable_response(fit.effects[k], fit, metric, study.spec.variables[k].name));
  }
  return result;
}

}  // namespace

std::vector<MetricResponse> variable_effects(const study::LoadedStudy& study) {
  const auto number_everywhere = [](const designs::Variable& variable) {
    return variable.kind != designs::VariableKind::choice && !variable.active_when;
  };
  if (!std::ranges::all_of(study.spec.variables, number_everywhere)) return {};
  std::vector<MetricResponse> list;
  for (const std::string& metric : asked_metrics(study.spec)) {
    list.push_back(metric_response(study, metric));
  }
  return list;
}

}  // namespace parapet::reports
