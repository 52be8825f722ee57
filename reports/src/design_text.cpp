// Words for designs and objectives, which several sections share.
#include <fmt/format.h>

#include "key_text.hpp"
#include "markdown.hpp"
#include "recommendation_parts.hpp"

namespace parapet::reports {

using designs::Json;

std::string design_words(const Json& design) {
  std::vector<std::string> parts;
  for (const auto& [name, value] : design.items()) {
    parts.push_back(
        fmt::format("{} {}", key_words(name),
                    value.is_string() ? text_of(value) : with_unit(value_of(value), name)));
  }
  return joined(parts);
}

std::string objective_name(const Json& objective) {
  const std::string name = text_of(objective["name"]);
  const bool formula = objective.contains("expression") && objective["expression"] == name;
  std::string words = formula ? fmt::format("`{}`", name) : key_words(name);
  if (objective.contains("statistic")) words += ", " + text_of(objective["statistic"]);
  return words;
}

std::string objective_unit_key(const Json& objective) {
  const std::string name = text_of(objective["name"]);
  if (objective.contains("expression") && objective["expression"] == name) return "";
  return text_of(objective["metric"]);
}

std::string objective_label(const Json& objective) {
  return objective_name(objective) + bracketed_unit(objective_unit_key(objective));
}

std::string objective_value(const Json& objective, const std::optional<double>& value) {
  return with_unit(value, objective_unit_key(objective));
}

std::string estimate_text(const Json& objective) {
  const auto middle = value_of(objective["estimate"]);
  if (!middle) return "-";
  return fmt::format("{} ({} to {})", number_text(middle),
                     number_text(value_of(objective["lower_95"])),
                     number_text(value_of(objective["upper_95"])));
}

std::string constraint_label(const Json& constraint) {
  if (!constraint.contains("metric")) return text_of(constraint["name"]);
  const std::string label = key_label(text_of(constraint["metric"]));
  return constraint.contains("statistic") ? label + ", " + text_of(constraint["statistic"]) : label;
}

}  // namespace parapet::reports
