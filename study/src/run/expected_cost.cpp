#include "parapet/study/expected_cost.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

#include "parapet/solver/thin_fluid.hpp"
#include "parapet/study/simulator.hpp"

namespace parapet::study {
namespace {

/// Four force evaluations for each step of the explicit integration: measured 3.7 times the
/// processor time of an implicit step at 10 mm.
constexpr double explicit_factor = 4.0;

/// Two for each step of a thin fluid: measured 2.0 times the processor time of an implicit step
/// (vortices at Re 1000, 50 across).
constexpr double thin_factor = 2.0;

double seconds_of(const designs::CaseSpec& spec, const solver::ExpectedCost& counts) {
  const bool rk4 = spec.numerics.integrator == solver::Integrator::rk4_explicit;
  const bool thin = solver::is_thin(spec.numerics, spec.scene.material);
  return nominal_seconds(counts.particle_steps()) * (rk4    ? explicit_factor
                                                     : thin ? thin_factor
                                                            : 1.0);
}

std::string mebibytes(double bytes) {
  return fmt::format("{:.4g} MiB", bytes / (1024.0 * 1024.0));
}

double least_memory_limit(double so_far, const char* file) {
  std::ifstream stream(file);
  double limit = 0.0;
  return stream >> limit && limit > 0.0 ? std::min(so_far, limit) : so_far;
}

}  // namespace

CaseCost case_cost(const designs::CaseSpec& spec) {
  CaseCost cost;
  cost.spacing = spec.numerics.spacing;
  cost.counts = solver::expected_cost(spec.scene, spec.numerics, spec.run);
  cost.seconds = seconds_of(spec, cost.counts);
  return cost;
}

StudyCost study_cost(const designs::StudySpec& study) {
  StudyCost cost;
  std::vector<const designs::Scenario*> events;
  for (const designs::Scenario& scenario : study.scenarios) events.push_back(&scenario);
  if (events.empty()) events.push_back(nullptr);
  cost.events = static_cast<double>(events.size());
  for (const designs::FidelityLevel& level : study.fidelity) {
    CaseCost most;
    double seconds = 0.0;
    for (const designs::Scenario* event : events) {
      CaseCost one;
      try {
        one = case_cost(designs::design_case(study, {}, event, level.spacing));
      } catch (const designs::InputError&) {
        continue;  // options of a choice decide whether the case is possible
      }
      seconds += one.seconds;
      if (one.counts.memory > most.counts.memory) most = one;
    }
    most.spacing = level.spacing;
    most.seconds = seconds / cost.events;
    cost.levels.push_back(most);
  }
  cost.designs = study.method.max_evaluations;
  const double runs = study.method.max_finest_runs;
  if (runs > 0.0) cost.designs = std::min(cost.designs, runs / cost.events);
  if (designs::algorithm_name(study) == "LIST") {
    cost.designs = std::min(cost.designs, static_cast<double>(study.method.starts.size()));
  }
  if (!cost.levels.empty()) cost.seconds = cost.designs * cost.events * cost.levels.front().seconds;
  if (study.method.max_cpu_time_s > 0.0) {
    cost.seconds = std::min(cost.seconds, study.method.max_cpu_time_s);
  }
  return cost;
}

std::vector<designs::InputIssue> cost_issues(const CaseCost& cost, double memory,
                                             const std::string& file, const std::string& prefix) {
  const solver::ExpectedCost& counts = cost.counts;
  const auto issue = [&](const std::string& pointer, const std::string& problem,
                         const std::string& allowed) {
    return std::vector<designs::InputIssue>{{file, prefix + pointer, "", problem, allowed}};
  };
  if (counts.neighbors > solver::most_numbered) {
    return issue(
        "/numerics/spacing_m",
        fmt::format("is too fine: {:.4g} pairs of particles cannot be numbered", counts.neighbors),
        "a larger spacing, smoothing ratio or skin ratio as far as these were set");
  }
  if (counts.wall_points > solver::most_numbered) {
    return issue(
        "/channel/length_m",
        fmt::format("takes {:.4g} wall points, which cannot be numbered", counts.wall_points),
        "a shorter channel or a larger /numerics/spacing_m");
  }
  if (counts.memory <= memory) return {};
  const std::string problem =
      fmt::format("the simulation would need {} of memory, and there are {}",
                  mebibytes(counts.memory), mebibytes(memory));
  if (counts.series_memory > 0.5 * counts.memory) {
    return issue("/run/series_interval_s",
                 problem + fmt::format(", most of it for {:.4g} samples", counts.samples),
                 "a longer interval, or a shorter /run/stop_time_s");
  }
  return issue("/numerics/spacing_m", problem, "a larger spacing, or a smaller reservoir");
}

double machine_memory() {
  const long pages = ::sysconf(_SC_PHYS_PAGES), page = ::sysconf(_SC_PAGESIZE);
  double memory = pages > 0 && page > 0 ? static_cast<double>(pages) * static_cast<double>(page)
                                        : std::numeric_limits<double>::infinity();
  memory = least_memory_limit(memory, "/sys/fs/cgroup/memory.max");
  return least_memory_limit(memory, "/sys/fs/cgroup/memory/memory.limit_in_bytes");
}

}  // namespace parapet::study
