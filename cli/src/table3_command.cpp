#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "common_options.hpp"
#include "duration_text.hpp"
#include "flow_records.hpp"
#include "interrupt.hpp"
#include "parapet/records/output_folder.hpp"
#include "parapet/reports/sweep_table.hpp"
#include "parapet/study/sweep_run.hpp"
#include "report_files.hpp"
#include "run_monitor.hpp"
#include "session.hpp"
#include "spec_files.hpp"
#include "text_format.hpp"

namespace parapet::cli {
namespace {

struct Table3Options : CommonOptions {
  std::string spec = "designs/table3.json";
  std::vector<std::string> only;
  bool record = false;
};

study::SweepOutcome run_rows(const Session& session, const Table3Options& options,
                             const designs::SweepSpec& sweep, const std::filesystem::path& folder) {
  const auto total = options.only.empty() ? sweep.rows.size() : options.only.size();
  RunMonitor monitor(session, static_cast<int>(total), "rows");
  study::SweepRunOptions run;
  run.folder = folder;
  run.jobs = options.jobs;
  run.only = options.only;
  run.program = session.program;
  run.service = session.service;
  run.hooks.cancelled = interrupted;
  run.hooks.on_simulation = [&](const std::string& id, const solver::Progress& progress) {
    monitor.running(id, progress);
  };
  run.hooks.on_message = [&](const std::string& text) { session.log->warn("{}", text); };
  run.on_row = [&](const records::SweepRowResult& row, bool kept) {
    monitor.ended(row.id, kept);
    if (!kept) std::filesystem::remove(folder / records::report_page);  // of fewer rows
    if (kept) {
      session.log->info("{}: finished before, not run again", row.id);
    } else {
      session.log->info("{}: {}, {} at {:.2f} s of flow, took {}", row.id,
                        solver::to_string(row.status), row.stop_reason, row.stop_time,
                        duration_text(row.wall_time));
    }
  };
  return study::run_sweep(sweep, run);
}

/// Records the rows that ended well; false when it was interrupted.
bool record_rows(const Session& session, const Table3Options& options,
                 const designs::SweepSpec& sweep, const std::filesystem::path& folder) {
  std::vector<study::FlowToRecord> flows;
  for (const designs::SweepRow& row : sweep.rows) {
    const bool wanted =
        options.only.empty() || std::ranges::find(options.only, row.id) != options.only.end();
    if (!wanted) continue;
    flows.push_back(
        {.name = row.id, .task = study::task_from_case(row.spec, row.id), .metrics = {}});
  }
  return record_and_say(session, folder, std::move(flows), options.jobs, options.only.empty());
}

int table3_command(const Session& session, const Table3Options& options) {
  const designs::SweepSpec sweep = read_sweep(options.spec, options.spacing_mm);
  const std::filesystem::path folder = output_folder(options, sweep.name, "");
  const study::SweepOutcome outcome = run_rows(session, options, sweep, folder);
  if (outcome.interrupted) {
    session.log->error("interrupted with {} rows finished in {}; the same command resumes",
                       outcome.rows.size(), folder.string());
    return exit_interrupted;
  }
  if (options.record && !record_rows(session, options, sweep, folder)) {
    session.log->error("interrupted while rows were recorded; the same command goes on");
    return exit_interrupted;
  }
  write_report(session, folder);
  session.out->print(
      "{}", reports::sweep_table_text(outcome.rows, sweep.rows.front().spec.numerics.spacing));
  session.out->print("results: {}\n", (folder / study::sweep_table_file(sweep)).string());
  int failed = 0;
  for (const records::SweepRowResult& row : outcome.rows) {
    if (row.status == solver::Status::ok) continue;
    ++failed;
    session.log->error("row {} failed: {}", row.id, row.reason);
  }
  return failed == 0 ? exit_done : exit_failed;
}

}  // namespace

void add_table3(CLI::App& app, Session& session) {
  CLI::App* verb = app.add_subcommand(
      "table3", "Simulate the rows of the source paper's Table 3, or of another sweep");
  auto options = std::make_shared<Table3Options>();
  verb->add_option("SWEEP", options->spec, "Sweep file (default: designs/table3.json)");
  add_out(*verb, *options, "runs/NAME of the sweep");
  add_spacing(*verb, *options);
  add_jobs(*verb, *options, "Rows simulated side by side; where there are fewer, threads of each");
  verb->add_option("--only", options->only, "Only the rows of these ids")
      ->delimiter(',')
      ->type_name("ID,ID");
  verb->add_flag("--record", options->record,
                 "Simulate the rows once more at the end and record their flows, to be played in "
                 "the report");
  verb->footer(
      R"(Writes rows/ID.json for each row and table3.json with all of them, and prints a table with the
published value beside the computed one. Rows that are finished are not run again: the same command
resumes.

Examples:
  parapet table3
  parapet table3 --only H10-WD,H10-D45 --spacing-mm 10
  parapet table3 my_sweep.json --jobs 4)");
  verb->callback([options, &session] {
    session.command = [options, &session] { return table3_command(session, *options); };
  });
}

}  // namespace parapet::cli
