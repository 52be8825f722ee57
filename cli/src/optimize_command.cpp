#include <fmt/format.h>

#include <memory>

#include "common_options.hpp"
#include "duration_text.hpp"
#include "flow_records.hpp"
#include "interrupt.hpp"
#include "page_server.hpp"
#include "parapet/records/output_folder.hpp"
#include "parapet/study/design_run.hpp"
#include "parapet/study/study_run.hpp"
#include "parapet/study/undisturbed.hpp"
#include "report_files.hpp"
#include "run_monitor.hpp"
#include "session.hpp"
#include "spec_files.hpp"
#include "text_format.hpp"

namespace parapet::cli {
namespace {

struct OptimizeOptions : CommonOptions {
  std::string spec;
  bool serve = false;
};

/// "front of 5 designs, hypervolume 0.31".
std::string front_text(int designs, double hypervolume) {
  return fmt::format("front of {} design{}, hypervolume {:.4g}", designs, designs == 1 ? "" : "s",
                     hypervolume);
}

std::string outcome_text(const records::EvaluationRecord& record) {
  if (!record.ok) return "failed: " + record.reason;
  const std::string violated = violated_text(record);
  std::string warned;
  for (const solver::Warning& warning : record.warnings) {
    warned += (warned.empty() ? "; warns of " : ", ") + warning.key;
  }
  return objectives_text(record) + (violated.empty() ? "" : ", not feasible: " + violated) + warned;
}

/// "0007 (search, 5 mm)".
std::string heading(const records::EvaluationRecord& record) {
  return fmt::format("{} ({}, {:g} mm)", record.id, record.stage, 1000.0 * record.spacing);
}

/// Shows on the monitor how far a study is.
class Progress {
 public:
  Progress(const Session& session, const designs::StudySpec& study, std::string folder)
      : session_(session),
        several_objectives_(study.objectives.size() > 1),
        finest_(designs::finest_spacing(study)),
        folder_(std::move(folder)),
        monitor_(session, study.method.max_evaluations, "designs") {}

  study::Hooks hooks() {
    study::Hooks hooks;
    hooks.cancelled = interrupted;
    hooks.on_message = [this](const std::string& text) { session_.log->warn("{}", text); };
    hooks.on_simulation = [this](const std::string& id, const solver::Progress& progress) {
      monitor_.running(id, progress);
    };
    hooks.on_simulation_ended = [this](const std::string& id) { monitor_.simulation_ended(id); };
    hooks.on_front = [this](int designs, double hypervolume) {
      if (several_objectives_) monitor_.best(front_text(designs, hypervolume));
    };
    hooks.on_evaluated = [this](const records::EvaluationRecord& record, bool from_log) {
      evaluated(record, from_log);
    };
    return hooks;
  }

 private:
  void evaluated(const records::EvaluationRecord& record, bool from_log) {
    monitor_.ended(record.id, from_log);
    if (from_log && from_log_count_++ == 0) {
      session_.log->info("resuming: designs in {} are not simulated again", folder_);
    }
    const bool counts = record.feasible && record.spacing == finest_ && record.objective_scalar;
    if (!several_objectives_ && counts && (!best_ || *record.objective_scalar < *best_)) {
      best_ = record.objective_scalar;
      monitor_.best("best " + objectives_text(record) + " (" + record.id + ")");
    }
    if (!from_log && new_count_++ == 0) records::remove_earlier_advice(folder_);
    if (!from_log) {
      session_.log->info("{}: {}: {}", heading(record), design_text(record), outcome_text(record));
    }
  }

