#include "parapet/study/simulation_task.hpp"

#include <stdexcept>
#include <utility>

#include "parapet/records/hashes.hpp"
#include "parapet/records/whole_number.hpp"

namespace parapet::study {
namespace {

using designs::Json;

constexpr const char* format = "parapet-simulation-task/1";

}  // namespace

SimulationTask make_task(const designs::StudySpec& study, const designs::Design& design,
                         const designs::Scenario* scenario, double spacing, std::string label,
                         int threads) {
  SimulationTask task =
      task_from_case(designs::design_case(study, design, scenario, spacing), std::move(label));
  task.design = design;
  if (scenario != nullptr) task.scenario = scenario->name;
  task.threads = threads;
  return task;
}

SimulationTask task_from_case(designs::CaseSpec spec, std::string label) {
  SimulationTask task;
  task.label = std::move(label);
  task.spec = std::move(spec);
  task.key = records::case_hash(task.spec);
  return task;
}

Json to_json(const SimulationTask& task) {
  Json json;
  json["format"] = format;
  json["label"] = task.label;
  json["design"] = task.design;
  json["scenario"] = task.scenario;
  json["threads"] = task.threads;
  json["key"] = task.key;
  json["case"] = task.spec.resolved;
  return json;
}

SimulationTask task_from_json(const Json& json) {
  if (json.at("format") != format) throw std::runtime_error(std::string("not a ") + format);
  SimulationTask task;
  task.label = json.at("label").get<std::string>();
  task.design = json.at("design").get<designs::Design>();
  task.scenario = json.at("scenario").get<std::string>();
  task.threads = records::whole_number<int>(json.at("threads"));
  task.spec = designs::parse_case(json.at("case"), "the task " + task.label);
  task.key = records::case_hash(task.spec);
  const auto sent = json.at("key").get<std::string>();
  if (task.key != sent) {
    throw std::runtime_error("the task " + task.label + " has the key " + sent +
                             ", but its case has " + task.key +
                             ": it was changed on the way, or another version made it");
  }
  return task;
}

}  // namespace parapet::study
