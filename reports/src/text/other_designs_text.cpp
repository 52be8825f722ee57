#include "other_designs_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "design_text.hpp"
#include "key_text.hpp"
#include "markdown.hpp"

namespace parapet::reports {
namespace {

/// The constraint margin that is the smallest share of its limit.
std::optional<double> smallest_margin(const DesignReport& design) {
  std::optional<double> smallest;
  for (const ConstraintResult& constraint : design.constraints) {
    const std::optional<double>& margin = constraint.margin_percent;
    if (margin && (!smallest || *margin < *smallest)) smallest = margin;
  }
  return smallest;
}

}  // namespace

std::string improvement_section(const std::optional<Improvement>& improvement) {
  if (!improvement) return "";
  std::string text = "## Against the starting designs\n\n";
  if (improvement->same_design) {
    return text +
           "The search found nothing better than the best starting design, which is the one "
           "recommended.\n\n";
  }
  text += fmt::format("The best starting design was {} ({}), {}.\n\n", improvement->start_id,
                      design_words(improvement->start_design),
                      improvement->start_feasible
                          ? "which meets the constraints"
                          : "which does not meet the constraints; no starting design did");
  std::vector<std::vector<std::string>> rows{
      {"objective", "start", "recommended", "change", "in per cent", ""}};
  for (const ObjectiveChange& objective : improvement->objectives) {
    rows.push_back({key_words(objective.name) + bracketed_unit(objective.of),
                    number_text(objective.start), number_text(objective.best),
                    signed_text(objective.change), percent_text(objective.change_percent),
                    !objective.better   ? ""
                    : *objective.better ? "better"
                                        : "not better"});
  }
  return text + table(rows, "lrrrrl");
}

std::string alternatives_section(const Recommendation& advice) {
  if (!advice.recommended || !advice.front.empty()) return "";
  if (advice.alternatives.empty()) {
    return "## Alternatives\n\nNo other feasible design differs from it by 5 % of a variable's "
           "range.\n\n";
  }
  const DesignReport& best = advice.recommended->design;
  const std::vector<designs::Variable>& variables = advice.study.spec.variables;
  std::vector<std::string> heading{"design"};
  for (const designs::Variable& one : variables) heading.push_back(key_label(one.name));
  for (const ObjectiveTerms& one : advice.study.objectives) heading.push_back(objective_label(one));
  heading.push_back("smallest margin");
  std::vector<std::vector<std::string>> rows{heading};
  const auto add = [&](const DesignReport& design, const std::string& name) {
    std::vector<std::string> row{name};
    for (const designs::Variable& one : variables) {
      row.push_back(variable_cell(design.design, one.name));
    }
    for (const ObjectiveResult& one : design.objectives) row.push_back(number_text(one.value));
    row.push_back(percent_text(smallest_margin(design)));
    rows.push_back(std::move(row));
  };
  add(best, fmt::format("**{}** (recommended)", best.id));
  std::vector<std::string> ties;
  for (const Alternative& alternative : advice.alternatives) {
    add(alternative.design, alternative.design.id);
    if (alternative.within_scatter.value_or(false)) ties.push_back(alternative.design.id);
  }
  const std::string note = ties.empty() ? ""
                                        : fmt::format(
                                              "Within the scatter, the data cannot rank {} "
                                              "against the recommended design.\n\n",
                                              joined(ties));
  std::string alignment(heading.size(), 'r');
  alignment.front() = 'l';
  return "## Alternatives\n\nThe best other feasible designs, each at least 5 % of a variable's "
         "range "
         "from the others. The smallest margin is a share of its limit.\n\n" +
         table(rows, alignment) + note;
}

}  // namespace parapet::reports
