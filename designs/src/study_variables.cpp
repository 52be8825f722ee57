#include <algorithm>
#include <cmath>

#include "parapet/math/units.hpp"
#include "study_choices.hpp"
#include "study_parts.hpp"
#include "words.hpp"

namespace parapet::designs {
namespace {

std::vector<std::string> option_names(const Variable& choice) {
  std::vector<std::string> names;
  for (const Option& option : choice.options) names.push_back(option.name);
  return names;
}

/// The place of an option among its choice's; empty when there is none of that name.
std::optional<int> option_number(const Variable& choice, const std::string& name) {
  const std::vector<std::string> names = option_names(choice);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<int>(found - names.begin());
}

/// Reads one variable after the other: what each says by itself, and its condition on an earlier
/// one.
class VariableReader {
 public:
  explicit VariableReader(Findings& findings) : findings_(findings) {}

  void read(const std::string& name, const Json& json) {
    const std::string pointer = child_pointer("/variables", name);
    Variable variable;
    variable.name = name;
    variable.kind = read_kind(json, pointer);
    if (variable.kind == VariableKind::choice) {
      read_options(json, pointer, variable);
    } else {
      read_bounds(json, pointer, variable);
      variable.targets = wanted_targets(name, json, pointer);
    }
    if (json.contains("active_when")) {
      variable.active_when = read_condition(json.at("active_when"), pointer + "/active_when");
    }
    variables.push_back(std::move(variable));
  }

  std::vector<Variable> variables;

 private:
  VariableKind read_kind(const Json& json, const std::string& pointer) {
    const bool has_options = json.contains("options");
    const std::string type = json.contains("type") ? json.at("type").get<std::string>()
                             : has_options         ? "choice"
                                                   : "";
    if (has_options && type != "choice") {
      findings_.add(pointer + "/type", "stands beside options", "\"choice\", or no options");
    }
    if (!has_options && type == "choice") {
      findings_.add(pointer + "/options", "is missing", "an object of at least two options");
    }
    if (has_options || type == "choice") return VariableKind::choice;
    return type == "integer" ? VariableKind::integer : VariableKind::continuous;
  }

  void read_options(const Json& json, const std::string& pointer, Variable& variable) {
    for (const char* key : {"lower", "upper", "target", "targets"}) {
      if (!json.contains(key)) continue;
      findings_.add(child_pointer(pointer, key), "stands beside options, and a choice has none",
                    "either options, or bounds and a target");
    }
    if (!json.contains("options")) return;
    for (const auto& [name, entry] : json.at("options").items()) {
      Option option{name, entry.at("remove").get<std::vector<std::string>>(), {}};
      for (const auto& [place, value] : entry.at("set").items()) option.sets[place] = value;
      variable.options.push_back(std::move(option));
    }
    variable.upper = static_cast<double>(variable.options.size()) - 1.0;
  }

  void read_bounds(const Json& json, const std::string& pointer, Variable& variable) {
    for (const char* key : {"lower", "upper"}) {
      const std::string place = child_pointer(pointer, key);
      if (!json.contains(key)) {
        findings_.add(place, "is missing", "a number");
        return;
      }
      const double bound = json.at(key).get<double>();
      if (variable.kind == VariableKind::integer && std::floor(bound) != bound) {
        findings_.add(place, "is not a whole number", "a whole number, or the type continuous");
      }
    }
    variable.lower = json.at("lower").get<double>();
    variable.upper = json.at("upper").get<double>();
    if (!(variable.lower < variable.upper)) {
      findings_.add(pointer, "the lower bound is not below the upper", "lower < upper");
    }
  }

  std::vector<std::string> wanted_targets(const std::string& name, const Json& json,
                                          const std::string& pointer) {
    if (json.contains("target") && json.contains("targets")) {
      findings_.add(pointer + "/targets", "stands beside target, and only one of them can hold",
                    "either target or targets");
      return {};
    }
    if (json.contains("target")) return {json.at("target").get<std::string>()};
    if (json.contains("targets")) return json.at("targets").get<std::vector<std::string>>();
    if (const auto target = known_target(name)) return {*target};
    findings_.add(
        pointer,
        "is not a name that Parapet knows, and has no target" + did_you_mean(name, known_names()),
        "a target such as /barriers/0/height_m, or one of the names " + joined(known_names()));
    return {};
  }

  std::optional<ActiveWhen> read_condition(const Json& json, const std::string& pointer) {
    if (json.size() != 1) {
      findings_.add(pointer, "names " + std::to_string(json.size()) + " choices",
                    "one earlier choice with one or several of its options");
      return std::nullopt;
    }
    const std::string name = json.begin().key();
    const Json& wanted = json.begin().value();
    const std::string place = child_pointer(pointer, name);
    std::vector<std::string> choices;
    for (const Variable& earlier : variables) {
      if (earlier.kind == VariableKind::choice) choices.push_back(earlier.name);
      if (earlier.name != name || earlier.kind != VariableKind::choice) continue;
      return read_condition_options(earlier, wanted, place);
    }
    findings_.add(place, "is not an earlier choice" + did_you_mean(name, choices),
                  choices.empty() ? "a choice that stands before this variable"
                                  : "one of " + joined(choices));
    return std::nullopt;
  }

