#include "parapet/study/simulator.hpp"

#include <time.h>

#include <cmath>
#include <memory>
#include <stdexcept>

#include "parapet/records/result_json.hpp"
#include "parapet/study/thread_count.hpp"

namespace parapet::study {
namespace {

using designs::Json;

/// Processor time of the calling thread [s].
double thread_seconds() {
  timespec now{};
  if (::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now) != 0) return 0.0;
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Json simulation_json(const Json& result) {
  Json json = Json::object();
  for (const char* key : {"status", "reason", "stop_reason", "stop_time_s", "quality", "warnings",
                          "mass", "statistics", "timing"}) {
    json[key] = result.at(key);
  }
  return json;
}

records::Simulation from_result(const designs::CaseSpec& spec, int threads,
                                const solver::Result& result) {
  records::Simulation simulation;
  simulation.cancelled = result.status == solver::Status::cancelled;
  simulation.ok = result.status == solver::Status::ok;
  simulation.reason = result.reason;
  simulation.stop_reason = solver::to_string(result.stop_reason);
  simulation.metrics = result.metrics;
  simulation.warnings = result.warnings;
  simulation.wall_time = result.statistics.wall_time;
  simulation.particle_steps = static_cast<double>(result.mass.particles_released) *
                              static_cast<double>(result.statistics.steps);
  simulation.report["numerics"] = spec.resolved.at("numerics");
  simulation.report["simulation"] =
      simulation_json(records::result_json(spec.name, result, nullptr, nullptr, threads));
  simulation.report["case"] = spec.resolved;
  simulation.report["series"] = records::series_json(result.series);
  return simulation;
}

records::Simulation simulate(const SimulationTask& task, const solver::Callbacks& callbacks,
                             solver::StartStates& starts) {
  const designs::CaseSpec& spec = task.spec;
  solver::RunOptions run = spec.run;
  run.threads = worthwhile_threads(spec, task.threads);
  try {
    const double before = thread_seconds();
    const solver::Result result =
        solver::simulate(spec.scene, spec.numerics, run, callbacks, &starts);
    const double seconds = thread_seconds() - before;
    records::Simulation simulation = from_result(spec, run.threads, result);
    // The other threads of a simulation work, or wait busily, as long as the calling one.
    simulation.cpu_time = seconds * run.threads;
    return simulation;
  } catch (const std::invalid_argument& error) {
    return impossible_scene(error.what());
  }
}

}  // namespace

Simulator solver_simulator() {
  return [starts = std::make_shared<solver::StartStates>()](const SimulationTask& task,
                                                            const solver::Callbacks& callbacks) {
    return simulate(task, callbacks, *starts);
  };
}

records::Simulation impossible_scene(const std::string& why) {
  records::Simulation simulation;
  simulation.reason = "the scene is impossible: " + why;
  simulation.report = Json::object();
  return simulation;
}

double expected_seconds(const designs::StudySpec& study, double spacing) {
  // single_deflector took 12.3 s of processor time at 5 mm (2,400 particles) and 1.23 s at 10 mm,
  // on a core at 2.6 GHz. Particles grow with spacing^-2, time steps with spacing^-1, and the
  // iterations of the implicit viscosity somewhat.
  constexpr double reference_particles = 2400.0, reference_seconds = 12.3;
  constexpr double exponent = 1.65;  // spacing^-3.3
  const Json& reservoir = study.base_case.at("reservoir");
  const double area =
      reservoir.at("length_m").get<double>() * reservoir.at("height_m").get<double>();
  return reference_seconds * std::pow(area / (spacing * spacing) / reference_particles, exponent);
}

double nominal_seconds(double particle_steps) {
  // In the same runs, and at 15 mm: 4.1e-7 to 4.5e-7.
  constexpr double seconds_per_particle_step = 4.3e-7;
  return seconds_per_particle_step * particle_steps;
}

}  // namespace parapet::study
