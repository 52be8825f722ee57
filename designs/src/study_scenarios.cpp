#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "distributions.hpp"
#include "parapet/math/units.hpp"
#include "study_choices.hpp"
#include "study_parts.hpp"
#include "words.hpp"

namespace parapet::designs {
namespace {

constexpr const char* released_volume = "released_volume_m3_per_m";
constexpr const char* block_length = "/reservoir/length_m";
constexpr const char* block_height = "/reservoir/height_m";

/// Nine significant digits: as many as an input deserves, and the last bits of exp and log, which
/// differ between machines, do not reach the study's hash.
double nine_digits(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, 9);
  double result = value;
  std::from_chars(text, end.ptr, result);
  return result;
}

/// Resolves what an event sets to places in the case.
class EventReader {
 public:
  EventReader(const std::vector<Variable>& variables, const std::vector<Combination>& combinations,
              Findings& findings)
      : combinations_(combinations),
        varied_(varied_places(variables, combinations)),
        findings_(findings) {}

  /// The places that a name, or a pointer, stands for; empty with a finding when it has none.
  std::vector<std::string> places(const std::string& key, const std::string& target,
                                  const std::string& pointer) {
    const std::string wanted = !target.empty()          ? target
                               : key == released_volume ? block_length
                               : key.starts_with("/")   ? key
                                                        : known_target(key).value_or("");
    if (wanted.empty()) {
      std::vector<std::string> names = known_names();
      names.push_back(released_volume);
      findings_.add(
          pointer, "is not a name that Parapet knows" + did_you_mean(key, names),
          "a JSON pointer such as /material/yield_stress_pa, or one of the names " + joined(names));
      return {};
    }
    if (!target.empty() && math::unit_of(key).suffix != math::unit_of(last_key(target)).suffix) {
      findings_.add(pointer, "the name does not end in the unit of its target " + target,
                    "a name in the unit of the target");
      return {};
    }
    std::vector<std::string> found;
    for (const Combination& combination : combinations_) {
      const TargetPlaces here = find_target(wanted, combination);
      if (!here.problem.empty()) {
        findings_.add(pointer, here.problem, here.allowed);
        return {};
      }
      if (!found.empty() && found != here.pointers) {
        findings_.add(pointer,
                      "is " + joined(here.pointers) + combination.note() + ", but " +
                          joined(found) + combinations_.front().note(),
                      "a place that is the same under every combination of options");
        return {};
      }
      found = here.pointers;
    }
    return are_free(key, found, pointer) ? found : std::vector<std::string>{};
  }

  /// Puts one value into an event. `known` are the places of its key.
  void set(Scenario& scenario, const std::vector<std::string>& known, double value,
           const std::string& pointer) {
    for (const std::string& place : known) {
      if (!scenario.sets.try_emplace(place, value).second) {
        findings_.add(pointer, "sets " + place + ", which " + scenario.name + " sets already",
                      "each place once");
        return;
      }
      for (const ValueProblem& problem : value_problems(place, value)) {
        findings_.add(pointer, scenario.name + ": " + Json(value).dump() + " " + problem.problem,
                      problem.allowed);
      }
    }
  }

  /// The height of the block in an event [m].
  double height(const Scenario& scenario) const {
    const auto own = scenario.sets.find(block_height);
    if (own != scenario.sets.end()) return own->second;
    return combinations_.front().resolved.at("reservoir").at("height_m").get<double>();
  }

 private:
  /// A scenario may not set what a variable or an option sets.
  bool are_free(const std::string& key, std::vector<std::string> places,
                const std::string& pointer) {
    if (key == released_volume) places.push_back(block_height);
    for (const std::string& place : places) {
      for (const auto& [varied, by] : varied_) {
        if (place != varied && !place.starts_with(varied + "/")) continue;
        std::string problem = key == released_volume ? "needs " : "sets ";
        problem.append(place).append(", which ").append(by).append(" changes");
        findings_.add(pointer, problem, "a place that no variable changes");
        return false;
      }
    }
    return true;
  }

