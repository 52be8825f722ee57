#include <fmt/format.h>

#include <algorithm>

#include "key_text.hpp"
#include "markdown.hpp"
#include "recommendation_parts.hpp"

namespace parapet::reports {
namespace {

using designs::Json;

/// A metric's name, unit and statistic as sensitivity.json has them.
std::string metric_label(const Json& metric) {
  std::string label = key_label(text_of(metric["metric"]));
  const std::string statistic = metric.contains("statistic") ? text_of(metric["statistic"]) : "";
  return statistic.empty() ? label : label + ", " + statistic;
}

std::string index_text(const Json& index) {
  return fmt::format("{:.2f} ({:.2f} to {:.2f})", index["value"].get<double>(),
                     index["lower_95"].get<double>(), index["upper_95"].get<double>());
}

/// What the average does along one variable: "0.61 at 0°, 0.78 at 60°".
std::string effect_text(const Json& variable, const std::string& metric) {
  const Json& effect = variable["main_effect"];
  const Json& at = effect["at"];
  const Json& mean = effect["mean"];
  if (at.empty()) return "";
  const std::string name = text_of(variable["name"]);
  const auto place = [&](std::size_t k) {
    return at[k].is_string() ? text_of(at[k]) : with_unit(value_of(at[k]), name);
  };
  const auto value = [&](std::size_t k) {
    const auto number = value_of(mean[k]);
    return number ? fmt::format("{:.3g}", *number) : "-";
  };
  std::vector<std::string> words;
  if (at[0].is_string()) {
    for (std::size_t k = 0; k < at.size(); ++k) words.push_back(value(k) + " with " + place(k));
  } else {
    const std::size_t last = at.size() - 1;
    std::size_t low = 0, high = 0;
    for (std::size_t k = 1; k <= last; ++k) {
      if (mean[k] < mean[low]) low = k;
      if (mean[k] > mean[high]) high = k;
    }
    std::vector<std::size_t> shown{0};
    for (const std::size_t k : {std::min(low, high), std::max(low, high), last}) {
      if (k > shown.back()) shown.push_back(k);
    }
    for (const std::size_t k : shown) words.push_back(value(k) + " at " + place(k));
  }
  return joined(words) + bracketed_unit(metric);
}

std::string trust_text(const Json& metric) {
  const auto q_squared = value_of(metric["q_squared"]);
  if (!q_squared) return "";
  const char* verdict = *q_squared >= trusted_r2 ? "it predicts designs left out of it well"
                        : *q_squared >= rough_r2
                            ? "it predicts designs left out of it only roughly"
                            : "**it does not predict designs left out of it: the table says "
                              "little**";
  return fmt::format("Surrogate of {} designs, Q² {:.2f}: {}.\n\n", metric["designs"].get<int>(),
                     *q_squared, verdict);
}

std::string metric_text(const Json& metric) {
  std::string text = "### " + metric_label(metric) + "\n\n" + trust_text(metric);
  if (!metric["varies"].get<bool>()) return text + "It does not vary over the box.\n\n";
  std::vector<const Json*> order;
  for (const Json& variable : metric["variables"]) order.push_back(&variable);
  std::ranges::stable_sort(order, [](const Json* a, const Json* b) {
    return (*a)["total"]["value"] > (*b)["total"]["value"];
  });
  std::vector<std::vector<std::string>> rows{
      {"variable", "alone", "with interactions", "average over all else"}};
  for (const Json* variable : order) {
    rows.push_back({key_words(text_of((*variable)["name"])), index_text((*variable)["first"]),
                    index_text((*variable)["total"]),
                    effect_text(*variable, text_of(metric["metric"]))});
  }
  return text + table(rows, "lrrl");
}

}  // namespace

std::string sensitivity_section(const Json& json) {
  const Json& sensitivity = json["sensitivity"];
  if (!sensitivity.is_object() || sensitivity["metrics"].empty()) return "";
  std::string text =
      "## Which variables matter\n\nSobol' indices by the surrogate: the share of a quantity's "
      "variance that a variable explains alone, and with all its interactions, when all variables "
      "are drawn independently and uniformly from the whole box of their bounds (designs that a "
      "formula forbids included; every option equally likely; a variable that does not exist under "
      "an option counts only where it does). In brackets 95 % intervals: they hold the sampling "
      "and what the surrogate itself does not know.\n\n";
  for (const Json& metric : sensitivity["metrics"]) text += metric_text(metric);
  return text;
}

}  // namespace parapet::reports
