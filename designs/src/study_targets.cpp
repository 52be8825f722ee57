#include "study_targets.hpp"

#include <algorithm>
#include <array>

#include "findings.hpp"
#include "schema.hpp"
#include "words.hpp"

namespace parapet::designs {
namespace {

struct KnownVariable {
  const char* name;
  const char* target;
};

constexpr std::array<KnownVariable, 21> known_variables{
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
     {"flow_index", "/material/flow_index"},
     {"friction_angle_deg", "/material/friction_angle_deg"}}};

constexpr std::array<const char*, 5> scene_sections{"channel", "reservoir", "material", "barriers",
                                                    "solids"};

constexpr std::string_view last_barrier = "/barriers/N/", each_barrier = "/barriers/*/";

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

std::string missing_target(const std::string& target, const Json& resolved_case) {
  if (target.empty() || target[0] != '/') {
    return "its target " + target + " is not a JSON pointer into the case";
  }
  const std::string deflector = "/deflector/";
  const std::size_t at = target.find(deflector);
  if (at != std::string::npos) {
    const Json* plate = find_value(resolved_case, target.substr(0, at + deflector.size() - 1));
    if (plate != nullptr && plate->is_null()) {
      return "its target " + target + " does not exist: that barrier has no deflector";
    }
  }
  const auto node = schema_at(schema_document("case.schema.json"), target);
  if (node && (*node)->value("type", Json()) == "number" &&
      find_value(resolved_case, target) == nullptr) {
    return "its target " + target + " is not set in the case";
  }
  return "its target " + target + " is not a number of the case's scene";
}

}  // namespace

std::vector<std::string> known_names() {
  std::vector<std::string> names;
  for (const KnownVariable& known : known_variables) names.push_back(known.name);
  return names;
}

std::optional<std::string> known_target(const std::string& name) {
  for (const KnownVariable& known : known_variables) {
    if (name == known.name) return known.target;
  }
  return std::nullopt;
}

std::vector<std::string> expand_target(const std::string& target, std::size_t n_barriers) {
  const std::size_t index_at = last_barrier.size() - 2;  // of N and of *
  const auto with_index = [&](std::size_t k) {
    return std::string(target).replace(index_at, 1, std::to_string(k));
  };
  std::vector<std::string> pointers;
  if (target.starts_with(each_barrier)) {
    for (std::size_t k = 0; k < n_barriers; ++k) pointers.push_back(with_index(k));
  } else if (!target.starts_with(last_barrier)) {
    pointers.push_back(target);
  } else if (n_barriers >= 2) {
    pointers.push_back(with_index(n_barriers - 1));
  }
  return pointers;
}

const Json* find_value(const Json& json, const std::string& pointer) {
  try {
    return &json.at(Json::json_pointer(pointer));
  } catch (const Json::exception&) {
    return nullptr;
  }
}

bool is_in_scene(const std::string& pointer) {
  return std::any_of(scene_sections.begin(), scene_sections.end(), [&](const char* section) {
    const std::string start = child_pointer("", section);
    return pointer == start || pointer.starts_with(start + "/");
  });
}

std::vector<std::string> numeric_inputs(const Json& resolved_case) {
  std::vector<std::string> pointers;
  for (const char* section : scene_sections) {
    if (!resolved_case.contains(section)) continue;
    collect_numbers(resolved_case.at(section), child_pointer("", section), pointers);
  }
  return pointers;
}

std::string Combination::note() const {
  return text.empty() ? "" : " (with " + text + ")";
}

TargetPlaces find_target(const std::string& target, const Combination& combination) {
  const std::vector<std::string> inputs = numeric_inputs(combination.resolved);
  TargetPlaces places{expand_target(target, combination.n_barriers()), "", ""};
  if (places.pointers.empty()) {
    places.problem = "needs a barrier that the case does not have (barriers in the case: " +
                     std::to_string(combination.n_barriers()) + ")";
  }
  for (const std::string& pointer : places.pointers) {
    if (std::find(inputs.begin(), inputs.end(), pointer) != inputs.end()) continue;
    places.problem = missing_target(pointer, combination.resolved);
    break;
  }
  if (places.problem.empty()) return places;
  places.problem += combination.note();
  places.allowed = "one of " + joined(inputs);
  return places;
}

std::vector<ValueProblem> value_problems(const std::string& pointer, const Json& value) {
  std::vector<ValueProblem> problems;
  const auto node = schema_at(schema_document("case.schema.json"), pointer);
  for (const InputIssue& issue : schema_issues(*node, value, "", "")) {
    problems.push_back({issue.problem + " for " + pointer, allowed_by(*node, last_key(pointer))});
  }
  return problems;
}

}  // namespace parapet::designs
