#include <chrono>
#include <filesystem>
#include <memory>

#include "evaluate_options.hpp"
#include "interrupt.hpp"
#include "parapet/records/atomic_file.hpp"
#include "parapet/records/study_folder.hpp"
#include "parapet/study/design_run.hpp"
#include "parapet/study/external_record.hpp"
#include "parapet/study/local_service.hpp"
#include "run_monitor.hpp"
#include "session.hpp"
#include "spec_files.hpp"

namespace parapet::cli {
namespace {

using records::EvaluationRecord;

/// The text of --design and what to call it in messages.
std::pair<std::string, std::string> design_source(const std::string& argument) {
  if (argument == "-") {
    return {read_standard_input(), "--design - (standard input)"};
  }
  if (argument.starts_with('@')) {
    const std::string file = argument.substr(1);
    if (!std::filesystem::exists(file)) {
      throw designs::InputError(
          {{"--design", "", argument, "cannot read " + file + ": there is no such file",
            "a JSON file"}});
    }
    return {records::read_file(file), file};
  }
  return {argument, "--design"};
}

designs::Design read_design(const designs::StudySpec& study, const std::string& argument) {
  const auto [text, source] = design_source(argument);
  designs::DesignReading reading =
      designs::read_design(study, designs::parse_json(text, source), source);
  if (!reading.issues.empty()) throw designs::InputError(std::move(reading.issues));
  return std::move(reading.design);
}

/// Access to a shared log: held only for a moment, so that several evaluations may run at once.
constexpr std::chrono::seconds log_patience{20};

std::optional<EvaluationRecord> find_logged(const Session& session, const EvaluateOptions& options,
                                            const designs::StudySpec& study,
                                            const designs::Design& design) {
  if (options.log_folder.empty()) return std::nullopt;
  const records::StudyFolder folder(options.log_folder, study, session.program,
                                    {log_patience, options.mix_revisions});
  for (const std::string& note : folder.notes()) session.log->warn("{}", note);
  const EvaluationRecord* known = folder.log().find(design, designs::finest_spacing(study));
  return known == nullptr ? std::nullopt : std::optional(*known);
}

/// Gives the record its id; the one already there when another process was faster.
EvaluationRecord store(const Session& session, const EvaluateOptions& options,
                       const designs::StudySpec& study, const study::DesignRun& run) {
  if (options.log_folder.empty()) return study::external_record(run, session.program);
  records::StudyFolder folder(options.log_folder, study, session.program,
                              {log_patience, options.mix_revisions});
  EvaluationRecord record =
      study::log_external(folder, study, run, session.program, !options.no_report);
  folder.close_after(record);
  return record;
}

int evaluate_command(const Session& session, const EvaluateOptions& options) {
  if (options.stream) return evaluate_stream(session, options);
  const designs::StudySpec study = read_study(options.spec, options.spacing_mm);
  const designs::Design design = read_design(study, options.design);
  std::optional<EvaluationRecord> record = find_logged(session, options, study, design);
  if (!record) {
    RunMonitor monitor(session, 1, "");
    study::ServiceHooks hooks;
    hooks.cancelled = interrupted;
    hooks.on_progress = [&](const study::SimulationTask& task, const solver::Progress& progress) {
      monitor.running(task.label, progress);
    };
    const auto service = study::local_service()(options.jobs, hooks);
    const auto run = study::run_design(study, design, designs::finest_spacing(study), *service);
    if (!run) {
      session.log->error("interrupted; nothing was logged");
      return exit_interrupted;
    }
    record = store(session, options, study, *run);
  }
  session.out->print("{}\n", records::log_line(*record));
  if (record->ok) return exit_done;
  session.log->error("the evaluation failed: {}", record->reason);
  return exit_failed;
}

}  // namespace

void add_evaluate(CLI::App& app, Session& session) {
  CLI::App* verb =
      app.add_subcommand("evaluate", "Evaluate one design of a study, for other optimisers");
  auto options = std::make_shared<EvaluateOptions>();
  verb->add_option("SPEC", options->spec, "Study file, or the name of a shipped one")->required();
  CLI::Option* design =
      verb->add_option("--design", options->design,
                       "The design: JSON, @FILE, or - for standard input; a value for every active "
                       "variable, an option's name for a choice")
          ->type_name("JSON");
  verb->add_flag("--stdin-jsonl", options->stream,
                 "Many designs: one on each line of standard input, one record on each line of "
                 "standard output, as each ends")
      ->excludes(design);
  verb->add_option("--log", options->log_folder,
                   "Study folder whose log answers for designs it holds and takes new ones")
      ->type_name("DIR");
  verb->add_flag("--no-report", options->no_report,
                 "With --log: no evaluations/ID.json (series and details), the log's lines alone");
  add_mix_revisions(*verb, *options);
  add_spacing(*verb, *options);
  add_jobs(*verb, *options,
           "Simulations side by side; of one design alone the scenarios, and where there are "
           "fewer, threads of each");
  verb->footer(
      R"(Prints one JSON object on standard output (the line that the log of a study has) and nothing else;
messages go to standard error. A failed simulation is reported in the object and by exit code 1. A
design that violates the study's constraints is evaluated all the same.

With --stdin-jsonl a line is a design, or {"design": {...}, "id": ..., "scenario": NAME, "spacing_mm":
X} with the last three as wanted: the id comes back in the record (else the line's number), a scenario
makes that event the only one. A line that is wrong gets a record with "status": "error" and its
issues. The verb ends at the end of the input, with exit code 0 when every line was answered.

Examples:
  parapet evaluate my_study.json --design '{"deflector_angle_deg": 45}'
  parapet evaluate my_study.json --design @design.json --log runs/outside
  echo '{"deflector_angle_deg": 45}' | parapet evaluate my_study.json --design - --quiet
  parapet evaluate my_study.json --stdin-jsonl --jobs 4 < designs.jsonl > records.jsonl)");
  verb->callback([options, &session] {
    if (options->design.empty() && !options->stream) {
      throw CLI::RequiredError("--design or --stdin-jsonl");
    }
    session.command = [options, &session] { return evaluate_command(session, *options); };
  });
}

}  // namespace parapet::cli
