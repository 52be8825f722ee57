#include "caveats.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "parapet/study/comparable.hpp"
#include "parapet/study/confirmation.hpp"

namespace parapet::reports {
namespace {

using records::EvaluationRecord;
using study::LoadedStudy;
using Sentences = std::vector<std::string>;

/// What the run of the recommended design says against its own numbers.
void add_warnings(Sentences& list, const LoadedStudy& study, const DesignReport* best) {
  int warned = 0, simulated = 0;
  for (const EvaluationRecord& design : study.designs) {
    if (!design.ok) continue;
    ++simulated;
    warned += design.warnings.empty() ? 0 : 1;
    if (best == nullptr || design.id != best->id) continue;
    for (const solver::Warning& warning : design.warnings) {
      list.push_back(
          fmt::format("The run of the recommended design warns: {} ({} = {:.3g}, limit {:.3g}).",
                      warning.text, warning.key, warning.value, warning.limit));
    }
  }
  if (warned > 0) {
    list.push_back(fmt::format("{} of {} runs carry warnings; evaluations.jsonl has them.", warned,
                               simulated));
  }
}

void add_unfinished(Sentences& list, const LoadedStudy& study, const DesignReport* best) {
  int unsettled = 0, simulated = 0;
  for (const EvaluationRecord& design : study.designs) {
    if (!design.ok) continue;
    ++simulated;
    unsettled += study.unsettled.contains(design.id) ? 1 : 0;
  }
  if (unsettled > 0) {
    const bool chosen = best != nullptr && study.unsettled.contains(best->id);
    list.push_back(fmt::format(
        "{} of {} runs{} ended at the stop time while the flow had not settled: retention and "
        "launch length may not be final. Allow a longer stop_time_s.",
        unsettled, simulated, chosen ? ", that of the recommended design among them," : ""));
  }
  if (study.state == "running" || study.state == "interrupted") {
    list.push_back(
        fmt::format("The study is not finished (its state is \"{}\"): the same optimize command "
                    "continues it.",
                    study.state));
  }
}

/// How many lines of confirmations.jsonl there are for a design with a stage.
int confirmed_runs(const LoadedStudy& study, const DesignReport* best, const char* stage) {
  int count = 0;
  for (const EvaluationRecord& run : study.confirmations) {
    count += best != nullptr && study::confirms(run.id, best->id) && run.stage == stage ? 1 : 0;
  }
  return count;
}

void add_spacings(Sentences& list, const LoadedStudy& study, const DesignReport* best) {
  std::set<double> spacings;
  for (const EvaluationRecord& design : study.designs) {
    if (design.ok) spacings.insert(design.spacing);
  }
  if (spacings.empty()) return;
  const bool refined = confirmed_runs(study, best, study::confirmation_stage::spacing) > 0;
  const std::string advice =
      refined ? "Results still change with refinement; how much, the run of the recommended design "
                "at another spacing shows."
              : "Results still change with refinement, so check the chosen design at a finer "
                "spacing (--confirm-spacing-mm) before relying on a margin.";
  const double counted = study::counted_spacing(study);
  if (spacings.size() == 1) {
    list.push_back(fmt::format("All designs were simulated at one particle spacing, {:g} mm. {}",
                               1000.0 * *spacings.begin(), advice));
  } else {
    list.push_back(fmt::format("Only designs at a particle spacing of {:g} mm are compared. {}",
                               1000.0 * counted, advice));
  }
  if (designs::finest_spacing(study.spec) < counted) {
    list.push_back(
        "No design was simulated at the study's finest spacing yet; those at the finest one used "
        "stand in for it.");
  }
}

void add_scatter(Sentences& list, const LoadedStudy& study, const DesignReport* best) {
  const int near = confirmed_runs(study, best, study::confirmation_stage::near);
  const std::string known =
      near > 0 ? fmt::format(
                     "How far a result moves under tiny changes is known from {} run{} near "
                     "the recommended design only.",
                     near, near == 1 ? "" : "s")
               : std::string(
                     "How far a result moves under tiny changes of the start has not been measured "
                     "for this study; close designs in its log show it.");
  list.push_back("The flow is chaotic after the impact. " + known +
                 " The best of many scattered values is also a little too good on average.");
}

bool uses_loads(const designs::StudySpec& study) {
  const auto is_load = [](const auto& one) {
    return one.metric.find("_force_") != std::string::npos ||
           one.metric.find("_moment_") != std::string::npos;
  };
  return std::ranges::any_of(study.objectives, is_load) ||
         std::ranges::any_of(study.constraints, is_load);
}

}  // namespace

std::vector<std::string> caveats(const LoadedStudy& study, const DesignReport* best) {
  Sentences list;
  add_warnings(list, study, best);
  add_unfinished(list, study, best);
  add_spacings(list, study, best);
  list.push_back(
      "The model is two-dimensional (a slice per metre width): flow around the barrier's "
      "ends, side walls and uneven beds are not in it.");
  list.push_back(
      "The model is not validated against measured debris flows: its measured cases are of water, "
      "those of debris are exact answers and the simulations of a paper.");
  add_scatter(list, study, best);
  if (uses_loads(study.spec)) {
    list.push_back(
        "A force or moment decides here. Loads scatter more than volumes between nearly equal "
        "designs, the slam by tens of per cent at coarse spacings.");
  }
  const bool scenarios = std::ranges::any_of(
      study.designs, [](const EvaluationRecord& design) { return design.scenarios.size() > 1; });
  list.push_back(scenarios
                     ? "Only the scenarios listed were simulated; their weights are an input, and "
                       "the ranking of designs can change with them."
                     : "One debris material and one release volume were simulated; the ranking of "
                       "designs can change for others.");
  if (best != nullptr) {
    for (const VariableResult& variable : best->variables) {
      if (variable.at_bound == Bound::none) continue;
      list.push_back(
          fmt::format("{} lies at its {} bound: a wider range might give a better design.",
                      variable.name, variable.at_bound == Bound::lower ? "lower" : "upper"));
    }
  }
  if (!study.log_complete) {
    list.push_back(
        "The last line of the log is not complete (the study was stopped, or is still "
        "running); it was left out. Running the study again finishes it.");
  }
  return list;
}

}  // namespace parapet::reports
