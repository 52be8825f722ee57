#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "key_text.hpp"
#include "markdown.hpp"
#include "recommendation_parts.hpp"

namespace parapet::reports {
namespace {

using designs::Json;

bool any_estimate(const Json& front) {
  return std::ranges::any_of(front, [](const Json& design) {
    return std::ranges::any_of(design["objectives"], [](const Json& objective) {
      return objective["estimate"].is_number();
    });
  });
}

std::string share_text(const Json& probability) {
  const auto value = value_of(probability);
  return value ? fmt::format("{:.0f} %", 100.0 * *value) : "-";
}

std::string front_table(const Json& json) {
  const Json& front = json["front"];
  const bool estimates = any_estimate(front);
  const bool limits = json["rule"]["name"] == "limits" && estimates;
  std::vector<std::string> heading{"design"};
  for (const Json& objective : front[0]["objectives"]) {
    heading.push_back(objective_label(objective));
    if (estimates && !objective.contains("expression")) heading.push_back("surrogate (95 %)");
  }
  if (estimates) heading.push_back("meets the constraints");
  if (limits) heading.push_back("meets the limits");
  for (const Json& variable : json["study"]["variables"]) {
    heading.push_back(key_label(text_of(variable["name"])));
  }
  std::vector<std::vector<std::string>> rows{heading};
  const std::string chosen = json["feasible"].get<bool>() ? text_of(json["recommended"]["id"]) : "";
  for (const Json& design : front) {
    const std::string id = text_of(design["id"]);
    std::vector<std::string> row{id == chosen ? fmt::format("**{}** (recommended)", id) : id};
    for (const Json& objective : design["objectives"]) {
      row.push_back(number_text(value_of(objective["value"])));
      if (estimates && !objective.contains("expression")) row.push_back(estimate_text(objective));
    }
    if (estimates) row.push_back(share_text(design["probability_feasible"]));
    if (limits) row.push_back(share_text(design["probability_limits"]));
    for (const Json& variable : json["study"]["variables"]) {
      const Json& values = design["design"];
      const std::string name = text_of(variable["name"]);
      if (!values.contains(name)) {
        row.push_back("");
      } else {
        row.push_back(values[name].is_string() ? text_of(values[name])
                                               : number_text(value_of(values[name])));
      }
    }
    rows.push_back(std::move(row));
  }
  std::string alignment(heading.size(), 'r');
  alignment.front() = 'l';
  return table(rows, alignment);
}

/// "retention efficiency +0.02, launch length +0.1 m (worse)".
std::string change_words(const Json& objectives, const Json& changes) {
  std::vector<std::string> words;
  for (std::size_t j = 0; j < changes.size(); ++j) {
    const Json& objective = objectives[j];
    const double change = changes[j].get<double>();
    const bool better = (change > 0.0) == (text_of(objective["goal"]) == "maximize");
    words.push_back(fmt::format("{} {}{}{}", objective_name(objective), change > 0.0 ? "+" : "",
                                objective_value(objective, change),
                                change == 0.0 ? ""
                                : better      ? " (better)"
                                              : " (worse)"));
  }
  return joined(words);
}

std::string leaving_text(const Json& json) {
  const Json& leaving = json["leaving"];
  if (leaving.empty()) return "";
  std::string text = fmt::format("What it costs to leave design {}, as observed:\n\n",
                                 text_of(json["recommended"]["id"]));
  const Json& objectives = json["recommended"]["objectives"];
  for (const Json& way : leaving) {
    const Json& objective = objectives[way["objective"].get<std::size_t>()];
    text +=
        fmt::format("- for a better {}: to design {}, {}", objective_name(objective),
                    text_of(way["next"]["id"]), change_words(objectives, way["next"]["changes"]));
    if (way["best"]["id"] != way["next"]["id"]) {
      text += fmt::format("; at most to design {}, {}", text_of(way["best"]["id"]),
                          change_words(objectives, way["best"]["changes"]));
    }
    text += "\n";
  }
  return text + "\n";
}

std::string pictures(const Json& json) {
  if (json["front"].size() < 2) return "";
  std::string text = "![The front](front.png)\n\n";
  const std::size_t n = json["front"][0]["objectives"].size();
  for (std::size_t a = 1; a <= n; ++a) {
    for (std::size_t b = a + 1; b <= n; ++b) {
      if (a == 1 && b == 2) continue;
      text += fmt::format("![The front, objectives {0} and {1}](front-{0}-{1}.png)\n\n", a, b);
    }
  }
  const Json& volume = json["hypervolume"];
  if (volume.is_object() && !volume["history"].empty()) {
    text +=
        "The dominated hypervolume (how much of the objectives' space, up to a reference "
        "point, the front betters) grew with the search as below; while it still grows, the "
        "front is not final.\n\n![The search's progress](hypervolume.png)\n\n";
  }
  return text;
}

}  // namespace

std::string front_section(const Json& json) {
  const Json& front = json["front"];
  if (front.empty()) return "";
  std::string text = fmt::format(
      "## The trade-off\n\n{} evaluated design{} that meet{} every constraint {} bettered by no "
      "other such design in every objective: the front. Values are as simulated",
      front.size(), front.size() == 1 ? "" : "s", front.size() == 1 ? "s" : "",
      front.size() == 1 ? "is" : "are");
  text += any_estimate(front)
              ? "; the surrogate's estimate is its median with a 95 % interval of the noise-free "
                "value, which uses all designs and is the better guide where runs scatter.\n\n"
              : "; there is no surrogate for this study, so nothing is known of how sure they "
                "are.\n\n";
  return text + front_table(json) + leaving_text(json) + pictures(json);
}

}  // namespace parapet::reports
