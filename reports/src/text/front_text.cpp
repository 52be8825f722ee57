#include "front_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "design_text.hpp"
#include "key_text.hpp"
#include "markdown.hpp"

namespace parapet::reports {
namespace {

bool any_estimate(const std::vector<FrontDesign>& front) {
  return std::ranges::any_of(front, [](const FrontDesign& design) {
    return std::ranges::any_of(design.objectives, [](const ObjectiveEstimate& objective) {
      return objective.estimate.median.has_value();
    });
  });
}

std::string share_text(const std::optional<double>& probability) {
  return probability ? fmt::format("{:.0f} %", 100.0 * *probability) : "-";
}

std::string front_table(const Recommendation& advice) {
  const std::vector<FrontDesign>& front = advice.front;
  const bool estimates = any_estimate(front);
  const bool limits = advice.rule.kind == study::RuleKind::limits && estimates;
  const auto estimated = [&](const ObjectiveEstimate& objective) {
    return estimates && objective.terms.expression.empty();
  };
  std::vector<std::string> heading{"design"};
  for (const ObjectiveEstimate& objective : front.front().objectives) {
    heading.push_back(objective_label(objective.terms));
    if (estimated(objective)) heading.push_back("surrogate (95 %)");
  }
  if (estimates) heading.push_back("a repeat meets the constraints");
  if (limits) heading.push_back("meets the limits");
  for (const designs::Variable& variable : advice.study.spec.variables) {
    heading.push_back(key_label(variable.name));
  }
  std::vector<std::vector<std::string>> rows{heading};
  const std::string chosen = advice.recommended ? advice.recommended->design.id : "";
  for (const FrontDesign& design : front) {
    std::vector<std::string> row{
        design.id == chosen ? fmt::format("**{}** (recommended)", design.id) : design.id};
    for (const ObjectiveEstimate& objective : design.objectives) {
      row.push_back(number_text(objective.value));
      if (estimated(objective)) row.push_back(estimate_text(objective.estimate));
    }
    if (estimates) row.push_back(share_text(design.probability_feasible));
    if (limits) row.push_back(share_text(design.probability_limits));
    for (const designs::Variable& variable : advice.study.spec.variables) {
      row.push_back(variable_cell(design.design, variable.name));
    }
    rows.push_back(std::move(row));
  }
  std::string alignment(heading.size(), 'r');
  alignment.front() = 'l';
  return table(rows, alignment);
}

/// "retention efficiency +0.02, launch length +0.1 m (worse)".
std::string change_words(const std::vector<ObjectiveTerms>& objectives,
                         const std::vector<double>& changes) {
  std::vector<std::string> words;
  for (std::size_t j = 0; j < changes.size(); ++j) {
    const double change = changes[j];
    const bool better = (change > 0.0) == (objectives[j].goal == designs::Goal::maximize);
    words.push_back(fmt::format("{} {}{}{}", objective_name(objectives[j]), change > 0.0 ? "+" : "",
                                objective_value(objectives[j], change),
                                change == 0.0 ? ""
                                : better      ? " (better)"
                                              : " (worse)"));
  }
  return joined(words);
}

std::string leaving_text(const Recommendation& advice) {
  if (advice.leaving.empty()) return "";
  std::string text = fmt::format("What it costs to leave design {}, as observed:\n\n",
                                 advice.recommended->design.id);
  const std::vector<ObjectiveTerms>& objectives = advice.study.objectives;
  for (const WayOut& way : advice.leaving) {
    text += fmt::format("- for a better {}: to design {}, {}",
                        objective_name(objectives[way.objective]), way.next.id,
                        change_words(objectives, way.next.changes));
    if (way.best.id != way.next.id) {
      text += fmt::format("; at most to design {}, {}", way.best.id,
                          change_words(objectives, way.best.changes));
    }
    text += "\n";
  }
  return text + "\n";
}

std::string pictures(const Recommendation& advice) {
  if (advice.front.size() < 2) return "";
  std::string text = "![The front](front.png)\n\n";
  const std::size_t n = advice.study.objectives.size();
  for (std::size_t a = 1; a <= n; ++a) {
    for (std::size_t b = a + 1; b <= n; ++b) {
      if (a == 1 && b == 2) continue;
      text += fmt::format("![The front, objectives {0} and {1}](front-{0}-{1}.png)\n\n", a, b);
    }
  }
  if (advice.progress && !advice.progress->history.empty()) {
    text +=
        "The dominated hypervolume (how much of the objectives' space, up to a reference "
        "point, the front dominates) grew with the search as below; while it still grows, the "
        "front is not final.\n\n![The search's progress](hypervolume.png)\n\n";
  }
  return text;
}

}  // namespace

std::string front_section(const Recommendation& advice) {
  const std::vector<FrontDesign>& front = advice.front;
  if (front.empty()) return "";
  std::string text = fmt::format(
      "## The trade-off\n\n{} evaluated design{} that meet{} every constraint {} dominated by no "
      "other such design (at least as good in every objective and better in one): the front. "
      "Values are as simulated.",
      front.size(), front.size() == 1 ? "" : "s", front.size() == 1 ? "s" : "",
      front.size() == 1 ? "is" : "are");
  text += any_estimate(front)
              ? " The surrogate's estimate is its median with a 95 % interval of the noise-free "
                "value; it uses all designs and is the better guide where runs scatter.\n\n"
              : " This study has no surrogate, so their uncertainty is not known.\n\n";
  return text + front_table(advice) + leaving_text(advice) + pictures(advice);
}

}  // namespace parapet::reports
