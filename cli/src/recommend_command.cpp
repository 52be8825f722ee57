#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "common_options.hpp"
#include "flow_records.hpp"
#include "interrupt.hpp"
#include "parapet/records/atomic_file.hpp"
#include "parapet/records/checksum_list.hpp"
#include "parapet/records/folder_lock.hpp"
#include "parapet/records/output_folder.hpp"
#include "parapet/records/result_json.hpp"
#include "parapet/reports/page.hpp"
#include "parapet/reports/recommendation_json.hpp"
#include "parapet/reports/recommendation_text.hpp"
#include "parapet/reports/study_plots.hpp"
#include "parapet/study/confirm.hpp"
#include "parapet/study/pick.hpp"
#include "parapet/study/sensitivity.hpp"
#include "run_monitor.hpp"
#include "session.hpp"

namespace parapet::cli {
namespace {

struct RecommendOptions : CommonOptions {
  std::filesystem::path folder;
  std::string rule, weights;
  std::vector<std::string> limits;
  bool no_confirm = false;
  std::optional<double> confirm_spacing_mm;
  int repeats = 2;
};

/// Whether files can be made in a folder: not in one of a read-only disk or of somebody else.
bool is_writable(const std::filesystem::path& folder) {
  return ::access(folder.c_str(), W_OK | X_OK) == 0;
}

bool same_folder(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code none;
  return std::filesystem::equivalent(a, b, none);
}

/// Where the files go: --out, or the study's folder; nowhere when that cannot be written to.
std::optional<std::filesystem::path> files_folder(const Session& session,
                                                  const RecommendOptions& options) {
  if (!options.out.empty() && !same_folder(options.out, options.folder)) {
    records::open_output_folder(options.out, records::FolderKind::advice);
    const records::FolderLock lock(options.out);
    records::take_output_folder(options.out, records::FolderKind::advice);
    return options.out;
  }
  if (is_writable(options.folder)) return options.folder;
  session.log->warn(
      "{} cannot be written to: the advice is printed and no file is written; "
      "--out DIR takes the files",
      options.folder.string());
  return std::nullopt;
}

/// Takes the sensitivities into the study and writes sensitivity.json where there is a place.
void add_sensitivity(const Session& session, study::LoadedStudy& study,
                     const std::optional<std::filesystem::path>& files) {
  std::string source;
  const designs::Json surrogates = study::study_surrogates(study.spec, study.folder, source);
  if (surrogates.is_null()) {
    session.log->info("too few designs for surrogates: no sensitivities");
    return;
  }
  study.sensitivity = study::study_sensitivity(study.spec, surrogates, source);
  if (!files) return;
  records::write_file_atomically(*files / "sensitivity.json",
                                 records::json_text(to_json(*study.sensitivity)));
}

study::ConfirmOutcome confirm(const Session& session, const RecommendOptions& options,
                              const study::LoadedStudy& study, const study::PickRule& rule) {
  std::optional<RunMonitor> monitor;
  study::ConfirmOptions confirm;
  confirm.folder = options.folder;
  if (options.confirm_spacing_mm) confirm.spacing = *options.confirm_spacing_mm / 1000.0;
  confirm.repeats = options.repeats;
  confirm.jobs = options.jobs;
  confirm.program = session.program;
  confirm.service = session.service;
  confirm.on_pick = [&](const study::Pick& pick, std::size_t runs) {
    if (runs == 0) return;
    session.log->info("confirming design {}: {} runs", pick.id, runs);
    monitor.emplace(session, static_cast<int>(runs), "runs");
  };
  confirm.hooks.cancelled = interrupted;
  confirm.hooks.on_message = [&](const std::string& sentence) {
    session.log->warn("{}", sentence);
  };
  confirm.hooks.on_simulation = [&](const std::string& id, const solver::Progress& progress) {
    monitor->running(id, progress);
  };
  confirm.hooks.on_simulation_ended = [&](const std::string& id) { monitor->simulation_ended(id); };
  confirm.hooks.on_evaluated = [&](const records::EvaluationRecord& record, bool from_log) {
    monitor->ended(record.id, from_log);
  };
  return study::confirm_picks(study.spec, study::ranked_picks(study, rule), confirm);
}

/// False when it was interrupted.
bool confirm_and_say(const Session& session, const RecommendOptions& options,
                     const study::LoadedStudy& study, const study::PickRule& rule) {
  const study::ConfirmOutcome outcome = confirm(session, options, study, rule);
  if (outcome.cancelled) {
    session.log->error("interrupted; finished runs are in {}, and the same command resumes",
                       (options.folder / "confirmations.jsonl").string());
    return false;
  }
  if (!outcome.refusal.empty()) {
    session.log->warn("nothing is simulated again while the study runs: {}", outcome.refusal);
  }
  for (const std::string& id : outcome.refuted) {
    session.log->warn("design {} did not hold when it was simulated again", id);
  }
  return true;
}

/// The list of checksums while the advice is written. It is left alone where somebody else writes
/// into the folder, or nobody may.
class AdviceChecksums {
 public:
  explicit AdviceChecksums(const std::filesystem::path& folder) : folder_(folder) {
    locked([this] {
      checksums_.emplace(folder_);
      checksums_->begin();
    });
  }
  void write() const {
    if (checksums_) {
      locked([this] { checksums_->write(); });
    }
  }

