// The flow that a barrier meets, had it not been there, and the hand formulas of its load.
#include <fmt/format.h>

#include <memory>

#include "approach_run.hpp"
#include "common_options.hpp"
#include "interrupt.hpp"
#include "parapet/study/thread_count.hpp"
#include "run_monitor.hpp"
#include "session.hpp"
#include "spec_files.hpp"
#include "text_format.hpp"

namespace parapet::cli {
namespace {

struct ApproachOptions : CommonOptions {
  std::string spec;
};

solver::Result run(const Session& session, const designs::CaseSpec& spec, int jobs) {
  RunMonitor monitor(session, 1, "");
  solver::RunOptions options = spec.run;
  options.reading_time = options.frame_interval = 0.0;
  options.threads = study::worthwhile_threads(spec, jobs);
  solver::Callbacks callbacks;
  callbacks.on_progress = [&](const solver::Progress& progress) {
    monitor.running(spec.name, progress);
    return !interrupted();
  };
  return solver::simulate(spec.scene, spec.numerics, options, callbacks);
}

std::string number(const designs::Json& value, const char* unit) {
  return value.is_null() ? "-" : fmt::format("{:.4g}{}", value.get<double>(), unit);
}

/// Velocity, depth and coefficients at each barrier of an approach.json.
std::string barriers_text(const designs::Json& json) {
  std::string text;
  int k = 0;
  for (const designs::Json& one : json.at("barriers")) {
    text += fmt::format(
        "barrier {}: undisturbed at x = {}: front {}, depth {}, Froude number {}\n"
        "  design force {}: alpha of alpha rho v^2 h {}, k of k rho g h^2/2 {}\n",
        ++k, number(one.at("foot_x_m"), " m"), number(one.at("front_velocity_m_s"), " m/s"),
        number(one.at("flow_depth_max_m"), " m"), number(one.at("froude_number"), ""),
        number(one.at("design_force_n_per_m"), " N/m"),
        number(one.at("hydrodynamic_coefficient"), ""),
        number(one.at("hydrostatic_coefficient"), ""));
  }
  return text;
}

int exit_code(const Session& session, const solver::Result& result) {
  if (result.status == solver::Status::cancelled) return exit_interrupted;
  session.log->error("the run failed: {}", result.reason);
  return exit_failed;
}

int approach_command(const Session& session, const ApproachOptions& options) {
  designs::CaseSpec spec = read_case(options.spec, options.spacing_mm);
  require_barrier(spec, options.spec);
  const solver::UndisturbedRun open = run_undisturbed(session, spec, options.jobs);
  if (open.result.status != solver::Status::ok) return exit_code(session, open.result);
  designs::set_approach(spec, open.profile);
  const solver::Result hit = run(session, spec, options.jobs);
  if (hit.status != solver::Status::ok) return exit_code(session, hit);
  const std::filesystem::path folder = output_folder(options, spec.name, "approach");
  std::filesystem::create_directories(folder);
  const designs::Json json = write_approach(session, spec, open, &hit, folder);
  session.out->print("{}\n{}{}{}results: {}\n", spec.name, barriers_text(json),
                     warnings_text(open.result.warnings), warnings_text(hit.warnings),
                     (folder / "approach.json").string());
  return exit_done;
}

}  // namespace

void add_approach(CLI::App& app, Session& session) {
  CLI::App* verb = app.add_subcommand(
      "approach", "The undisturbed flow at each barrier, and the hand formulas of its load");
  auto options = std::make_shared<ApproachOptions>();
  verb->add_option("CASE", options->spec, "Case file, or the name of a shipped one")->required();
  add_out(*verb, *options, "runs/NAME-approach");
  add_spacing(*verb, *options);
  add_jobs(*verb, *options, "Threads of each simulation");
  verb->footer(
      R"(Simulates the event without barriers, gauged along the channel, and with them. Prints velocity,
depth and Froude number of the undisturbed flow at each barrier's foot, and the coefficients of the two
hand formulas that give the simulated design load: alpha rho v^2 h (hydrodynamic) and k rho g h^2/2
(hydrostatic), as compared by Huebl et al. 2009, Debris flow impact estimation (Ohrid). Writes
approach.json. `parapet simulate CASE --approach` does the same beside its other results.

Examples:
  parapet approach single_barrier
  parapet approach my_case.json --spacing-mm 10)");
  verb->callback([options, &session] {
    session.command = [options, &session] { return approach_command(session, *options); };
  });
}

}  // namespace parapet::cli