  ActiveWhen read_condition_options(const Variable& choice, const Json& wanted,
                                    const std::string& pointer) {
    ActiveWhen condition{choice.name, {}};
    const Json list = wanted.is_string() ? Json::array({wanted}) : wanted;
    for (std::size_t k = 0; k < list.size(); ++k) {
      const std::string word = list[k].get<std::string>();
      if (const auto number = option_number(choice, word)) {
        condition.options.push_back(*number);
        continue;
      }
      const std::vector<std::string> names = option_names(choice);
      findings_.add(wanted.is_string() ? pointer : child_pointer(pointer, k),
                    "is not an option of " + choice.name + did_you_mean(word, names),
                    "one of " + joined(names, "\""));
    }
    return condition;
  }

  Findings& findings_;
};

/// Holds the targets of the variables against every combination of options.
class TargetCheck {
 public:
  TargetCheck(const std::vector<Variable>& variables, const std::vector<Combination>& combinations,
              const Json& json, Findings& findings)
      : variables_(variables),
        combinations_(combinations),
        json_(json),
        findings_(findings),
        owners_(combinations.size()) {
    for (std::size_t c = 0; c < combinations.size(); ++c) own_by_options(c);
  }

  /// The targets that are sound; those that are the same place under every combination by that
  /// place.
  std::vector<std::string> sound_targets(const Variable& variable) {
    std::vector<std::string> sound;
    for (const std::string& target : variable.targets) {
      std::vector<std::vector<std::string>> places;
      if (!check(variable, target, places)) continue;
      const bool same = std::all_of(places.begin(), places.end(),
                                    [&](const auto& other) { return other == places.front(); });
      if (same && !places.empty()) {
        sound.insert(sound.end(), places.front().begin(), places.front().end());
      } else {
        sound.push_back(target);
      }
    }
    return sound;
  }

 private:
  void own_by_options(std::size_t c) {
    for (const Variable& choice : variables_) {
      const auto taken = combinations_[c].options.find(choice.name);
      if (taken == combinations_[c].options.end()) continue;
      const Option& option = choice.options[static_cast<std::size_t>(taken->second)];
      for (const auto& [place, value] : option.sets) {
        owners_[c][place] = "the option " + option.name + " of " + choice.name + " sets";
      }
    }
  }

  bool check(const Variable& variable, const std::string& target,
             std::vector<std::vector<std::string>>& places) {
    const std::string pointer = child_pointer("/variables", variable.name);
    for (std::size_t c = 0; c < combinations_.size(); ++c) {
      if (!is_active(variables_, variable, combinations_[c].options)) continue;
      const TargetPlaces found = find_target(target, combinations_[c]);
      if (!found.problem.empty()) {
        findings_.add(pointer, found.problem, found.allowed);
        return false;
      }
      if (places.empty() && !check_unit(variable.name, found.pointers.front(), pointer)) {
        return false;
      }
      for (const std::string& place : found.pointers) {
        const auto [owner, is_new] = owners_[c].try_emplace(place, variable.name + " varies");
        if (is_new) continue;
        findings_.add(
            pointer,
            "varies " + place + ", which " + owner->second + " already" + combinations_[c].note(),
            "one variable for each input");
        return false;
      }
      if (places.empty()) check_bounds(found.pointers.front(), pointer);
      places.push_back(found.pointers);
    }
    return true;
  }

  bool check_unit(const std::string& name, const std::string& place, const std::string& pointer) {
    const std::string_view unit = math::unit_of(last_key(place)).suffix;
    if (math::unit_of(name).suffix == unit) return true;
    findings_.add(
        pointer, "the name does not end in the unit of its target " + place,
        unit.empty() ? "a name without a unit" : "a name that ends in " + std::string(unit));
    return false;
  }

  /// Each bound against what the case's schema allows at the target.
  void check_bounds(const std::string& place, const std::string& pointer) {
    const Json& json = json_.at(last_key(pointer));
    for (const char* bound : {"lower", "upper"}) {
      if (!json.contains(bound)) continue;
      for (const ValueProblem& found : value_problems(place, json.at(bound))) {
        findings_.add(child_pointer(pointer, bound), found.problem, found.allowed);
      }
    }
  }

  const std::vector<Variable>& variables_;
  const std::vector<Combination>& combinations_;
  const Json& json_;
  Findings& findings_;
  std::vector<std::map<std::string, std::string>> owners_;  ///< by combination: place -> who
};

}  // namespace

VariableReading read_variables(const Json& json, const Json& resolved_case, Findings& findings) {
  const bool has_choices = std::any_of(json.begin(), json.end(), [](const Json& entry) {
    return entry.contains("options") || entry.contains("active_when");
  });
  const std::size_t known_findings = findings.size();
  VariableReader reader(findings);
  for (const auto& [name, entry] : json.items()) reader.read(name, entry);
  VariableReading result{std::move(reader.variables), {}};
  // What options do cannot be judged while the choices are wrong themselves.
  if (has_choices && findings.size() > known_findings) return result;
  result.combinations = combinations(result.variables, resolved_case, findings);
  if (has_choices && findings.size() > known_findings) return result;
  TargetCheck check(result.variables, result.combinations, json, findings);
  for (Variable& variable : result.variables) variable.targets = check.sound_targets(variable);
  return result;
}

}  // namespace parapet::designs
