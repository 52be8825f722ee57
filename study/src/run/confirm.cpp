#include "parapet/study/confirm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <random>

#include "parapet/records/evaluation_log.hpp"
#include "parapet/records/folder_lock.hpp"
#include "parapet/study/design_run.hpp"
#include "parapet/study/predicted.hpp"
#include "parapet/study/scoring.hpp"
#include "parapet/study/simulator.hpp"
#include "parapet/study/thread_count.hpp"
#include "simulate_in_order.hpp"

namespace parapet::study {
namespace {

using records::EvaluationRecord;
namespace stage = confirmation_stage;

struct PlannedRun {
  std::string id, stage;
  designs::Design design;
  double spacing = 0.0;
};

std::vector<PlannedRun> plan(const designs::StudySpec& study, const Pick& pick,
                             const ConfirmOptions& options) {
  std::vector<PlannedRun> runs;
  const double finest = designs::finest_spacing(study);
  if (pick.spacing != finest)
    runs.push_back({pick.id + "-finest", stage::finest, pick.design, finest});
  if (options.spacing && *options.spacing != finest && *options.spacing != pick.spacing) {
    runs.push_back({fmt::format("{}-{:g}mm", pick.id, 1000.0 * *options.spacing), stage::spacing,
                    pick.design, *options.spacing});
  }
  int number = 0;
  for (designs::Design& near : near_designs(study, pick.design, options.repeats)) {
    runs.push_back(
        {fmt::format("{}-near-{}", pick.id, ++number), stage::near, std::move(near), finest});
  }
  return runs;
}

/// Runs of one pick, side by side down to their events.
class Confirmation {
 public:
  Confirmation(const designs::StudySpec& study, const ConfirmOptions& options,
               records::EvaluationLog& log, SimulationService& service)
      : study_(study), options_(options), log_(log), service_(service) {}

  /// Runs simulated. The log then holds all runs, unless it was cancelled.
  int run(const std::vector<PlannedRun>& runs) {
    for (const PlannedRun& one : runs) {
      if (!reuse(one)) open_.push_back({&one, DesignRun(study_, one.design, one.spacing), 0});
    }
    const std::size_t events = std::max<std::size_t>(1, study_.scenarios.size());
    const std::size_t count = open_.size() * events;
    const int threads = threads_each(count, service_.places());
    simulate_in_order(
        service_, count,
        [&](std::size_t k) { return begin(open_[k / events], k % events, threads); },
        [&](std::size_t k, records::Simulation simulation) {
          end(open_[k / events], k % events, std::move(simulation));
        },
        [&] { return cancelled(); });
    return stored_;
  }

  bool cancelled() const {
    return cancelled_ || (options_.hooks.cancelled && options_.hooks.cancelled());
  }

 private:
  struct OpenRun {
    const PlannedRun* plan;
    DesignRun run;
    std::size_t ended;
  };

  /// Whether the log answers. Another pick's run of the same design counts for this one too.
  bool reuse(const PlannedRun& one) {
    const EvaluationRecord* known = log_.find(one.design, one.spacing);
    if (known == nullptr) return false;
    EvaluationRecord record = *known;
    if (!log_.has_id(one.id)) {
      record.id = one.id;
      record.stage = one.stage;
      log_.append(record);
    }
    if (options_.hooks.on_evaluated) options_.hooks.on_evaluated(record, true);
    return true;
  }

  static std::string label(const OpenRun& open, std::size_t event) {
    const designs::Scenario* scenario = open.run.scenario(event);
    return scenario == nullptr ? open.plan->id : open.plan->id + " " + scenario->name;
  }

  std::optional<SimulationTask> begin(OpenRun& open, std::size_t event, int threads) {
    try {
      return open.run.task(event, label(open, event), threads);
    } catch (const designs::InputError& error) {
      end(open, event, impossible_scene(error.what()));
      return std::nullopt;
    }
  }

  void end(OpenRun& open, std::size_t event, records::Simulation simulation) {
    if (options_.hooks.on_simulation_ended) {
      options_.hooks.on_simulation_ended(label(open, event));
    }
    if (simulation.cancelled) {
      cancelled_ = true;
      return;
    }
    open.run.set(event, std::move(simulation));
    if (++open.ended == open.run.size()) store(open);
  }

