#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "common_options.hpp"
#include "duration_text.hpp"
#include "interrupt.hpp"
#include "parapet/designs/error.hpp"
#include "parapet/records/atomic_file.hpp"
#include "parapet/records/output_folder.hpp"
#include "parapet/validation/suite.hpp"
#include "report_files.hpp"
#include "run_monitor.hpp"
#include "session.hpp"

namespace parapet::cli {
namespace {

struct ValidateOptions : CommonOptions {
  std::vector<std::string> cases;
  bool quick = false;
  bool list = false;
  bool strict = false;
  bool pages_only = false;
};

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    if (!text.empty()) text += " ";
    text += name;
  }
  return text;
}

void list_cases(const Session& session) {
  for (const validation::CaseInfo& c : validation::list_cases()) {
    session.out->print("{:<20} {}\n", c.name, c.title);
  }
}

/// @throws designs::InputError, so that nothing is begun
void require_known(const std::vector<std::string>& names) {
  const auto cases = validation::list_cases();
  for (const std::string& name : names) {
    if (std::ranges::find(cases, name, &validation::CaseInfo::name) != cases.end()) continue;
    throw designs::InputError(
        {{"CASE", "", name, "is not a case", "the names that parapet validate --list prints"}});
  }
}

validation::SuiteOutcome run_cases(const Session& session, const ValidateOptions& options,
                                   const std::filesystem::path& folder) {
  RunMonitor monitor(session, 1, "");
  validation::SuiteOptions suite;
  suite.folder = folder;
  suite.only = options.cases;
  suite.full = !options.quick;
  suite.jobs = options.jobs;
  suite.cancelled = interrupted;
  suite.on_progress = [&](double done, double total) { monitor.share(done / total); };
  suite.on_case = [&](const validation::Scorecard& card, double seconds) {
    session.log->info("{}: {} limits met, {} missed{}, took {}", card.name,
                      card.count(validation::Verdict::met), card.count(validation::Verdict::missed),
                      card.failure.empty() ? "" : ", FAILED", duration_text(seconds));
  };
  return validation::run_suite(suite);
}

void write_pages(const Session& session, const std::filesystem::path& folder) {
  for (const validation::Page& page : validation::pages(folder)) {
    records::write_file_atomically(folder / page.file, page.text);
  }
  session.out->print("pages: {}\n", (folder / "README.md").string());
  write_report(session, folder);
}

int validate_command(const Session& session, const ValidateOptions& options) {
  if (options.list) {
    list_cases(session);
    return exit_done;
  }
  const std::filesystem::path folder =
      !options.out.empty() ? options.out
                           : (options.quick ? "runs/validation-quick" : "docs/validation");
  require_known(options.cases);
  const bool is_new = !std::filesystem::exists(folder) || std::filesystem::is_empty(folder);
  records::open_output_folder(folder, records::FolderKind::validation);
  if (options.pages_only) {
    write_pages(session, folder);
    return exit_done;
  }
  if (is_new) records::take_output_folder(folder, records::FolderKind::validation);
  const validation::SuiteOutcome outcome = run_cases(session, options, folder);
  session.out->print("{}", validation::scorecard_text(outcome.cards));
  if (options.quick) {
    write_report(session, folder);
  } else {
    write_pages(session, folder);
  }
  if (!outcome.unfinished.empty()) {
    session.log->error("interrupted; continue with: parapet validate {}",
                       joined(outcome.unfinished));
    return exit_interrupted;
  }
  int failed = 0, missed = 0;
  for (const validation::Scorecard& card : outcome.cards) {
    failed += card.failure.empty() ? 0 : 1;
    missed += card.count(validation::Verdict::missed);
  }
  return failed > 0 || (options.strict && missed > 0) ? exit_failed : exit_done;
}

}  // namespace

void add_validate(CLI::App& app, Session& session) {
  CLI::App* verb = app.add_subcommand(
      "validate", "Verify and validate the solver: exact, measured and published answers");
  auto options = std::make_shared<ValidateOptions>();
  verb->add_option("CASE", options->cases, "Only these cases (default: all; see --list)");
  add_out(*verb, *options, "docs/validation; with --quick runs/validation-quick");
  add_jobs(*verb, *options, "Flows simulated side by side");
  verb->add_flag("--quick", options->quick, "Coarse versions that take seconds each");
  verb->add_flag("--list", options->list, "Name the cases and stop");
  verb->add_flag("--strict", options->strict, "Exit code 1 when a limit is missed");
  verb->add_flag("--pages-only", options->pages_only,
                 "Write the pages again from the existing scorecards");
  verb->footer(
      R"(Prints a scorecard of measured values beside their limits, and writes CASE.json, plots and flow
pictures of each case, CASE.md for each and README.md, the pages made of them, and report.html, where cases and verdicts can be
filtered. Cases that have ended are kept when the
suite is interrupted.

Examples:
  parapet validate --list
  parapet validate dam_break --out runs/dam_break
  parapet validate --quick)");
  verb->callback([options, &session] {
    session.command = [options, &session] {
      try {
        return validate_command(session, *options);
      } catch (const std::invalid_argument& error) {
        session.log->error("{}", error.what());
        return static_cast<int>(exit_bad_input);
      }
    };
  });
}

}  // namespace parapet::cli
