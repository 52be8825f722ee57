#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <set>

#include "common_options.hpp"
#include "interrupt.hpp"
#include "parapet/study/local_service.hpp"
#include "parapet/study/verify.hpp"
#include "run_monitor.hpp"
#include "session.hpp"

namespace parapet::cli {
namespace {

struct VerifyOptions : CommonOptions {
  std::filesystem::path folder;
  int count = 3;
  bool all = false;
};

/// Another program made the numbers: what differs may be its doing.
void name_other_programs(const Session& session, const std::vector<study::StoredRun>& runs) {
  const std::string own =
      session.program.version +
      (session.program.git_revision.empty() ? "" : " (" + session.program.git_revision + ")");
  std::set<std::string> others;
  for (const study::StoredRun& run : runs) {
    if (!run.program.empty() && run.program != own) others.insert(run.program);
  }
  for (const std::string& other : others) {
    session.log->info("made by parapet {}; this is {}", other, own);
  }
}

void print_run(const Session& session, const study::StoredRun& run,
               const study::VerifiedRun& verified) {
  if (verified.differences.empty()) {
    session.out->print("{:<20} same, {} metrics\n", run.label, run.metrics.size());
    return;
  }
  session.out->print("{:<20} DIFFERS\n", run.label);
  for (const study::Difference& one : verified.differences) {
    session.out->print("    {}: stored {}, now {}\n", one.key, one.stored, one.now);
  }
}

int verify_command(const Session& session, const VerifyOptions& options) {
  const std::vector<study::StoredRun> runs = study::stored_runs(options.folder);
  const auto chosen = study::spread_sample(
      runs.size(), options.all ? runs.size() : static_cast<std::size_t>(options.count));
  name_other_programs(session, runs);
  const std::vector<std::string> damage = study::folder_damage(options.folder);
  for (const std::string& sentence : damage) session.log->error("{}", sentence);
  std::optional<std::vector<study::VerifiedRun>> verified;
  {
    RunMonitor monitor(session, static_cast<int>(chosen.size()), "simulations");
    study::ServiceHooks hooks;
    hooks.cancelled = interrupted;
    hooks.on_progress = [&](const study::SimulationTask& task, const solver::Progress& progress) {
      monitor.running(task.label, progress);
    };
    const auto service = study::local_service()(options.jobs, hooks);
    verified = study::verify_runs(runs, chosen, *service, [&](const study::VerifiedRun& one) {
      monitor.ended(runs[one.index].label, false);
    });
  }
  if (!verified) {
    session.log->error("interrupted; nothing in the folder was changed");
    return exit_interrupted;
  }
  std::size_t n_same = 0;
  for (const study::VerifiedRun& one : *verified) {
    print_run(session, runs[one.index], one);
    if (one.differences.empty()) ++n_same;
  }
  session.out->print("{} of {} simulations run again, of {} in {}: {}\n", n_same, verified->size(),
                     runs.size(), options.folder.string(),
                     n_same == verified->size() ? "the same to the last bit" : "NOT all the same");
  return n_same == verified->size() && damage.empty() ? exit_done : exit_failed;
}

}  // namespace

void add_verify(CLI::App& app, Session& session) {
  CLI::App* verb =
      app.add_subcommand("verify", "Simulate a sample of a folder again and compare every metric");
  auto options = std::make_shared<VerifyOptions>();
  verb->add_option("DIR", options->folder, "Folder of parapet optimize, table3 or simulate")
      ->required();
  CLI::Option* count =
      verb->add_option("-n,--count", options->count,
                       "Simulations to run again, spread over the folder (default: 3)")
          ->type_name("N")
          ->check(CLI::Range(1, 1000000));
  verb->add_flag("--all", options->all, "Run all of them again")->excludes(count);
  add_jobs(*verb, *options, "Simulations side by side; where there are fewer, threads of each");
  verb->footer(
      R"(Prints for each whether all its metrics came out the same to the last bit; exit code 1 when one did
not, or when a line or a file is not what was written (crc32c, checksums.sha256). Changes nothing in
DIR. The number of threads and of jobs plays no part; another revision of the program or another
compiler may.

Examples:
  parapet verify runs/quickstart-optimize
  parapet verify runs/table3 --all)");
  verb->callback([options, &session] {
    session.command = [options, &session] { return verify_command(session, *options); };
  });
}

}  // namespace parapet::cli
