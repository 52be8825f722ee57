#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "case_parts.hpp"
#include "study_parts.hpp"
#include "words.hpp"

namespace parapet::designs {
namespace {

struct KnownVariable {
  const char* name;
  const char* target;  ///< N stands for the last barrier, * for each barrier
};

constexpr std::array<KnownVariable, 20> known_variables{
    {{"deflector_angle_deg", "/barriers/0/deflector/angle_deg"},
     {"deflector_length_m", "/barriers/0/deflector/length_m"},
     {"upstream_height_m", "/barriers/0/height_m"},
     {"upstream_foot_x_m", "/barriers/0/foot_x_m"},
     {"upstream_thickness_m", "/barriers/0/thickness_m"},
     {"upstream_stem_lean_deg", "/barriers/0/stem_lean_deg"},
     {"barrier_spacing_m", "/barriers/1/spacing_m"},
     {"downstream_height_m", "/barriers/N/height_m"},
     {"downstream_thickness_m", "/barriers/N/thickness_m"},
     {"downstream_stem_lean_deg", "/barriers/N/stem_lean_deg"},
     {"downstream_deflector_angle_deg", "/barriers/N/deflector/angle_deg"},
     {"downstream_deflector_length_m", "/barriers/N/deflector/length_m"},
     {"barrier_thickness_m", "/barriers/*/thickness_m"},
     {"slope_deg", "/channel/slope_deg"},
     {"reservoir_length_m", "/reservoir/length_m"},
     {"reservoir_height_m", "/reservoir/height_m"},
     {"density_kg_m3", "/material/density_kg_m3"},
     {"yield_stress_pa", "/material/yield_stress_pa"},
     {"consistency_pa_sn", "/material/consistency_pa_sn"},
     {"flow_index", "/material/flow_index"}}};

std::vector<std::string> known_names() {
  std::vector<std::string> names;
  for (const KnownVariable& known : known_variables) names.push_back(known.name);
  return names;
}

/// Targets of a name that Parapet knows, for this many barriers; "N" and "*" need at least two
/// barriers and one. Empty when there is no such barrier.
std::optional<std::vector<std::string>> known_targets(const std::string& name,
                                                      std::size_t n_barriers) {
  for (const KnownVariable& known : known_variables) {
    if (name != known.name) continue;
    std::string target = known.target;
    std::vector<std::string> targets;
    const std::size_t each = target.find('*'), last = target.find('N');
    if (each != std::string::npos) {
      for (std::size_t k = 0; k < n_barriers; ++k) {
        targets.push_back(std::string(target).replace(each, 1, std::to_string(k)));
      }
    } else if (last == std::string::npos) {
      targets.push_back(target);
    } else if (n_barriers >= 2) {
      targets.push_back(target.replace(last, 1, std::to_string(n_barriers - 1)));
    }
    return targets;
  }
  return std::nullopt;
}

void collect_numbers(const Json& value, const std::string& pointer,
                     std::vector<std::string>& pointers) {
  if (value.is_number()) pointers.push_back(pointer);
  if (value.is_object()) {
    for (const auto& [key, item] : value.items()) {
      collect_numbers(item, child_pointer(pointer, key), pointers);
    }
  }
  if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      collect_numbers(value[i], child_pointer(pointer, i), pointers);
    }
  }
}

/// Reads one variable after the other against the same base case.
class VariableReader {
 public:
  VariableReader(const Json& resolved_case, Findings& findings)
      : case_(resolved_case), inputs_(numeric_inputs(resolved_case)), findings_(findings) {}

  Variable read(const std::string& name, const Json& json) {
    const std::string pointer = child_pointer("/variables", name);
    Variable variable{name, {}, json.at("lower").get<double>(), json.at("upper").get<double>()};
    if (!(variable.lower < variable.upper)) {
      findings_.add(pointer, "the lower bound is not below the upper", "lower < upper");
    }
    for (const std::string& target : wanted_targets(name, json, pointer)) {
      if (check_target(name, target, pointer, json)) variable.targets.push_back(target);
    }
    return variable;
  }

