#include <fmt/format.h>

#include <memory>

#include "common_options.hpp"
#include "interrupt.hpp"
#include "parapet/study/study_run.hpp"
#include "run_monitor.hpp"
#include "session.hpp"
#include "spec_files.hpp"
#include "text_format.hpp"

namespace parapet::cli {
namespace {

struct OptimizeOptions : CommonOptions {
  std::string spec;
};

std::string outcome_text(const reports::EvaluationRecord& record) {
  if (!record.ok) return "failed: " + record.reason;
  return objectives_text(record) + (record.feasible ? "" : ", not feasible");
}

study::StudySummary run_with_progress(const Session& session, const OptimizeOptions& options,
                                      const designs::StudySpec& study,
                                      const std::filesystem::path& folder) {
  RunMonitor monitor(session, study.method.max_evaluations, "designs");
  std::optional<double> best;
  int from_log_count = 0;
  study::StudyRunOptions run;
  run.folder = folder;
  run.jobs = options.jobs;
  run.program = session.program;
  run.hooks.cancelled = interrupted;
  run.hooks.on_message = [&](const std::string& sentence) { session.log->warn("{}", sentence); };
  run.hooks.on_simulation = [&](const std::string& id, const solver::Progress& progress) {
    monitor.running(id, progress);
  };
  run.hooks.on_evaluated = [&](const reports::EvaluationRecord& record, bool from_log) {
    monitor.ended(record.id, from_log);
    if (from_log && from_log_count++ == 0) {
      session.log->info("resuming: designs in {} are not simulated again", folder.string());
    }
    if (record.feasible && (!best || *record.objective_scalar < *best)) {
      best = record.objective_scalar;
      monitor.best(objectives_text(record) + " (" + record.id + ")");
    }
    if (!from_log) {
      session.log->info("{} {}: {}", record.id, design_text(record.design), outcome_text(record));
    }
  };
  return study::run_study(study, run);
}

void print_summary(const study::StudySummary& summary, const designs::StudySpec& study,
                   const std::filesystem::path& folder) {
  fmt::print("{}: {} ({}), {} designs evaluated ({} by this run in {}), {} refused unsimulated\n",
             study.name, study::to_string(summary.state), summary.message, summary.evaluations,
             summary.simulated, duration_text(summary.elapsed), summary.rejected);
  if (summary.best) {
    fmt::print("best feasible design\n{}", record_text(*summary.best));
  } else {
    fmt::print("no design meets every constraint\n");
  }
  if (summary.starting_best) {
    fmt::print("best of the starting designs\n{}", record_text(*summary.starting_best));
  }
  fmt::print("results: {}\nadvice:  parapet recommend {}\n", folder.string(), folder.string());
}

int optimize_command(const Session& session, const OptimizeOptions& options) {
  const designs::StudySpec study = read_study(options.spec, options.spacing_mm);
  const std::filesystem::path folder = output_folder(options, study.name, "optimize");
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
  print_summary(summary, study, folder);
  return exit_done;
}

}  // namespace

void add_optimize(CLI::App& app, Session& session) {
  CLI::App* verb = app.add_subcommand("optimize", "Search for the best design of a study");
  auto options = std::make_shared<OptimizeOptions>();
  verb->add_option("SPEC", options->spec, "Study file, or the name of a shipped one")->required();
  add_out(*verb, *options, "runs/NAME-optimize");
  add_spacing(*verb, *options);
  add_jobs(*verb, *options, "Starting designs simulated side by side, then threads of each");
  verb->footer(
      R"(Writes study.json, evaluations.jsonl (one line per design), evaluations/ID.json and summary.json
into DIR. The same command resumes a study that was interrupted: no design is simulated twice. It
may then have a larger method/max_evaluations or max_time_s; with any other change it is another
study and needs another folder.

Examples:
  parapet optimize designs/quickstart.json
  parapet optimize my_study.json --out runs/first-try --jobs 2
  parapet optimize my_study.json --spacing-mm 10)");
  verb->callback([options, &session] {
    session.command = [options, &session] { return optimize_command(session, *options); };
  });
}

}  // namespace parapet::cli
