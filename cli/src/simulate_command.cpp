#include <fmt/format.h>

#include <functional>
#include <memory>

#include "approach_run.hpp"
#include "common_options.hpp"
#include "duration_text.hpp"
#include "flow_outputs.hpp"
#include "interrupt.hpp"
#include "parapet/records/atomic_file.hpp"
#include "parapet/records/checksum_list.hpp"
#include "parapet/records/folder_lock.hpp"
#include "parapet/records/hashes.hpp"
#include "parapet/records/output_folder.hpp"
#include "parapet/records/result_json.hpp"
#include "parapet/reports/run_summary.hpp"
#include "parapet/solver/uncertainty.hpp"
#include "parapet/study/thread_count.hpp"
#include "profile_text.hpp"
#include "report_files.hpp"
#include "run_monitor.hpp"
#include "session.hpp"
#include "spec_files.hpp"
#include "text_format.hpp"

namespace parapet::cli {
namespace {

struct SimulateOptions : CommonOptions {
  std::string spec;
  FlowWishes flow;
  std::optional<int> threads;
  bool uncertainty = false;
  bool profile = false;
  bool all = false;
  bool approach = false;
};

/// A file that cannot be written is not the program's fault: the same exit code as everywhere.
template <typename Action>
void writing(const Action& action) {
  try {
    action();
  } catch (const records::FileError&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw records::FileError(error.what());
  }
}

solver::Result run_solver(const Session& session, const designs::CaseSpec& spec, int threads,
                          FlowOutputs& outputs) {
  RunMonitor monitor(session, 1, "");
  solver::RunOptions run = spec.run;
  run.threads = threads;
  outputs.ask(run);
  solver::Callbacks callbacks;
  callbacks.on_progress = [&](const solver::Progress& progress) {
    monitor.running(spec.name, progress);
    return !interrupted();
  };
  if (outputs.any()) {
    callbacks.on_frame = [&](const solver::Frame& frame) {
      writing([&] { outputs.offer(frame); });
    };
  }
  return solver::simulate(spec.scene, spec.numerics, run, callbacks);
}

solver::Result run_with_uncertainty(const Session& session, const designs::CaseSpec& spec, int jobs,
                                    FlowOutputs& outputs) {
  RunMonitor monitor(session, 1, "");
  solver::RunOptions run = spec.run;
  outputs.ask(run);
  solver::UncertaintyPlan plan;
  plan.jobs = jobs;
  std::function<void(const solver::Frame&)> on_frame;
  if (outputs.any()) {
    on_frame = [&](const solver::Frame& frame) { writing([&] { outputs.offer(frame); }); };
  }
  return solver::simulate_with_uncertainty(
      spec.scene, spec.numerics, run, plan,
      [&](double done) {
        monitor.share(done);
        return !interrupted();
      },
      on_frame);
}

void write_result(const Session& session, const designs::CaseSpec& spec,
                  const solver::Result& result, int threads, const std::filesystem::path& folder) {
  const designs::Json provenance =
      records::provenance_json(session.program, records::case_hash(spec), spec);
  records::write_file_atomically(folder / "series.csv", records::series_csv(result.series));
  if (!result.loads.empty()) {
    records::write_file_atomically(folder / "pressure.csv", records::load_profiles_csv(result));
  }
  records::write_file_atomically(folder / "result.json",
                                 records::json_text(records::result_json(
                                     spec.name, result, spec.resolved, provenance, threads)));
}

/// Of a run that did not end well, and left nothing.
int exit_code(const Session& session, const solver::Result& result) {
  if (result.status == solver::Status::cancelled) {
    session.log->error("interrupted at {:.3f} s of flow; no result was written", result.stop_time);
    return exit_interrupted;
  }
  session.log->error("the run without barriers failed: {}", result.reason);
  return exit_failed;
}

int simulate_command(const Session& session, const SimulateOptions& options) {
  designs::CaseSpec spec = read_case(options.spec, options.spacing_mm);
  spec.run.profile = options.profile;
  const std::filesystem::path folder = output_folder(options, spec.name, "simulate");
  records::open_output_folder(folder, records::FolderKind::simulation);
  const records::FolderLock lock(folder);
  records::take_output_folder(folder, records::FolderKind::simulation);
  records::remove_earlier_simulation(folder);
  std::optional<FlowOutputs> outputs;
  writing([&] { outputs.emplace(options.flow, spec, folder); });
  std::optional<solver::UndisturbedRun> open;
  if (options.approach) {
    require_barrier(spec, options.spec);
    open = run_undisturbed(session, spec, options.threads.value_or(options.jobs));
    if (open->result.status != solver::Status::ok) return exit_code(session, open->result);
    designs::set_approach(spec, open->profile);
  }
  const int threads = options.uncertainty
                          ? 1
                          : options.threads.value_or(study::worthwhile_threads(spec, options.jobs));
  const solver::Result result = options.uncertainty
                                    ? run_with_uncertainty(session, spec, options.jobs, *outputs)
                                    : run_solver(session, spec, threads, *outputs);
  if (result.status == solver::Status::cancelled) return exit_code(session, result);
  write_result(session, spec, result, threads, folder);
  if (open) write_approach(session, spec, *open, &result, folder);
  writing([&] { outputs->finish(session, result); });
  write_report(session, folder);
  records::ChecksumList(folder).write();
  const double seconds = result.statistics.wall_time;
  session.out->print("{}: {} steps in {}\n{}", spec.name, result.statistics.steps,
                     seconds < 10.0 ? fmt::format("{:.2g} s", seconds) : duration_text(seconds),
                     reports::run_summary(result));
  if (options.all) {
    session.out->print("all metrics\n{}", metrics_text(result.metrics));
  } else {
    session.out->print("  {:<18}{} metrics: --all, or result.json\n", "more",
                       result.metrics.size());
  }
  session.out->print("results: {}\n", folder.string());
  if (result.profile) session.out->print("{}", profile_text(*result.profile, result.statistics));
  if (result.status == solver::Status::ok) return exit_done;
  session.log->error("the run failed: {}", result.reason);
  return exit_failed;
}

}  // namespace

void add_simulate(CLI::App& app, Session& session) {
  CLI::App* verb = app.add_subcommand("simulate", "Simulate one design");
  auto options = std::make_shared<SimulateOptions>();
  verb->add_option("CASE", options->spec, "Case file, or the name of a shipped one")->required();
  add_out(*verb, *options, "runs/NAME-simulate");
  add_spacing(*verb, *options);
  CLI::Option* uncertainty = verb->add_flag(
      "--uncertainty", options->uncertainty,
      "Give each metric its numerical uncertainty (95 %), from eight further runs at 1.4 "
      "and 2 times the particle spacing, with jittered lattices; 2.7 times the cost");
  add_jobs(*verb, *options, "With --uncertainty: simulations side by side, one thread each");
  verb->add_option("--threads", options->threads,
                   "Threads inside the simulation (default: the number of cores, fewer for few "
                   "particles); the result does not depend on it")
      ->check(CLI::Range(1, 1024))
      ->excludes(uncertainty)
      ->type_name("N");
  verb->add_flag("--all", options->all, "Print every metric, not the summary alone");
  verb->add_flag("--approach", options->approach,
                 "First simulate the event without barriers, for the coefficients of the hand "
                 "formulas of the load; writes approach.json too");
  verb->add_flag("--profile", options->profile,
                 "Print which part of the solver took how long (also in result.json, timing)");
  verb->add_flag("--frames", options->flow.frames,
                 "Write particle frames for ParaView into DIR/frames");
  verb->add_option("--frame-interval-s", options->flow.frame_interval_s,
                   "Interval of the frames in seconds (default: the case's, or 0.05)")
      ->check(CLI::Range(1e-6, 1e4))
      ->type_name("X");
  verb->add_flag("--record", options->flow.record,
                 "Record the flow into DIR/recording.flow, to be played in the report");
  verb->add_option("--record-interval-s", options->flow.record_interval_s,
                   "Interval of the recording in seconds (default: by the size of the release, at "
                   "most 300 frames)")
      ->check(CLI::Range(1e-6, 1e4))
      ->type_name("X");
  verb->add_flag("--picture", options->flow.picture,
                 "Draw the flow at six moments into DIR/flow.png, and the pressures of the design "
                 "load into DIR/pressure.png");
  verb->add_option("--picture-times-s", options->flow.picture_times_s,
                   "Draw it at these times in seconds, for example 0.45,0.8,1.2")
      ->delimiter(',')
      ->check(CLI::NonNegativeNumber)
      ->type_name("T,T");
  verb->footer(
      R"(Prints what was held back, how far the overflow flew, what the load was, and warnings; --all prints every metric.
Writes result.json (metrics, status, provenance), series.csv and report.html into DIR.

Examples:
  parapet simulate designs/single_barrier.json
  parapet simulate single_barrier --spacing-mm 10 --out runs/coarse
  parapet simulate my_case.json --uncertainty
  parapet simulate my_case.json --frames --frame-interval-s 0.02
  parapet simulate my_case.json --picture-times-s 0.45,0.8,1.2,2)");
  verb->callback([options, &session] {
    session.command = [options, &session] { return simulate_command(session, *options); };
  });
}

}  // namespace parapet::cli