  const Session& session_;
  bool several_objectives_;
  double finest_;
  std::string folder_;
  RunMonitor monitor_;
  std::optional<double> best_;
  int from_log_count_ = 0, new_count_ = 0;
};

study::StudySummary run_with_progress(const Session& session, const OptimizeOptions& options,
                                      const designs::StudySpec& study,
                                      const std::filesystem::path& folder) {
  Progress progress(session, study, folder.string());
  study::StudyRunOptions run;
  run.folder = folder;
  run.jobs = options.jobs;
  run.program = session.program;
  run.mix_physics = options.mix_revisions;
  run.hooks = progress.hooks();
  run.service = session.service;
  run.undisturbed = true;
  return study::run_study(study, run);
}

void print_best(const Session& session, const study::StudySummary& summary) {
  if (summary.best) {
    session.out->print("best feasible design\n{}", record_text(*summary.best));
  } else {
    session.out->print("no design meets every constraint\n");
  }
  if (summary.starting_best) {
    session.out->print("best of the starting designs\n{}", record_text(*summary.starting_best));
  }
}

void print_front(const Session& session, const study::StudySummary& summary,
                 const designs::StudySpec& study) {
  if (summary.pareto.empty()) {
    session.out->print("no design meets every constraint\n");
    return;
  }
  session.out->print("{}: no feasible design dominates one of these\n{}",
                     front_text(static_cast<int>(summary.pareto.size()), summary.hypervolume),
                     front_table(study, summary.pareto));
}

void print_summary(const Session& session, const study::StudySummary& summary,
                   const designs::StudySpec& study, const std::filesystem::path& folder) {
  session.out->print(
      "{}: {} ({}), {} designs evaluated ({} by this run in {}), {} rejected without simulation\n",
      study.name, study::to_string(summary.state), summary.message, summary.evaluations,
      summary.simulated, duration_text(summary.elapsed), summary.rejected);
  if (study.objectives.size() > 1) {
    print_front(session, summary, study);
  } else {
    print_best(session, summary);
  }
  session.out->print("results: {}\nadvice:  parapet recommend {}\n", folder.string(),
                     folder.string());
}

/// Records what the study asks for; false when it was interrupted.
bool record_front(const Session& session, const OptimizeOptions& options, designs::StudySpec study,
                  const std::filesystem::path& folder) {
  study.undisturbed = study::read_undisturbed(folder, study);  // as in the runs that are logged
  const auto log = records::read_evaluation_log(folder / "evaluations.jsonl");
  std::vector<study::FlowToRecord> flows;
  for (const records::EvaluationRecord& record : study::designs_to_record(study, log.records)) {
    flows.push_back(study::flow_of_design(study, record));
  }
  return record_and_say(session, folder, std::move(flows), options.jobs);
}

int optimize_command(const Session& session, const OptimizeOptions& options) {
  const designs::StudySpec study = read_study(options.spec, options.spacing_mm);
  const std::filesystem::path folder = output_folder(options, study.name, "optimize");
  std::optional<PageServer> server;
  if (options.serve) {
    server.emplace(folder, session.program, 0);
    session.log->info("live page: {}", server->address());
  }
  const study::StudySummary summary = run_with_progress(session, options, study, folder);
  if (summary.state == study::StudyState::interrupted) {
    session.log->error("interrupted with {} designs evaluated in {}; the same command resumes",
                       summary.evaluations, folder.string());
    return exit_interrupted;
  }
  if (summary.state == study::StudyState::failed) {
    session.log->error("the study failed: {}", summary.message);
    return exit_failed;
  }
  if (!record_front(session, options, study, folder)) {
    session.log->error("interrupted while the front was recorded; the same command goes on");
    return exit_interrupted;
  }
  write_report(session, folder);
  print_summary(session, summary, study, folder);
  return exit_done;
}

}  // namespace

void add_optimize(CLI::App& app, Session& session) {
  CLI::App* verb = app.add_subcommand("optimize", "Search for the best design of a study");
  auto options = std::make_shared<OptimizeOptions>();
  verb->add_option("SPEC", options->spec, "Study file, or the name of a shipped one")->required();
  add_out(*verb, *options, "runs/NAME-optimize");
  add_spacing(*verb, *options);
  add_jobs(*verb, *options, "Simulations side by side");
  add_mix_revisions(*verb, *options);
  verb->add_flag("--serve", options->serve,
                 "Show the page live on this machine while the study runs, and print its address");
  verb->footer(
      R"(Writes study.json, evaluations.jsonl (one line per design), evaluations/ID.json, summary.json,
pareto.json and, with the algorithm BAYESIAN, surrogates.json into DIR. The same command resumes a
study that was interrupted: no design is simulated twice. It may then have a larger
method/max_evaluations, max_time_s or max_cpu_time_s; with any other change it is another study and
needs another folder.

BAYESIAN and the designs of experiments keep all jobs busy, each simulation on one thread. Which
designs BAYESIAN tries depends on the number of jobs with which the study was begun, and on nothing
else; where the spec sets method/repeatable to false, also on how fast each simulation is. NLopt's
algorithms try one design at a time after the starting ones; its simulations then share the jobs as
threads.

Examples:
  parapet optimize designs/quickstart.json
  parapet optimize my_study.json --out runs/first-try --jobs 2
  parapet optimize my_study.json --spacing-mm 10)");
  verb->callback([options, &session] {
    session.command = [options, &session] { return optimize_command(session, *options); };
  });
}

}  // namespace parapet::cli
