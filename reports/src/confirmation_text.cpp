#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "key_text.hpp"
#include "markdown.hpp"
#include "parapet/study/confirmation.hpp"
#include "recommendation_parts.hpp"

namespace parapet::reports {
namespace {

using designs::Json;

std::string probability_text(const Json& best, const Json& rule) {
  const auto probability = value_of(best["probability_feasible"]);
  if (!probability) {
    return "There is no surrogate's probability that it meets the constraints; it did when it was "
           "simulated.";
  }
  std::string text = fmt::format(
      "As simulated it meets every constraint; the surrogate, which has seen all designs, gives a "
      "probability of {:.0f} % that it does.",
      100.0 * *probability);
  if (rule["all_doubtful"].get<bool>()) {
    text += " **No design that the rule allows reaches 50 %**: each may owe its place to luck.";
  }
  if (const auto limits = value_of(best["probability_limits"])) {
    text += fmt::format(
        " That it meets the rule's limits on objectives has a probability of {:.0f} % (objectives "
        "taken as independent).",
        100.0 * *limits);
  }
  return text;
}

std::string estimates_table(const Json& best) {
  std::vector<std::vector<std::string>> rows{
      {"objective", "simulated", "surrogate (95 % interval)", "simulated value is"}};
  bool any = false;
  for (const Json& objective : best["estimates"]) {
    const auto value = value_of(objective["value"]), lower = value_of(objective["lower_95"]),
               upper = value_of(objective["upper_95"]);
    if (objective.contains("expression")) continue;  // a formula, known exactly
    any = any || lower;
    const char* place = !lower || !upper || !value             ? "-"
                        : *value >= *lower && *value <= *upper ? "within the interval"
                                                               : "outside: scatter, or a bad model";
    rows.push_back(
        {objective_label(objective), number_text(value), estimate_text(objective), place});
  }
  return any ? table(rows, "lrrl") : "";
}

std::string run_name(const Json& run) {
  const std::string stage = text_of(run["stage"]);
  const std::string spacing =
      run["spacing_m"].is_number()
          ? fmt::format("{:.4g} mm", 1000.0 * run["spacing_m"].get<double>())
          : "?";
  if (stage == study::confirmation_stage::near) return fmt::format("near it, at {}", spacing);
  return fmt::format("the design itself, at {}", spacing);
}

std::string runs_table(const Json& json) {
  std::vector<std::vector<std::string>> rows{{"run", "what"}};
  std::string alignment = "ll";
  for (const Json& objective : json["recommended"]["objectives"]) {
    rows[0].push_back(objective_label(objective));
    alignment += 'r';
  }
  rows[0].push_back("constraints");
  alignment += 'l';
  const auto add = [&](const std::string& id, const std::string& what, const Json& values,
                       const std::string& state) {
    std::vector<std::string> row{id, what};
    for (std::size_t j = 0; j + 3 < rows[0].size(); ++j) {
      row.push_back(j < values.size() ? number_text(value_of(values[j])) : "-");
    }
    row.push_back(state);
    rows.push_back(std::move(row));
  };
  Json own = Json::array();
  for (const Json& objective : json["recommended"]["objectives"]) own.push_back(objective["value"]);
  add(text_of(json["recommended"]["id"]), "the study's own run", own, "all hold");
  for (const Json& run : json["confirmation"]["runs"]) {
    std::vector<std::string> violated;
    for (const Json& name : run["violated"]) violated.push_back(text_of(name));
    add(text_of(run["id"]), run_name(run), run["objectives"],
        !run["ok"].get<bool>() ? "failed: " + text_of(run["reason"])
        : violated.empty()     ? "all hold"
                               : "**violated**: " + joined(violated));
  }
  return table(rows, alignment);
}

/// What is rounding alone counts as none.
std::string deviation_text(const Json& spread) {
  const double deviation = spread["standard_deviation"].get<double>();
  const double size =
      std::max(std::abs(spread["least"].get<double>()), std::abs(spread["greatest"].get<double>()));
  return deviation <= 1e-12 * size ? "0" : fmt::format("{:.2g}", deviation);
}

std::string spread_text(const Json& spread) {
  if (spread.empty()) return "";
  std::vector<std::vector<std::string>> rows{{"quantity", "runs", "least", "greatest", "s.d."}};
  for (const Json& one : spread) {
    const std::string metric = text_of(one["metric"]), name = text_of(one["name"]);
    rows.push_back({fmt::format("{}{}", key_words(name), bracketed_unit(metric)),
                    std::to_string(one["runs"].get<int>()), number_text(value_of(one["least"])),
                    number_text(value_of(one["greatest"])), deviation_text(one)});
  }
  return "The design and those near it differ by half a per cent of each variable's range, which "
         "no site work could tell apart: what lies between them is the scatter of the answer, and "
         "a difference between designs that is not larger means nothing.\n\n" +
         table(rows, "lrrrr");
}

std::string refuted_text(const Json& confirmation) {
  std::string text;
  for (const Json& one : confirmation["refuted"]) {
    std::vector<std::string> names;
    for (const Json& name : one["violated"]) names.push_back(text_of(name));
    text += fmt::format(
        "Design {}, which the rule {}, did not hold when it was simulated again{}.\n\n",
        text_of(one["id"]), confirmation["verdict"] == "refuted" ? "ranks high" : "prefers",
        names.empty() ? " (a simulation failed)" : ": " + joined(names) + " was violated");
  }
  return text;
}

/// Ids of the confirmation's runs that lie outside the rule's limits on objectives.
std::vector<std::string> runs_outside_limits(const Json& json) {
  std::vector<std::string> ids;
  const Json& objectives = json["recommended"]["objectives"];
  for (const Json& run : json["confirmation"]["runs"]) {
    bool outside = false;
    for (const Json& limit : json["rule"]["limits"]) {
      for (std::size_t j = 0; j < run["objectives"].size() && j < objectives.size(); ++j) {
        const bool meant = objectives[j]["name"] == limit["objective"] ||
                           objectives[j]["metric"] == limit["objective"];
        const auto value = value_of(run["objectives"][j]);
        if (!meant || !value) continue;
        outside = outside || *value > value_of(limit["upper"]).value_or(*value) ||
                  *value < value_of(limit["lower"]).value_or(*value);
      }
    }
    if (outside) ids.push_back(text_of(run["id"]));
  }
  return ids;
}

std::string limits_text(const Json& json) {
  const std::vector<std::string> ids = runs_outside_limits(json);
  if (ids.empty()) return "";
  return fmt::format(
      "**The rule's limits on objectives do not hold in every run**: {} lie{} outside. They chose "
      "the design and are no constraints of the study, so this does not refute it.\n\n",
      joined(ids), ids.size() == 1 ? "s" : "");
}

std::string verdict_text(const Json& json) {
  const std::string verdict = text_of(json["confirmation"]["verdict"]);
  if (verdict == "none") {
    return "It was not simulated again: how much the answer scatters is not known. Run `parapet "
           "recommend` without --no-confirm.\n\n";
  }
  if (verdict == "refuted") {
    return fmt::format(
        "**Not confirmed.** The {} design{} tried did not hold when simulated again. The one shown "
        "is the rule's first choice; it should not be built on this evidence. Tighter limits in "
        "the spec, or more evaluations, leave a margin for the scatter.\n\n",
        json["confirmation"]["refuted"].size(),
        json["confirmation"]["refuted"].size() == 1 ? "" : "s");
  }
  int broken = 0;
  for (const Json& run : json["confirmation"]["runs"])
    broken += run["feasible"].get<bool>() ? 0 : 1;
  if (broken == 0) {
    return "**Confirmed**: every constraint holds in every run of the design and near it.\n\n";
  }
  return fmt::format(
      "**Confirmed, narrowly**: {} of the {} runs near the design broke a constraint. It lies so "
      "close to a limit that the scatter decides.\n\n",
      broken, json["confirmation"]["runs"].size());
}

}  // namespace

std::string confirmation_section(const Json& json) {
  if (!json["feasible"].get<bool>()) return "";
  std::string text =
      "## How sure\n\n" + probability_text(json["recommended"], json["rule"]) + "\n\n";
  text += estimates_table(json["recommended"]);
  text += refuted_text(json["confirmation"]) + verdict_text(json) + limits_text(json);
  if (!json["confirmation"]["runs"].empty()) {
    text += runs_table(json) + spread_text(json["confirmation"]["spread"]);
  }
  return text;
}

}  // namespace parapet::reports
