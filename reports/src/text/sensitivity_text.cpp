#include "sensitivity_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "effects.hpp"
#include "key_text.hpp"
#include "markdown.hpp"

namespace parapet::reports {
namespace {

using study::MetricSensitivity;
using study::VariableSensitivity;

/// A metric's name, unit and statistic.
std::string metric_label(const MetricSensitivity& metric) {
  const std::string label = key_label(metric.metric);
  return metric.statistic.empty() ? label : label + ", " + metric.statistic;
}

std::string index_text(const study::SobolIndex& index) {
  return fmt::format("{:.2f} ({:.2f} to {:.2f})", index.value, index.lower_95, index.upper_95);
}

/// The two ends, the lowest and the highest place, each once, in their order.
std::vector<std::size_t> telling_places(const std::vector<double>& mean) {
  const std::size_t last = mean.size() - 1;
  const auto low = static_cast<std::size_t>(std::ranges::min_element(mean) - mean.begin());
  const auto high = static_cast<std::size_t>(std::ranges::max_element(mean) - mean.begin());
  std::vector<std::size_t> shown{0};
  for (const std::size_t k : {std::min(low, high), std::max(low, high), last}) {
    if (k > shown.back()) shown.push_back(k);
  }
  return shown;
}

/// What the average does along one variable: "0.61 at 0°, 0.78 at 60°".
std::string effect_text(const VariableSensitivity& variable, const std::string& metric) {
  const study::MainEffect& effect = variable.main_effect;
  if (effect.at.empty()) return "";
  const auto value = [&](std::size_t k) {
    return std::isfinite(effect.mean[k]) ? fmt::format("{:.3g}", effect.mean[k]) : "-";
  };
  std::vector<std::string> words;
  if (std::holds_alternative<std::string>(effect.at.front())) {
    for (std::size_t k = 0; k < effect.at.size(); ++k) {
      words.push_back(value(k) + " with " + std::get<std::string>(effect.at[k]));
    }
  } else {
    for (const std::size_t k : telling_places(effect.mean)) {
      words.push_back(value(k) + " at " + with_unit(std::get<double>(effect.at[k]), variable.name));
    }
  }
  return joined(words) + bracketed_unit(metric);
}

std::string trust_text(const MetricSensitivity& metric, const std::string& spacings) {
  if (!metric.q_squared) return "";
  const char* verdict = *metric.q_squared >= trusted_r2 ? "it predicts designs left out of it well"
                        : *metric.q_squared >= rough_r2
                            ? "it predicts designs left out of it only roughly"
                            : "**it does not predict designs left out of it: the table says "
                              "little**";
  return fmt::format("Surrogate of {} runs{}, Q² {:.2f}: {}.\n\n", metric.designs, spacings,
                     *metric.q_squared, verdict);
}

std::string metric_text(const MetricSensitivity& metric, const std::string& spacings) {
  std::string text = "### " + metric_label(metric) + "\n\n" + trust_text(metric, spacings);
  if (!metric.varies) return text + "It does not vary over the box.\n\n";
  std::vector<const VariableSensitivity*> order;
  for (const VariableSensitivity& variable : metric.variables) order.push_back(&variable);
  std::ranges::stable_sort(order, [](const VariableSensitivity* a, const VariableSensitivity* b) {
    return a->total.value > b->total.value;
  });
  std::vector<std::vector<std::string>> rows{
      {"variable", "alone", "with interactions", "average over all else"}};
  for (const VariableSensitivity* variable : order) {
    rows.push_back({key_words(variable->name), index_text(variable->first),
                    index_text(variable->total), effect_text(*variable, metric.metric)});
  }
  return text + table(rows, "lrrl");
}

}  // namespace

std::string sensitivity_section(const Recommendation& advice) {
  const std::optional<study::Sensitivity>& sensitivity = advice.sensitivity;
  if (!sensitivity || sensitivity->metrics.empty()) return "";
  std::string text =
      "## Which variables matter\n\nSobol' indices by the surrogate: the share of a quantity's "
      "variance that a variable explains alone, and with all its interactions, when all variables "
      "are drawn independently and uniformly from the whole box of their bounds (designs that a "
      "formula forbids included; every option equally likely; a variable that does not exist under "
      "an option counts only where it does). In brackets: 95 % intervals, which "
      "cover the sampling and the surrogate's own uncertainty.\n\n";
  const std::string spacings = advice.study.spacings.size() > 1 ? " at all spacings together" : "";
  for (const MetricSensitivity& metric : sensitivity->metrics)
    text += metric_text(metric, spacings);
  return text;
}

}  // namespace parapet::reports
