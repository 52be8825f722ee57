#include "parapet/study/pick_rule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace parapet::study {
namespace {

using designs::InputError;

double parse_number(const std::string& text, const char* option, const std::string& whole,
                    const char* allowed) {
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (text.empty() || error != std::errc() || rest != end || !std::isfinite(value)) {
    throw InputError({{option, "", whole, "\"" + text + "\" is not a number", allowed}});
  }
  return value;
}

std::map<std::string, double> parse_weights(const std::string& text) {
  constexpr const char* allowed =
      "OBJECTIVE=NUMBER, at least 0, with commas between, for example "
      "retention_efficiency=2,launch_length_m=1";
  std::map<std::string, double> weights;
  double sum = 0.0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string part = text.substr(begin, end - begin);
    begin = end + 1;
    const std::size_t equals = part.find('=');
    if (equals == std::string::npos || equals == 0) {
      throw InputError({{"--weights", "", part, "names no objective with a weight", allowed}});
    }
    const double weight = parse_number(part.substr(equals + 1), "--weights", part, allowed);
    if (weight < 0.0) {
      throw InputError({{"--weights", "", part, "the weight is negative", allowed}});
    }
    weights[part.substr(0, equals)] = weight;
    sum += weight;
  }
  if (!(sum > 0.0)) {
    throw InputError({{"--weights", "", text, "no objective has a weight above 0", allowed}});
  }
  return weights;
}

ObjectiveLimit parse_limit(const std::string& text) {
  constexpr const char* allowed =
      "OBJECTIVE<=NUMBER or OBJECTIVE>=NUMBER in quotes, for example \"launch_length_m<=0.1\"";
  const std::size_t place = std::min(text.find("<="), text.find(">="));
  if (place == std::string::npos || place == 0) {
    throw InputError({{"--limit", "", text, "is not a limit on an objective", allowed}});
  }
  ObjectiveLimit limit{.objective = text.substr(0, place), .lower = {}, .upper = {}};
  const double value = parse_number(text.substr(place + 2), "--limit", text, allowed);
  (text[place] == '<' ? limit.upper : limit.lower) = value;
  return limit;
}

RuleKind parse_kind(const std::string& rule, bool weights, bool limits) {
  if (rule.empty()) {
    return weights ? RuleKind::weights : limits ? RuleKind::limits : RuleKind::automatic;
  }
  if (rule == "best") return RuleKind::best;
  if (rule == "knee") return RuleKind::knee;
  if (rule == "balanced") return RuleKind::balanced;
  if (rule == "weights") return RuleKind::weights;
  if (rule == "limits") return RuleKind::limits;
  throw InputError(
      {{"--rule", "", rule, "there is no such rule", "best, knee, balanced, weights or limits"}});
}

}  // namespace

std::string to_string(RuleKind kind) {
  switch (kind) {
    case RuleKind::automatic:
      return "automatic";
    case RuleKind::best:
      return "best";
    case RuleKind::knee:
      return "knee";
    case RuleKind::weights:
      return "weights";
    case RuleKind::balanced:
      return "balanced";
    case RuleKind::limits:
      break;
  }
  return "limits";
}

PickRule parse_pick_rule(const std::string& rule, const std::string& weights,
                         const std::vector<std::string>& limits) {
  PickRule result;
  result.kind = parse_kind(rule, !weights.empty(), !limits.empty());
  const bool by_weights = result.kind == RuleKind::weights;
  const bool by_limits = result.kind == RuleKind::limits;
  if (by_weights == weights.empty()) {
    throw InputError(
        {{"--rule", "", rule, by_weights ? "the rule needs weights" : "the rule takes no weights",
          "--rule weights together with --weights"}});
  }
  if (by_limits == limits.empty()) {
    throw InputError(
        {{"--rule", "", rule, by_limits ? "the rule needs a limit" : "the rule takes no limits",
          "--rule limits together with --limit"}});
  }
  if (by_weights) result.weights = parse_weights(weights);
  for (const std::string& limit : limits) result.limits.push_back(parse_limit(limit));
  return result;
}

std::string shell_word(const std::string& text) {
  constexpr std::string_view plain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_.,:/=+%@";
  if (!text.empty() && text.find_first_not_of(plain) == std::string::npos) return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

std::string command_line(const PickRule& rule) {
  std::string text, weights;
  if (rule.kind == RuleKind::best) text = " --rule best";
  if (rule.kind == RuleKind::knee) text = " --rule knee";
  if (rule.kind == RuleKind::balanced) text = " --rule balanced";
  for (const auto& [name, weight] : rule.weights) {
    weights += fmt::format("{}{}={}", weights.empty() ? "" : ",", name, weight);
  }
  if (!weights.empty()) text += " --rule weights --weights " + shell_word(weights);
  for (const ObjectiveLimit& limit : rule.limits) {
    text += text.empty() ? " --rule limits" : "";
    text += " --limit " + shell_word(limit.upper
                                         ? fmt::format("{}<={}", limit.objective, *limit.upper)
                                         : fmt::format("{}>={}", limit.objective, *limit.lower));
  }
  return text;
}

}  // namespace parapet::study