 private:
  template <typename Action>
  void locked(const Action& action) const {
    try {
      const records::FolderLock lock(folder_);
      action();
    } catch (const designs::InputError&) {
    } catch (const records::FileError&) {
    }
  }

  std::filesystem::path folder_;
  std::optional<records::ChecksumList> checksums_;
};

/// False when something was damaged.
bool say_damage(const Session& session, const study::LoadedStudy& study) {
  for (const std::string& note : study.notes) session.log->info("{}", note);
  for (const std::string& sentence : study.damage) session.log->error("{}", sentence);
  if (study.damage.empty()) return true;
  session.log->error(
      "the advice rests on what is sound; `parapet optimize` with the study's file simulates again "
      "what is damaged");
  return false;
}

/// Whether the study's designs can be simulated again with the physics that they had.
bool same_physics(const Session& session, const RecommendOptions& options,
                  const study::LoadedStudy& study) {
  const int own = session.program.physics;
  if (options.mix_revisions || std::ranges::count(study.physics, own) > 0) return true;
  if (!options.no_confirm) {
    session.log->warn(
        "nothing is simulated again: the designs were simulated with other physics than the {} of "
        "this program; --mix-revisions simulates all the same",
        own);
  }
  return false;
}

void write_files(const Session& session, const reports::Recommendation& recommendation,
                 const std::string& text, const std::filesystem::path& folder) {
  records::write_file_atomically(folder / "recommendation.json",
                                 records::json_text(reports::recommendation_json(recommendation)));
  records::write_file_atomically(folder / "recommendation.md", text);
  for (const std::string& file : reports::draw_study_plots(folder, recommendation)) {
    session.log->info("written: {}", (folder / file).string());
  }
  session.log->info("written: {} and recommendation.json", (folder / "recommendation.md").string());
}

/// Records the recommended design, so that the page can play it; false when it was interrupted.
bool record_pick(const Session& session, const RecommendOptions& options,
                 const study::LoadedStudy& study, const reports::Recommendation& recommendation) {
  if (study.spec.recordings == designs::Recordings::none || !recommendation.recommended)
    return true;
  const std::string& id = recommendation.recommended->design.id;
  const auto record = std::ranges::find(study.designs, id, &records::EvaluationRecord::id);
  if (record == study.designs.end()) return true;
  try {
    return record_and_say(session, options.folder, {study::flow_of_design(study.spec, *record)},
                          options.jobs, false);
  } catch (const designs::InputError&) {
    return true;  // the study still runs: nothing is simulated
  }
}

int recommend_command(const Session& session, const RecommendOptions& options) {
  const std::filesystem::path& folder = options.folder;
  const study::PickRule rule =
      study::parse_pick_rule(options.rule, options.weights, options.limits);
  study::LoadedStudy study = study::load_study_folder(folder);
  study::ranked_picks(study, rule);  // what is wrong with the rule is said first
  const bool sound = say_damage(session, study);
  const std::optional<std::filesystem::path> files = files_folder(session, options);
  const bool may_confirm = is_writable(folder) && same_physics(session, options, study);
  const AdviceChecksums checksums(folder);
  if (!options.no_confirm && !is_writable(folder)) {
    session.log->warn("nothing is simulated again: {} cannot be written to", folder.string());
  }
  if (!options.no_confirm && may_confirm) {
    if (!confirm_and_say(session, options, study, rule)) return exit_interrupted;
    study.confirmations = study::load_confirmations(folder);
  }
  try {
    add_sensitivity(session, study, files);
  } catch (const designs::Json::exception& error) {
    designs::throw_misread(folder / "surrogates.json", error);
  }
  const reports::Recommendation recommendation = reports::recommend(study, rule);
  const std::string text = reports::recommendation_text(recommendation);
  if (!options.no_confirm && may_confirm && !record_pick(session, options, study, recommendation)) {
    return exit_interrupted;
  }
  if (files) {
    write_files(session, recommendation, text, *files);
    const reports::FolderReport report =
        reports::study_report(study, recommendation, {.program = session.program, .rule = rule});
    records::write_file_atomically(*files / records::report_page, report.page);
    records::write_file_atomically(*files / records::designs_table, report.designs_csv);
    session.log->info("page: open {} in a browser", (*files / records::report_page).string());
  }
  checksums.write();
  if (!session.quiet) session.out->write(text);
  if (!recommendation.recommended) {
    session.log->warn(
        "no design meets every constraint and the rule's limits, so nothing is "
        "recommended");
  }
  return sound ? exit_done : exit_failed;
}

}  // namespace

void add_recommend(CLI::App& app, Session& session) {
  CLI::App* verb = app.add_subcommand("recommend", "Say which design to build, from a study's log");
  auto options = std::make_shared<RecommendOptions>();
  verb->add_option("STUDY_DIR", options->folder, "Folder of a study, as parapet optimize writes it")
      ->required();
  add_out(*verb, *options, "STUDY_DIR");
  verb->add_option("--rule", options->rule,
                   "best (the default for one objective), knee (for several; balanced where the "
                   "front has none), balanced, weights or limits")
      ->type_name("RULE");
  verb->add_option("--weights", options->weights,
                   "Rule weights: objectives with their weights, each over its range on the front")
      ->type_name("NAME=W,...");
  verb->add_option("--limit", options->limits,
                   "Rule limits: a limit on an objective; may be given again")
      ->type_name("\"NAME<=X\"")
      ->allow_extra_args(false);
  verb->add_flag("--no-confirm", options->no_confirm, "Simulate nothing");
  verb->add_option("--confirm-spacing-mm", options->confirm_spacing_mm,
                   "Simulate the design at this particle spacing too")
      ->type_name("MM")
      ->check(CLI::Range(0.2, 1000.0));
  verb->add_option("--repeats", options->repeats, "Nearly equal designs to simulate (default: 2)")
      ->type_name("N")
      ->check(CLI::Range(0, 100));
  add_mix_revisions(*verb, *options);
  add_jobs(*verb, *options, "Simulations side by side; where there are fewer, threads of each");
  verb->footer(
      R"(Prints the advice and writes recommendation.md and recommendation.json into STUDY_DIR or --out, with
sensitivity.json (which variables matter, by the surrogates) and, for several objectives, front.png
and hypervolume.png. The chosen design is simulated again with designs half a per cent of the ranges
away from it, to see how far the answer scatters; these runs are kept in confirmations.jsonl and not
repeated. What a repeat would give is stated with scatter, mean's and grid's uncertainty. If the design
breaks a constraint or is worse than predicted, the next is tried, three at most. A study that still runs can be asked
too; then nothing is simulated. A folder that cannot be written to is only read.

Examples:
  parapet recommend runs/quickstart-optimize
  parapet recommend runs/dual --rule weights --weights retention_efficiency=2,launch_length_m=1
  parapet recommend runs/dual --rule limits --limit "launch_length_m<=0.1" --confirm-spacing-mm 2.5)");
  verb->callback([options, &session] {
    session.command = [options, &session] { return recommend_command(session, *options); };
  });
}

}  // namespace parapet::cli
