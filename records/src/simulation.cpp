#include "parapet/records/simulation.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "parapet/records/checksum.hpp"
#include "parapet/records/hashes.hpp"

namespace parapet::records {

using designs::Json;

namespace {

/// Of the document on one line, without its checksum.
std::string content_checksum(const Json& content) {
  return fmt::format("{:08x}", crc32c(content.dump()));
}

}  // namespace

ScenarioRecord scenario_record(const designs::Scenario* scenario, const Simulation& simulation) {
  ScenarioRecord record;
  if (scenario != nullptr) {
    record.name = scenario->name;
    record.weight = scenario->weight;
  }
  record.ok = simulation.ok;
  record.reason = simulation.reason;
  record.metrics = simulation.metrics;
  record.wall_time = simulation.wall_time;
  record.cpu_time = simulation.cpu_time;
  record.particle_steps = simulation.particle_steps;
  record.stop_reason = simulation.stop_reason;
  record.warnings = simulation.warnings;
  if (simulation.report.contains("case")) {
    record.case_hash = case_hash(simulation.report["case"]);
  }
  return record;
}

Json evaluation_report(const EvaluationRecord& record, const Json& report) {
  Json json;
  json["format"] = "parapet-evaluation/1";
  json.update(to_json(record));
  json.update(report);
  return json;
}

Json simulation_report(const designs::Design& design, double spacing,
                       const designs::Scenario* scenario, const Simulation& simulation,
                       const Json& provenance) {
  Json json;
  json["format"] = "parapet-simulation/1";
  json["design"] = design;
  json["spacing_m"] = spacing;
  json["scenario"] = to_json(scenario_record(scenario, simulation));
  json["provenance"] = provenance;
  if (simulation.report.is_object()) json["details"] = simulation.report;
  json["crc32c"] = content_checksum(json);
  return json;
}

StoredSimulation stored_simulation(const Json& json) {
  if (json.at("format") != "parapet-simulation/1") {
    throw std::runtime_error("not a parapet-simulation/1");
  }
  if (json.contains("crc32c")) {  // 0.1.0 wrote none
    Json content = json;
    content.erase("crc32c");
    if (json["crc32c"] != content_checksum(content)) throw std::runtime_error("it was changed");
  }
  StoredSimulation stored;
  stored.design = json.at("design").get<designs::Design>();
  stored.spacing = json.at("spacing_m").get<double>();
  const auto record = scenario_from_json(json.at("scenario"));
  stored.scenario = record.name;
  stored.simulation.ok = record.ok;
  stored.simulation.reason = record.reason;
  stored.simulation.metrics = record.metrics;
  stored.simulation.wall_time = record.wall_time;
  stored.simulation.cpu_time = record.cpu_time;
  stored.simulation.particle_steps = record.particle_steps;
  stored.simulation.stop_reason = record.stop_reason;
  stored.simulation.warnings = record.warnings;
  if (json.contains("details")) stored.simulation.report = json["details"];
  return stored;
}

}  // namespace parapet::records
