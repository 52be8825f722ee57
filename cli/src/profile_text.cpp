#include "profile_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace parapet::cli {
namespace {

double per(double amount, std::int64_t count) {
  return amount / static_cast<double>(std::max<std::int64_t>(count, 1));
}

std::string stage_line(const solver::StageTime& stage, double whole) {
  std::string line = fmt::format("  {:<20} {:>10.3f} {:>6.1f} % {:>10} {:>10.1f}", stage.name,
                                 stage.seconds, 100.0 * stage.seconds / whole, stage.calls,
                                 1e6 * per(stage.seconds, stage.calls));
  if (stage.pairs > 0) {
    line += fmt::format(" {:>8.2f} {:>11.1f}", 1e9 * per(stage.seconds, stage.pairs),
                        1e-6 * static_cast<double>(stage.pairs) / std::max(stage.seconds, 1e-12));
  }
  return line + "\n";
}

std::string limits_text(const solver::Profile& profile) {
  std::string text;
  const auto add = [&](std::int64_t steps, const char* limit) {
    if (steps > 0) text += fmt::format("{}{} in {}", text.empty() ? "" : ", ", limit, steps);
  };
  add(profile.steps_acoustic, "sound speed");
  add(profile.steps_acceleration, "acceleration");
  add(profile.steps_viscous, "explicit viscosity");
  return text.empty() ? "nothing" : text;
}

}  // namespace

std::string profile_text(const solver::Profile& profile, const solver::RunStatistics& statistics) {
  const double whole = std::max(profile.seconds(), 1e-12);
  std::string text =
      fmt::format("profile\n  {:<20} {:>10} {:>8} {:>10} {:>10} {:>8} {:>11}\n", "stage", "seconds",
                  "share", "calls", "us/call", "ns/pair", "M pairs/s");
  for (const solver::StageTime& stage : profile.stages) text += stage_line(stage, whole);
  text += fmt::format("  {:<20} {:>10.3f}\n", "whole run", profile.seconds());
  text += fmt::format("  {} steps of {:.4g} us, {:.1f} % {} for sample times; limited by: {}\n",
                      statistics.steps, 1e6 * statistics.mean_time_step,
                      100.0 * std::abs(profile.step_shortening),
                      profile.step_shortening < 0.0 ? "longer" : "shorter", limits_text(profile));
  text += fmt::format("  neighbour rows renewed {} times, every {:.1f} steps\n",
                      statistics.neighbor_builds,
                      per(static_cast<double>(statistics.steps), statistics.neighbor_builds));
  text +=
      fmt::format("  conjugate gradients: {} iterations, {:.2f} a step\n", statistics.cg_iterations,
                  per(static_cast<double>(statistics.cg_iterations), statistics.steps));
  text += fmt::format(
      "  a particle has {:.1f} fluid neighbours and {:.2f} wall points within reach (means over "
      "the renewals); its row has {:.2f} slots for each\n",
      profile.fluid_neighbors, profile.wall_neighbors, profile.slots_per_pair);
  text += fmt::format(
      "  {:.1f} % of the steps came after the last change of any metric; {:.1f} % of the "
      "particle-steps were spent on material at rest\n",
      100.0 * profile.steps_after_last_change, 100.0 * profile.rest_share);
  return text;
}

}  // namespace parapet::cli