  void store(const OpenRun& open) {
    EvaluationRecord record = open.run.record();
    record.id = open.plan->id;
    record.stage = open.plan->stage;
    records::set_program(record, options_.program);
    log_.append(record);
    ++stored_;
    if (options_.hooks.on_evaluated) options_.hooks.on_evaluated(record, false);
  }

  const designs::StudySpec& study_;
  const ConfirmOptions& options_;
  records::EvaluationLog& log_;
  SimulationService& service_;
  std::vector<OpenRun> open_;
  int stored_ = 0;
  bool cancelled_ = false;
};

Verdict verdict(const designs::StudySpec& study, const Pick& pick,
                const records::EvaluationLog& log) {
  std::vector<ConfirmationRun> runs;
  for (const EvaluationRecord& record : log.records()) {
    runs.push_back(confirmation_run(study, pick, record));
  }
  return verdict_of(pick.id, runs);
}

/// One near design; empty where it would leave the bounds or break a formula.
std::optional<designs::Design> moved(const designs::StudySpec& study, const designs::Design& pick,
                                     std::mt19937_64& generator) {
  designs::Design design = pick;
  for (const designs::Variable& variable : study.variables) {
    const bool up = (generator() >> 63) != 0;  // drawn for every variable: the rest is unmoved
    const auto found = design.find(variable.name);
    if (found == design.end() || variable.kind != designs::VariableKind::continuous) continue;
    const double step = near_share * (variable.upper - variable.lower);
    const double there = found->second + (up ? step : -step);
    const bool within = there >= variable.lower && there <= variable.upper;
    found->second = within ? there : found->second + (up ? -step : step);
  }
  for (const double violation : expression_violations(study, design)) {
    if (violation > feasibility_tolerance) return std::nullopt;
  }
  return design;
}

}  // namespace

std::vector<designs::Design> near_designs(const designs::StudySpec& study,
                                          const designs::Design& pick, int count) {
  constexpr int tries_per_design = 64;
  std::mt19937_64 generator(study.method.seed ^
                            std::stoull(designs::spec_hash(designs::Json(pick)), nullptr, 16));
  std::vector<designs::Design> designs;
  for (int k = 0; k < count * tries_per_design; ++k) {
    if (static_cast<int>(designs.size()) == count) break;
    const std::optional<designs::Design> design = moved(study, pick, generator);
    if (!design || *design == pick) continue;
    if (std::find(designs.begin(), designs.end(), *design) != designs.end()) continue;
    designs.push_back(*design);
  }
  return designs;
}

ConfirmOutcome confirm_picks(const designs::StudySpec& study, const std::vector<Pick>& picks,
                             const ConfirmOptions& options) {
  ConfirmOutcome outcome;
  std::optional<records::FolderLock> lock;
  try {
    lock.emplace(options.folder);
  } catch (const designs::InputError& error) {
    outcome.refusal = error.what();
    return outcome;
  }
  records::EvaluationLog log(options.folder / "confirmations.jsonl");
  for (const std::string& repair : log.repairs()) {
    if (options.hooks.on_message) options.hooks.on_message(repair);
  }
  const auto service = options.service(options.jobs, service_hooks(options.hooks));
  for (const Pick& pick : picks) {
    const std::size_t tried = outcome.refuted.size();
    if (tried == static_cast<std::size_t>(most_confirmed_designs)) break;
    const std::vector<PlannedRun> runs = plan(study, pick, options);
    if (options.on_pick) options.on_pick(pick, runs.size());
    Confirmation confirmation(study, options, log, *service);
    outcome.simulated += confirmation.run(runs);
    outcome.cancelled = confirmation.cancelled();
    if (outcome.cancelled) return outcome;
    if (verdict(study, pick, log) != Verdict::refuted) {
      if (verdict(study, pick, log) == Verdict::confirmed) outcome.confirmed = pick.id;
      return outcome;
    }
    outcome.refuted.push_back(pick.id);
  }
  return outcome;
}

}  // namespace parapet::study