  const std::vector<Combination>& combinations_;
  std::map<std::string, std::string> varied_;
  Findings& findings_;
};

/// The names in an order in which the block's height is known before its volume.
std::vector<std::string> volume_last(const Json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  std::stable_partition(keys.begin(), keys.end(),
                        [](const std::string& key) { return key != released_volume; });
  return keys;
}

void check_names(const std::vector<Scenario>& scenarios, const std::string& pointer,
                 Findings& findings) {
  std::set<std::string> seen;
  for (std::size_t k = 0; k < scenarios.size(); ++k) {
    if (seen.insert(scenarios[k].name).second) continue;
    findings.add(child_pointer(pointer, k),
                 "another scenario is called \"" + scenarios[k].name + "\" too",
                 "a name of its own, in the key name");
  }
}

void normalise_weights(std::vector<Scenario>& scenarios) {
  double sum = 0.0;
  for (const Scenario& scenario : scenarios) sum += scenario.weight;
  // Weights that are normalised already keep their bits: a resolved study reads back the same.
  if (std::abs(sum - 1.0) < 1e-12) return;
  for (Scenario& scenario : scenarios) scenario.weight /= sum;
}

std::vector<Scenario> read_list(const Json& json, const std::string& pointer, EventReader& reader,
                                Findings& findings) {
  std::vector<Scenario> scenarios;
  for (std::size_t k = 0; k < json.size(); ++k) {
    const std::string place = child_pointer(pointer, k) + "/set";
    Scenario scenario;
    scenario.name = json[k].value("name", "event_" + std::to_string(k + 1));
    scenario.weight = json[k].at("weight").get<double>();
    const Json& sets = json[k].at("set");
    for (const std::string& key : volume_last(sets)) {
      double value = sets.at(key).get<double>();
      if (key == released_volume) value = nine_digits(value / reader.height(scenario));
      const std::string at = child_pointer(place, key);
      reader.set(scenario, reader.places(key, "", at), value, at);
    }
    scenarios.push_back(std::move(scenario));
  }
  check_names(scenarios, pointer, findings);
  normalise_weights(scenarios);
  return scenarios;
}

/// The values of one variable at some shares of its distribution.
std::vector<double> values_at(const Distribution& distribution, const std::vector<double>& shares) {
  std::vector<double> values;
  for (const double share : shares) values.push_back(nine_digits(quantile(distribution, share)));
  return values;
}

/// The events that the distributions give.
ScenarioReading draw_events(const Json& json, EventReader& reader, Findings& findings) {
  const Json& variables = json.at("variables");
  std::vector<std::string> keys;
  std::vector<Distribution> distributions;
  std::vector<std::vector<std::string>> places;
  for (const std::string& key : volume_last(variables)) {
    const std::string pointer = child_pointer("/scenarios/variables", key);
    const std::optional<Distribution> distribution =
        read_distribution(variables.at(key), pointer, findings);
    std::vector<std::string> found =
        reader.places(key, variables.at(key).value("target", ""), pointer);
    if (!distribution || found.empty()) continue;
    keys.push_back(key);
    distributions.push_back(*distribution);
    places.push_back(std::move(found));
  }
  if (!findings.empty()) return {};

  const auto count = static_cast<std::size_t>(json.at("count").get<double>());
  const auto seed = static_cast<std::uint64_t>(json.at("seed").get<double>());
  const auto shares = latin_hypercube(count, keys.size(), seed);
  // Another seed: events of which the simulated ones are no part.
  const auto further = latin_hypercube(n_event_draws, keys.size(), 0x5eed0e7e5ULL + seed);
  ScenarioReading result{.scenarios = std::vector<Scenario>(count), .variables = {}};
  for (std::size_t k = 0; k < keys.size(); ++k) {
    result.variables.push_back({.name = keys[k],
                                .at = values_at(distributions[k], shares[k]),
                                .draws = values_at(distributions[k], further[k])});
  }
  std::vector<Scenario>& scenarios = result.scenarios;
  for (std::size_t event = 0; event < count && findings.empty(); ++event) {
    Scenario& scenario = scenarios[event];
    scenario.name = "event_" + std::to_string(event + 1);
    scenario.weight = 1.0 / static_cast<double>(count);
    for (std::size_t k = 0; k < keys.size(); ++k) {
      double value = quantile(distributions[k], shares[k][event]);
      if (keys[k] == released_volume && !variables.at(keys[k]).contains("target")) {
        value /= reader.height(scenario);
      }
      reader.set(scenario, places[k], nine_digits(value),
                 child_pointer("/scenarios/variables", keys[k]));
    }
  }
  return result;
}

/// Whether a list is the one that was drawn, but for the last digits.
bool is_same_list(const std::vector<Scenario>& given, const std::vector<Scenario>& drawn) {
  constexpr double close = 1e-6;  // values hold nine digits; another exp or log moves the last
  return std::equal(given.begin(), given.end(), drawn.begin(), drawn.end(),
                    [](const Scenario& a, const Scenario& b) {
                      return a.name == b.name && std::abs(a.weight - b.weight) < close &&
                             std::equal(a.sets.begin(), a.sets.end(), b.sets.begin(), b.sets.end(),
                                        [](const auto& left, const auto& right) {
                                          return left.first == right.first &&
                                                 std::abs(left.second - right.second) <=
                                                     close * std::abs(right.second);
                                        });
                    });
}

}  // namespace

ScenarioReading read_scenarios(const Json& json, const std::vector<Variable>& variables,
                               const std::vector<Combination>& combinations, Findings& findings) {
  // Counted apart: what is wrong elsewhere does not keep the events from being drawn.
  Findings own = findings.of_its_own();
  EventReader reader(variables, combinations, own);
  ScenarioReading result =
      json.is_array() ? ScenarioReading{.scenarios = read_list(json, "/scenarios", reader, own),
                                        .variables = {}}
                      : draw_events(json, reader, own);
  if (own.empty() && json.is_object() && json.contains("list")) {
    std::vector<Scenario> given = read_list(json.at("list"), "/scenarios/list", reader, own);
    if (own.empty() && !is_same_list(given, result.scenarios)) {
      own.add("/scenarios/list", "is not what the distributions give",
              "no list, so that it is drawn again, or the one that was drawn");
    }
    result.scenarios = std::move(given);
  }
  findings.append(own.issues());
  return result;
}

}  // namespace parapet::designs
