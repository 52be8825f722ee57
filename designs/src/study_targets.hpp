/// Where the values of variables, options and scenarios go in a case.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "parapet/designs/study_spec.hpp"

namespace parapet::designs {

/// The target of a name that Parapet knows, such as /barriers/N/height_m for downstream_height_m.
std::optional<std::string> known_target(const std::string& name);
std::vector<std::string> known_names();

/// The pointers that a target stands for in a case with this many barriers: N is the last of at
/// least two, * is each one. Empty when there is no such barrier.
std::vector<std::string> expand_target(const std::string& target, std::size_t n_barriers);

/// What the case holds there; nullptr when that is no place in it.
const Json* find_value(const Json& json, const std::string& pointer);

/// The parts of a case that make up its scene: channel, reservoir, ...
bool is_in_scene(const std::string& pointer);

/// The numbers of a case's scene that a variable may take the place of, as JSON pointers.
std::vector<std::string> numeric_inputs(const Json& resolved_case);

/// The base case under one combination of options.
struct Combination {
  Design options;    ///< the active choices
  std::string text;  ///< `deflector = "plate"`, ...; empty when the study has no choice
  Json resolved;     ///< with defaults written out

  /// " (with deflector = "plate")", or "".
  std::string note() const;
  std::size_t n_barriers() const { return resolved.at("barriers").size(); }
};

/// The places of a target under a combination, or what is wrong with it.
struct TargetPlaces {
  std::vector<std::string> pointers;
  std::string problem, allowed;  ///< empty when each pointer leads to a number of the scene
};
TargetPlaces find_target(const std::string& target, const Combination& combination);

/// What the case's schema says against a value at a place, as problem and allowed.
struct ValueProblem {
  std::string problem, allowed;
};
std::vector<ValueProblem> value_problems(const std::string& pointer, const Json& value);

}  // namespace parapet::designs
