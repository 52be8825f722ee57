#include "parapet/study/record_flows.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "parapet/records/atomic_file.hpp"
#include "parapet/records/file_name.hpp"
#include "parapet/records/flow_recording.hpp"
#include "parapet/study/front.hpp"
#include "parapet/study/local_service.hpp"
#include "parapet/study/verify.hpp"
#include "simulate_in_order.hpp"

namespace parapet::study {
namespace {

namespace fs = std::filesystem;
using designs::Json;
using records::EvaluationRecord;

constexpr const char* ending = ".flow";

/// The scenario in which the first objective is worst; null: the base event, or the first one.
const designs::Scenario* worst_event(const designs::StudySpec& study,
                                     const EvaluationRecord& record) {
  if (study.scenarios.empty()) return nullptr;
  const designs::Objective& objective = study.objectives.front();
  const double sign = objective.goal == designs::Goal::maximize ? 1.0 : -1.0;
  const designs::Scenario* worst = &study.scenarios.front();
  std::optional<double> least;
  for (const records::ScenarioRecord& event : record.scenarios) {
    const auto metric = std::ranges::find(event.metrics, objective.metric, &solver::Metric::key);
    if (metric == event.metrics.end() || !metric->value) continue;
    const auto scenario = std::ranges::find(study.scenarios, event.name, &designs::Scenario::name);
    if (scenario == study.scenarios.end() || (least && sign * *metric->value >= *least)) continue;
    least = sign * *metric->value;
    worst = &*scenario;
  }
  return worst;
}

/// Whether the recording of this case is there.
bool is_there(const fs::path& file, const std::string& key) {
  std::error_code none;
  if (!fs::is_regular_file(fs::symlink_status(file, none))) return false;
  try {
    return records::recording_header(records::read_own_file(file)).value("case_hash", "") == key;
  } catch (const std::runtime_error&) {
    return false;  // damaged: it is made again
  }
}

records::Simulation simulate_recorded(const SimulationTask& task, const fs::path& file,
                                      const solver::Callbacks& given) {
  records::RecordingWriter writer(task.spec, task.label);
  solver::RunOptions run = task.spec.run;
  run.threads = task.threads;
  run.frame_interval = records::recording_interval(task.spec.scene, run.stop_time);
  solver::Callbacks callbacks = given;
  callbacks.on_frame = [&](const solver::Frame& frame) { writer.add(frame); };
  records::Simulation simulation;
  try {
    const solver::Result result =
        solver::simulate(task.spec.scene, task.spec.numerics, run, callbacks);
    simulation.ok = result.status == solver::Status::ok;
    simulation.cancelled = result.status == solver::Status::cancelled;
    simulation.reason = result.reason;
    simulation.metrics = result.metrics;
  } catch (const std::invalid_argument& error) {
    return impossible_scene(error.what());
  }
  if (simulation.ok) records::write_file_atomically(file, writer.finish());
  return simulation;
}

void remove_others(const fs::path& folder, const std::vector<FlowToRecord>& flows) {
  std::set<fs::path> wanted;
  for (const FlowToRecord& flow : flows) wanted.insert(recording_file(folder, flow.name));
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder / "recordings", none)) {
    if (entry.path().extension() != ending || wanted.contains(entry.path())) continue;
    std::error_code error;
    fs::remove(entry.path(), error);
    if (error) records::throw_file_error("remove", entry.path(), error.value());
  }
}

}  // namespace

fs::path recording_file(const fs::path& folder, const std::string& name) {
  return folder / "recordings" / (records::file_name(name) + ending);
}

FlowToRecord flow_of_design(const designs::StudySpec& study, const EvaluationRecord& record) {
  const designs::Scenario* event = worst_event(study, record);
  const std::string label = event == nullptr ? record.id : record.id + " " + event->name;
  FlowToRecord flow{.name = record.id,
                    .task = make_task(study, record.design, event, record.spacing, label, 1),
                    .metrics = {}};
  if (event == nullptr) flow.metrics = record.metrics;
  for (const records::ScenarioRecord& one : record.scenarios) {
    if (event != nullptr && one.name == event->name) flow.metrics = one.metrics;
  }
  return flow;
}

std::vector<EvaluationRecord> designs_to_record(const designs::StudySpec& study,
                                                const std::vector<EvaluationRecord>& records) {
  if (study.recordings == designs::Recordings::none) return {};
  const double finest = designs::finest_spacing(study);
  std::vector<EvaluationRecord> chosen;
  if (study.recordings == designs::Recordings::all) {
    for (const EvaluationRecord& record : records) {
      if (record.ok && record.spacing == finest) chosen.push_back(record);
    }
    return chosen;
  }
  std::vector<EvaluationRecord> front = make_front(study, records, {}, false).designs;
  if (study.objectives.size() == 1) {
    const EvaluationRecord* start = nullptr;
    for (const EvaluationRecord& one : records) {
      if (one.stage != "start" || !one.feasible || one.spacing != finest) continue;
      if (!one.objective_scalar) continue;
      if (start == nullptr || *one.objective_scalar < *start->objective_scalar) start = &one;
    }
    if (start != nullptr && (front.empty() || front.front().id != start->id)) {
      front.push_back(*start);
    }
    return front;
  }
  std::ranges::stable_sort(front, {}, [](const EvaluationRecord& record) {
    return record.objectives.front().value.value_or(0.0);
  });
  for (const std::size_t k : spread_sample(front.size(), most_recorded_designs)) {
    chosen.push_back(front[k]);
  }
  return chosen;
}

RecordOutcome record_flows(const fs::path& folder, std::vector<FlowToRecord> flows, int jobs,
                           const Hooks& hooks, bool only_these) {
  RecordOutcome outcome;
  if (only_these) remove_others(folder, flows);
  std::erase_if(flows, [&](const FlowToRecord& flow) {
    const bool there = is_there(recording_file(folder, flow.name), flow.task.key);
    if (there) ++outcome.kept;
    return there;
  });
  if (flows.empty()) return outcome;
  records::make_folder(folder / "recordings");
  std::map<std::string, fs::path> files;  // by label
  for (const FlowToRecord& flow : flows) {
    files[flow.task.label] = recording_file(folder, flow.name);
  }
  const auto service =
      local_service([&](const SimulationTask& task, const solver::Callbacks& callbacks) {
        return simulate_recorded(task, files.at(task.label), callbacks);
      })(jobs, service_hooks(hooks));
  simulate_in_order(
      *service, flows.size(), [&](std::size_t k) { return std::optional(flows[k].task); },
      [&](std::size_t k, const records::Simulation& now) {
        const FlowToRecord& flow = flows[k];
        if (hooks.on_simulation_ended) hooks.on_simulation_ended(flow.task.label);
        if (now.cancelled) {
          outcome.cancelled = true;
          return;
        }
        if (!now.ok) {
          outcome.failed.push_back(flow.name);
          return;
        }
        ++outcome.recorded;
        const StoredRun before{.label = flow.name,
                               .program = "",
                               .task = {},
                               .ok = true,
                               .reason = "",
                               .metrics = flow.metrics};
        if (!flow.metrics.empty() && !compare(before, now).empty()) {
          outcome.different.push_back(flow.name);
        }
      },
      [&] { return outcome.cancelled || (hooks.cancelled && hooks.cancelled()); });
  outcome.cancelled = outcome.cancelled || (hooks.cancelled && hooks.cancelled());
  return outcome;
}

}  // namespace parapet::study
