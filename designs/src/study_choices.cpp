#include "study_choices.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "case_parts.hpp"

namespace parapet::designs {
namespace {

constexpr std::size_t most_combinations = 1000;  // beyond it the check of a study takes seconds

// Setting the first takes the second away.
constexpr std::array<std::pair<const char*, const char*>, 4> exclusive_keys{
    {{"foot_x_m", "spacing_m"},
     {"spacing_m", "foot_x_m"},
     {"stem_lean_deg", "stem_inclination"},
     {"stem_inclination", "stem_lean_deg"}}};

std::string place_text() {
  return "a JSON pointer into the scene of the case, such as /barriers/0/deflector";
}

bool is_index(const std::string& token) {
  return !token.empty() && token.size() < 8 &&
         token.find_first_not_of("0123456789") == std::string::npos &&
         (token == "0" || token[0] != '0');
}

/// The part that holds a place, and the place's own key; nullptr when that part does not exist.
std::pair<Json*, std::string> parent_of(Json& json, const std::string& pointer) {
  try {
    const Json::json_pointer place(pointer);
    return {&json.at(place.parent_pointer()), place.back()};
  } catch (const Json::exception&) {
    return {nullptr, ""};
  }
}

bool remove_place(Json& json, const std::string& pointer) {
  if (!is_in_scene(pointer) || find_value(json, pointer) == nullptr) return false;
  const auto [parent, key] = parent_of(json, pointer);
  if (parent->is_array()) {
    parent->erase(std::stoul(key));
  } else {
    parent->erase(key);
  }
  return true;
}

bool set_place(Json& json, const std::string& pointer, const Json& value) {
  if (!is_in_scene(pointer)) return false;
  const auto [parent, key] = parent_of(json, pointer);
  if (parent == nullptr) return false;
  if (parent->is_array()) {
    if (key == "-" || (is_index(key) && std::stoul(key) == parent->size())) {
      parent->push_back(value);
      return true;
    }
    if (!is_index(key) || std::stoul(key) > parent->size()) return false;
    (*parent)[std::stoul(key)] = value;
    return true;
  }
  if (!parent->is_object()) return false;
  (*parent)[key] = value;
  for (const auto& [taken, left] : exclusive_keys) {
    if (key == taken) parent->erase(left);
  }
  return true;
}

/// What is wrong with the form of a case: schema and keys that exclude each other.
std::vector<InputIssue> form_issues(const Json& json) {
  std::vector<InputIssue> issues = schema_issues(inner_case_schema(), json, "", "");
  if (!issues.empty()) return issues;
  Findings findings("", json);
  check_barrier_keys(json, findings);
  return findings.issues();
}

/// Walks through the choices in their order, one branch for each option.
class CombinationWalk {
 public:
  CombinationWalk(const std::vector<Variable>& variables, Findings& findings)
      : variables_(variables), findings_(findings) {}

  void walk(std::size_t at, Combination so_far, const std::string& last_option) {
    while (at < variables_.size() && !is_taken_here(variables_[at], so_far.options)) ++at;
    if (too_many_) return;
    if (at == variables_.size()) {
      finish(std::move(so_far), last_option);
      return;
    }
    const Variable& choice = variables_[at];
    for (std::size_t k = 0; k < choice.options.size(); ++k) {
      const Option& option = choice.options[k];
      const std::string pointer =
          child_pointer("/variables", choice.name) + "/options" + child_pointer("", option.name);
      Combination next = so_far;
      next.options[choice.name] = static_cast<double>(k);
      next.text.append(next.text.empty() ? "" : ", ")
          .append(choice.name + " = \"" + option.name + "\"");
      if (const auto problem = apply_option(option, next.resolved)) {
        report(pointer + problem->member, problem->problem, so_far.note(), problem->allowed);
      } else {
        walk(at + 1, std::move(next), pointer);
      }
    }
  }

  std::vector<Combination> found;

 private:
  bool is_taken_here(const Variable& variable, const Design& options) const {
    return variable.kind == VariableKind::choice && is_active(variables_, variable, options);
  }

