#include "safe_advice.hpp"

#include <utility>

#include "markdown.hpp"
#include "parapet/designs/text.hpp"

namespace parapet::reports {
namespace {

void escape(std::string& text) {
  text = markdown_text(text);
}

void escape(std::vector<std::string>& texts) {
  for (std::string& text : texts) escape(text);
}

void escape(WrittenDesign& design) {
  for (WrittenVariable& variable : design) {
    escape(variable.name);
    if (auto* option = std::get_if<std::string>(&variable.value)) escape(*option);
  }
}

/// A formula stands between backticks, also where it is its own name.
void escape(ObjectiveTerms& terms) {
  const bool bare = !terms.expression.empty() && terms.expression == terms.name;
  terms.name = bare ? code_text(terms.name) : markdown_text(terms.name);
  terms.expression = code_text(terms.expression);
  escape(terms.metric);
  escape(terms.statistic);
}

void escape(ConstraintResult& constraint) {
  escape(constraint.name);
  escape(constraint.metric);
  escape(constraint.statistic);
  constraint.expression = code_text(constraint.expression);
}

void escape(VariableResult& variable) {
  escape(variable.name);
  escape(variable.option);
  escape(variable.options);
}

void escape(DesignReport& design) {
  escape(design.id);
  escape(design.stage);
  escape(design.design);
  escape(design.scenarios);
  for (VariableResult& variable : design.variables) escape(variable);
  for (ObjectiveResult& objective : design.objectives) escape(objective.terms);
  for (ConstraintResult& constraint : design.constraints) escape(constraint);
  for (solver::Metric& metric : design.metrics) {
    escape(metric.key);
    escape(metric.absent_reason);
  }
}

void escape(designs::StudySpec& spec) {
  escape(spec.name);
  escape(spec.method.algorithm);
  for (designs::Variable& variable : spec.variables) {
    escape(variable.name);
    for (designs::Option& option : variable.options) escape(option.name);
  }
  for (designs::Constraint& constraint : spec.constraints) {
    escape(constraint.name);
    escape(constraint.metric);
    constraint.expression = code_text(constraint.expression);
  }
  for (designs::Scenario& scenario : spec.scenarios) escape(scenario.name);
}

void escape(Confirmation& confirmation) {
  for (ConfirmingRun& run : confirmation.runs) {
    escape(run.id);
    escape(run.reason);
    escape(run.violated);
    escape(run.worse);
  }
  for (Spread& spread : confirmation.spread) {
    escape(spread.name);
    escape(spread.metric);
  }
  for (RefutedDesign& one : confirmation.refuted) {
    escape(one.id);
    escape(one.violated);
    escape(one.worse);
  }
}

void escape(FrontDesign& design) {
  escape(design.id);
  escape(design.design);
  for (ObjectiveEstimate& objective : design.objectives) escape(objective.terms);
}

void escape(Improvement& improvement) {
  escape(improvement.start_id);
  escape(improvement.start_design);
  for (ObjectiveChange& objective : improvement.objectives) {
    escape(objective.name);
    escape(objective.of);
  }
}

void escape(MetricResponse& response) {
  escape(response.metric);
  escape(response.model);
  escape(response.verdict);
  for (VariableResponse& variable : response.variables) {
    escape(variable.variable);
    escape(variable.says);
  }
}

void escape(study::Sensitivity& sensitivity) {
  escape(sensitivity.domain);
  escape(sensitivity.source);
  for (study::MetricSensitivity& metric : sensitivity.metrics) {
    escape(metric.name);
    escape(metric.metric);
    escape(metric.statistic);
    for (study::VariableSensitivity& variable : metric.variables) {
      escape(variable.name);
      for (study::VariablePlace& place : variable.main_effect.at) {
        if (auto* option = std::get_if<std::string>(&place)) escape(*option);
      }
    }
  }
}

void escape(Reproduction& reproduce) {
  for (std::string* command : {&reproduce.evaluate, &reproduce.optimize, &reproduce.recommend}) {
    *command = designs::visible_text(*command);  // between fences, on lines of their own
  }
  escape(reproduce.spec);
  reproduce.spec_hash = code_text(reproduce.spec_hash);
}

}  // namespace

Recommendation safe_for_markdown(Recommendation advice) {
  escape(advice.study.folder);
  escape(advice.study.spec);
  for (ObjectiveTerms& terms : advice.study.objectives) escape(terms);
  escape(advice.rule.words);
  escape(advice.rule.first_by_rule);
  for (TiedDesign& tied : advice.rule.ties) escape(tied.id);
  for (study::ObjectiveLimit& limit : advice.rule.limits) escape(limit.objective);
  if (advice.recommended) {
    escape(advice.recommended->design);
    for (study::Expectation& one : advice.recommended->repeat) {
      escape(one.name);
      escape(one.metric);
    }
    for (ObjectiveEstimate& objective : advice.recommended->estimates) escape(objective.terms);
  }
  if (advice.confirmation) escape(*advice.confirmation);
  if (advice.least_violating) escape(advice.least_violating->design);
  for (FrontDesign& design : advice.front) escape(design);
  for (WayOut& way : advice.leaving) {
    escape(way.next.id);
    escape(way.best.id);
  }
  if (advice.improvement) escape(*advice.improvement);
  for (Alternative& alternative : advice.alternatives) escape(alternative.design);
  for (MetricResponse& response : advice.effects) escape(response);
  if (advice.sensitivity) escape(*advice.sensitivity);
  for (FailedDesign& design : advice.failed) {
    escape(design.id);
    escape(design.reason);
  }
  escape(advice.caveats);
  if (advice.reproduce) escape(*advice.reproduce);
  return advice;
}

}  // namespace parapet::reports