 private:
  std::vector<std::string> wanted_targets(const std::string& name, const Json& json,
                                          const std::string& pointer) {
    if (json.contains("target") && json.contains("targets")) {
      findings_.add(pointer + "/targets", "stands beside target, and only one of them can hold",
                    "either target or targets");
      return {};
    }
    if (json.contains("target")) return {json.at("target").get<std::string>()};
    if (json.contains("targets")) return json.at("targets").get<std::vector<std::string>>();
    const auto targets = known_targets(name, case_.at("barriers").size());
    if (!targets) {
      findings_.add(
          pointer,
          "is not a name that Parapet knows, and has no target" + did_you_mean(name, known_names()),
          "a target such as /barriers/0/height_m, or one of the names " + joined(known_names()));
      return {};
    }
    if (targets->empty()) {
      findings_.add(pointer,
                    "needs a barrier that the case does not have (barriers in the case: " +
                        std::to_string(case_.at("barriers").size()) + ")",
                    possible_inputs());
    }
    return *targets;
  }

  bool check_target(const std::string& name, const std::string& target, const std::string& pointer,
                    const Json& json) {
    if (std::find(inputs_.begin(), inputs_.end(), target) == inputs_.end()) {
      findings_.add(pointer, missing_target(target), possible_inputs());
      return false;
    }
    const std::string key = last_key(target);
    if (unit_suffix(name) != unit_suffix(key)) {
      findings_.add(pointer, "the name does not end in the unit of its target " + target,
                    unit_suffix(key).empty()
                        ? "a name without a unit"
                        : "a name that ends in " + std::string(unit_suffix(key)));
      return false;
    }
    const auto [owner, is_new] = owners_.try_emplace(target, name);
    if (!is_new) {
      findings_.add(pointer, "varies " + target + ", which " + owner->second + " varies already",
                    "one variable for each input");
      return false;
    }
    check_bounds(target, pointer, json);
    return true;
  }

  /// Each bound against what the case's schema allows at the target.
  void check_bounds(const std::string& target, const std::string& pointer, const Json& json) {
    const auto node = schema_at(schema_document("case.schema.json"), target);
    for (const char* bound : {"lower", "upper"}) {
      for (const InputIssue& issue : schema_issues(*node, json.at(bound), "", "")) {
        findings_.add(child_pointer(pointer, bound), issue.problem + " for " + target,
                      allowed_by(*node, last_key(target)));
      }
    }
  }

  std::string missing_target(const std::string& target) const {
    if (target.empty() || target[0] != '/') {
      return "its target " + target + " is not a JSON pointer into the case";
    }
    const std::string deflector = "/deflector/";
    const std::size_t at = target.find(deflector);
    if (at != std::string::npos) {
      const Json* plate = find_value(target.substr(0, at + deflector.size() - 1));
      if (plate != nullptr && plate->is_null()) {
        return "its target " + target + " does not exist: that barrier has no deflector";
      }
    }
    const auto node = schema_at(schema_document("case.schema.json"), target);
    if (node && (*node)->value("type", Json()) == "number" && find_value(target) == nullptr) {
      return "its target " + target + " is not set in the case";
    }
    return "its target " + target + " is not a number of the case's scene";
  }

  /// What the case holds there; nullptr when that is no place in it.
  const Json* find_value(const std::string& pointer) const {
    try {
      return &case_.at(Json::json_pointer(pointer));
    } catch (const Json::exception&) {
      return nullptr;
    }
  }

  std::string possible_inputs() const { return "one of " + joined(inputs_); }

  const Json& case_;
  std::vector<std::string> inputs_;
  Findings& findings_;
  std::map<std::string, std::string> owners_;
};

}  // namespace

std::vector<std::string> numeric_inputs(const Json& resolved_case) {
  std::vector<std::string> pointers;
  for (const char* section : {"channel", "reservoir", "material", "barriers", "solids"}) {
    if (!resolved_case.contains(section)) continue;
    collect_numbers(resolved_case.at(section), child_pointer("", section), pointers);
  }
  return pointers;
}

std::vector<Variable> read_variables(const Json& json, const Json& resolved_case,
                                     Findings& findings) {
  VariableReader reader(resolved_case, findings);
  std::vector<Variable> variables;
  for (const auto& [name, entry] : json.items()) variables.push_back(reader.read(name, entry));
  return variables;
}

}  // namespace parapet::designs
