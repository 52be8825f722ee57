/// Texts of the keys of metrics and variables, whose suffix is their unit, and of their numbers.
#pragma once

#include <optional>
#include <string>

namespace parapet::reports {

/// "launch length" for "launch_length_m".
std::string key_words(const std::string& key);

/// "launch length [m]"; without brackets for a pure number.
std::string key_label(const std::string& key);

/// " [m]"; empty for a pure number.
std::string bracketed_unit(const std::string& key);

/// The key whose suffix is the unit of an objective, a constraint or what is expected of one: its
/// metric, or the name of an expression.
template <typename Goal>
const std::string& unit_key(const Goal& goal) {
  return goal.metric.empty() ? goal.name : goal.metric;
}

/// Four significant digits, never 1e+03 for a thousand; "-" when there is no value.
std::string number_text(const std::optional<double>& value);

/// A number with the unit of its key: "0.25 m", "45°".
std::string with_unit(const std::optional<double>& value, const std::string& key);

}  // namespace parapet::reports
