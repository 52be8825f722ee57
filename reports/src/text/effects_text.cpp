#include "effects_text.hpp"

#include <fmt/format.h>

#include "key_text.hpp"
#include "markdown.hpp"

namespace parapet::reports {
namespace {

std::string fit_words(const MetricResponse& fit) {
  if (!fit.r2) return fmt::format("{} designs with a value; {}.\n\n", fit.points, fit.verdict);
  return fmt::format(
      "Model: {}; {} designs, R² {:.2f} ({:.2f} for designs left out of the fit), "
      "residuals of {} (what the fit leaves, not the scatter of runs): {}.\n\n",
      fit.model, fit.points, *fit.r2, fit.r2_left_out.value(), with_unit(fit.scatter, fit.metric),
      fit.verdict);
}

}  // namespace

std::string effects_section(const Recommendation& advice) {
  const std::vector<MetricResponse>& effects = advice.effects;
  if (effects.empty()) return "";
  std::string text = fmt::format(
      "## What each variable does\n\nLeast-squares fits to the designs simulated at {:.4g} mm; "
      "they "
      "describe the region that was tried, not what lies beyond. ± is one standard "
      "error; the standardised effect is in standard deviations. Correlations look at one variable "
      "alone and mislead where variables were changed together.\n\n",
      1000.0 * advice.study.counted_spacing);
  for (const MetricResponse& fit : effects) {
    text += fmt::format("### {}\n\n", key_label(fit.metric)) + fit_words(fit);
    std::vector<std::vector<std::string>> rows{
        {"variable", "effect", "standardised", "correlation"}};
    for (const VariableResponse& one : fit.variables) {
      rows.push_back({key_words(one.variable), one.says, number_text(one.standardised),
                      number_text(one.correlation)});
    }
    if (rows.size() > 1) text += table(rows, "llrr");
  }
  return text;
}

}  // namespace parapet::reports
