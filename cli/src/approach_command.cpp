// The flow that a barrier meets, had it not been there, and the hand formulas of its load.
#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "common_options.hpp"
#include "interrupt.hpp"
#include "parapet/records/atomic_file.hpp"
#include "parapet/records/hashes.hpp"
#include "parapet/records/result_json.hpp"
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

/// Of the undisturbed flow at the first barrier's foot.
struct Approach {
  std::optional<double> velocity, depth, froude;  // [m/s], [m], [-]
};

solver::Result run(const Session& session, const designs::CaseSpec& spec,
                   const solver::Scene& scene, int jobs) {
  RunMonitor monitor(session, 1, "");
  solver::RunOptions options = spec.run;
  options.reading_time = options.frame_interval = 0.0;
  options.threads = study::worthwhile_threads(spec, jobs);
  solver::Callbacks callbacks;
  callbacks.on_progress = [&](const solver::Progress& progress) {
    monitor.running(spec.name, progress);
    return !interrupted();
  };
  return solver::simulate(scene, spec.numerics, options, callbacks);
}

/// The same event without barriers, gauged where the first one stands.
solver::Scene undisturbed(const designs::CaseSpec& spec) {
  solver::Scene scene = spec.scene;
  scene.monitor_x = scene.barriers.front().foot_x;
  scene.barriers.clear();
  return scene;
}

std::optional<double> value_of(const solver::Result& result, const char* key) {
  const solver::Metric* metric = result.find_metric(key);
  return metric == nullptr ? std::nullopt : metric->value;
}

/// The design load over the two hand formulas with a coefficient of 1.
struct Coefficients {
  std::optional<double> alpha, k;
};

Coefficients back_calculated(const designs::CaseSpec& spec, const Approach& approach,
                             const std::optional<double>& force) {
  Coefficients c;
  if (!force || !approach.depth || !(*approach.depth > 0.0)) return c;
  const double density = spec.scene.material.density, h = *approach.depth;
  c.k = *force / (0.5 * density * spec.scene.gravity * h * h);
  if (approach.velocity && *approach.velocity > 0.0) {
    c.alpha = *force / (density * *approach.velocity * *approach.velocity * h);
  }
  return c;
}

designs::Json optional_json(const std::optional<double>& value) {
  return value ? designs::Json(*value) : designs::Json(nullptr);
}

std::string number(const std::optional<double>& value, const char* unit) {
  return value ? fmt::format("{:.4g}{}", *value, unit) : std::string("-");
}

int approach_command(const Session& session, const ApproachOptions& options) {
  const designs::CaseSpec spec = read_case(options.spec, options.spacing_mm);
  if (spec.scene.barriers.empty()) {
    throw designs::InputError({{options.spec, "/barriers", "[]", "there is no barrier to approach",
                                "a case with at least one barrier"}});
  }
  const solver::Result open = run(session, spec, undisturbed(spec), options.jobs);
  const solver::Result hit = run(session, spec, spec.scene, options.jobs);
  for (const solver::Result* result : {&open, &hit}) {
    if (result->status == solver::Status::cancelled) return exit_interrupted;
    if (result->status == solver::Status::ok) continue;
    session.log->error("the run failed: {}", result->reason);
    return exit_failed;
  }
  const Approach approach{value_of(open, "front_velocity_m_s"), value_of(open, "flow_depth_max_m"),
                          value_of(open, "froude_number")};
  const std::optional<double> force = value_of(hit, "barrier_1_design_force_n_per_m");
  const Coefficients c = back_calculated(spec, approach, force);
  designs::Json json;
  json["format"] = "parapet-approach/1";
  json["name"] = spec.name;
  json["foot_x_m"] = spec.scene.barriers.front().foot_x;
  json["front_velocity_m_s"] = optional_json(approach.velocity);
  json["flow_depth_max_m"] = optional_json(approach.depth);
  json["froude_number"] = optional_json(approach.froude);
  json["barrier_1_design_force_n_per_m"] = optional_json(force);
  json["alpha"] = optional_json(c.alpha);
  json["k"] = optional_json(c.k);
  json["warnings"] = {{"undisturbed", records::warnings_json(open.warnings)},
                      {"with_barrier", records::warnings_json(hit.warnings)}};
  json["provenance"] = records::provenance_json(session.program, records::case_hash(spec), spec);
  const std::filesystem::path folder = output_folder(options, spec.name, "approach");
  std::filesystem::create_directories(folder);
  records::write_file_atomically(folder / "approach.json", records::json_text(json));
  session.out->print(
      "{}: undisturbed at x = {:.4g} m: front {}, depth {}, Froude number {}\n"
      "design force on the first barrier: {}\n"
      "  alpha of alpha rho v^2 h: {}   k of k rho g h^2/2: {}\n{}{}results: {}\n",
      spec.name, spec.scene.barriers.front().foot_x, number(approach.velocity, " m/s"),
      number(approach.depth, " m"), number(approach.froude, ""), number(force, " N/m"),
      number(c.alpha, ""), number(c.k, ""), warnings_text(open.warnings),
      warnings_text(hit.warnings), (folder / "approach.json").string());
  return exit_done;
}

}  // namespace

void add_approach(CLI::App& app, Session& session) {
  CLI::App* verb = app.add_subcommand(
      "approach", "The undisturbed flow at the first barrier, and the hand formulas of its load");
  auto options = std::make_shared<ApproachOptions>();
  verb->add_option("CASE", options->spec, "Case file, or the name of a shipped one")->required();
  add_out(*verb, *options, "runs/NAME-approach");
  add_spacing(*verb, *options);
  add_jobs(*verb, *options, "Threads of each simulation");
  verb->footer(
      R"(Simulates the event without barriers, gauged at the first barrier's foot, and with them. Prints
velocity, depth and Froude number of the undisturbed flow, and the coefficients of the two hand formulas
that give the simulated design load: alpha rho v^2 h (hydrodynamic) and k rho g h^2/2 (hydrostatic), as
compared by Huebl et al. 2009, Debris flow impact estimation (Ohrid). Writes approach.json.

Examples:
  parapet approach single_barrier
  parapet approach my_case.json --spacing-mm 10)");
  verb->callback([options, &session] {
    session.command = [options, &session] { return approach_command(session, *options); };
  });
}

}  // namespace parapet::cli
