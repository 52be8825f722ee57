#include <chrono>
#include <filesystem>
#include <memory>

#include "common_options.hpp"
#include "interrupt.hpp"
#include "parapet/records/atomic_file.hpp"
#include "parapet/records/study_folder.hpp"
#include "parapet/study/design_run.hpp"
#include "parapet/study/local_service.hpp"
#include "run_monitor.hpp"
#include "session.hpp"
#include "spec_files.hpp"

namespace parapet::cli {
namespace {

using records::EvaluationRecord;

struct EvaluateOptions : CommonOptions {
  std::string spec;
  std::string design;
  std::string log_folder;
};

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
  EvaluationRecord record = run.record();
  record.id = records::evaluation_id(1);
  record.stage = "external";
  records::set_program(record, session.program);
  if (options.log_folder.empty()) return record;
  records::StudyFolder folder(options.log_folder, study, session.program,
                              {log_patience, options.mix_revisions});
  if (const auto* known = folder.log().find(record.design, record.spacing)) return *known;
  int number = static_cast<int>(folder.log().records().size()) + 1;
  while (!folder.id_is_free(records::evaluation_id(number), record.design, record.spacing)) {
    ++number;
  }
  record.id = records::evaluation_id(number);
  const designs::Json provenance = records::study_provenance(study, session.program);
  for (std::size_t event = 0; event < run.size(); ++event) {
    const designs::Scenario* scenario = run.scenario(event);
    if (scenario == nullptr) continue;
    folder.store_simulation(record.id, run.design(), run.spacing(), *scenario,
                            run.simulation(event).value(), provenance);
  }
  folder.store(record, run.report(session.program));
  folder.close_after(record);
  return record;
}

int evaluate_command(const Session& session, const EvaluateOptions& options) {
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
  verb->add_option("--design", options->design,
                   "The design: JSON, @FILE, or - for standard input; a value for every active "
                   "variable, an option's name for a choice")
      ->required()
      ->type_name("JSON");
  verb->add_option("--log", options->log_folder,
                   "Study folder whose log answers for designs it holds and takes new ones")
      ->type_name("DIR");
  add_mix_revisions(*verb, *options);
  add_spacing(*verb, *options);
  add_jobs(*verb, *options,
           "Scenarios simulated side by side; where there are fewer, threads of each");
  verb->footer(
      R"(Prints one JSON object on standard output (the line that the log of a study has) and nothing else;
messages go to standard error. A failed simulation is reported in the object and by exit code 1. A
design that violates the study's constraints is evaluated all the same.

Examples:
  parapet evaluate my_study.json --design '{"deflector_angle_deg": 45}'
  parapet evaluate my_study.json --design @design.json --log runs/outside
  echo '{"deflector_angle_deg": 45}' | parapet evaluate my_study.json --design - --quiet)");
  verb->callback([options, &session] {
    session.command = [options, &session] { return evaluate_command(session, *options); };
  });
}

}  // namespace parapet::cli