  void finish(Combination combination, const std::string& last_option) {
    if (found.size() == most_combinations) {
      too_many_ = true;
      findings_.add(
          "/variables",
          "the choices have more than " + std::to_string(most_combinations) + " combinations",
          "fewer choices or options, or active_when to leave combinations out");
      return;
    }
    if (!last_option.empty()) {  // the base case itself is sound
      const std::vector<InputIssue> issues = form_issues(combination.resolved);
      for (const InputIssue& issue : issues) {
        report(last_option, "makes no case: " + issue.pointer + " " + issue.problem,
               combination.note(), issue.allowed);
      }
      if (!issues.empty()) return;
      combination.resolved = resolve_case(inner_case_schema(), combination.resolved);
    }
    found.push_back(std::move(combination));
  }

  /// Each mistake once, with the first combination that shows it.
  void report(const std::string& pointer, const std::string& problem, const std::string& note,
              const std::string& allowed) {
    if (reported_.insert(problem).second) findings_.add(pointer, problem + note, allowed);
  }

  const std::vector<Variable>& variables_;
  Findings& findings_;
  std::set<std::string> reported_;
  bool too_many_ = false;
};

}  // namespace

std::optional<OptionProblem> apply_option(const Option& option, Json& json) {
  for (std::size_t k = 0; k < option.removes.size(); ++k) {
    const std::string& pointer = option.removes[k];
    if (remove_place(json, pointer)) continue;
    return OptionProblem{child_pointer("/remove", k),
                         "removes " + pointer + ", which is not in the scene of the case",
                         place_text()};
  }
  for (const auto& [pointer, value] : option.sets) {
    if (set_place(json, pointer, value)) continue;
    return OptionProblem{child_pointer("/set", pointer),
                         "sets " + pointer + ", which is no place in the scene of the case",
                         place_text()};
  }
  return std::nullopt;
}

bool is_active(const std::vector<Variable>& variables, const Variable& variable,
               const Design& design) {
  if (!variable.active_when) return true;
  const auto choice = std::find_if(variables.begin(), variables.end(), [&](const Variable& other) {
    return other.name == variable.active_when->choice;
  });
  const auto taken = design.find(variable.active_when->choice);
  if (choice == variables.end() || taken == design.end()) return false;
  const std::vector<int>& options = variable.active_when->options;
  return std::any_of(options.begin(), options.end(),
                     [&](int option) { return taken->second == option; }) &&
         is_active(variables, *choice, design);
}

Json structured_case(const StudySpec& study, const Design& design) {
  Json json = study.base_case;
  bool changed = false;
  for (const Variable& variable : study.variables) {
    const auto taken = design.find(variable.name);
    if (variable.kind != VariableKind::choice || taken == design.end()) continue;
    const Option& option = variable.options.at(static_cast<std::size_t>(taken->second));
    if (const auto problem = apply_option(option, json)) {
      throw InputError({{study.source_file,
                         child_pointer("/variables", variable.name) + "/options" +
                             child_pointer("", option.name) + problem->member,
                         "", problem->problem, problem->allowed}});
    }
    changed = true;
  }
  if (!changed || !form_issues(json).empty()) return json;
  return resolve_case(inner_case_schema(), json);
}

std::vector<Combination> combinations(const std::vector<Variable>& variables,
                                      const Json& resolved_case, Findings& findings) {
  CombinationWalk walk(variables, findings);
  walk.walk(0, {{}, "", resolved_case}, "");
  return std::move(walk.found);
}

std::map<std::string, std::string> varied_places(const std::vector<Variable>& variables,
                                                 const std::vector<Combination>& combinations) {
  std::map<std::string, std::string> places;
  for (const Variable& variable : variables) {
    for (const Option& option : variable.options) {
      const std::string by = "the option " + option.name + " of " + variable.name;
      for (const std::string& pointer : option.removes) places.try_emplace(pointer, by);
      for (const auto& [pointer, value] : option.sets) places.try_emplace(pointer, by);
    }
    for (const Combination& combination : combinations) {
      if (!is_active(variables, variable, combination.options)) continue;
      for (const std::string& target : variable.targets) {
        for (const std::string& pointer : expand_target(target, combination.n_barriers())) {
          places.try_emplace(pointer, "the variable " + variable.name);
        }
      }
    }
  }
  return places;
}

}  // namespace parapet::designs
