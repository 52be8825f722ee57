#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "duration_text.hpp"
#include "parapet/solver/thin_fluid.hpp"
#include "parapet/study/expected_cost.hpp"
#include "parapet/study/problem.hpp"
#include "session.hpp"
#include "spec_files.hpp"

namespace parapet::cli {
namespace {

std::string counted(std::size_t count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

/// "3,600 s" of one core as people read it, and what it stands for.
std::string core_time(double seconds) {
  return duration_text(seconds) + " of one core at 2.6 GHz";
}

std::string memory_text(double bytes) {
  return fmt::format("{:.0f} MiB", std::ceil(bytes / (1024.0 * 1024.0)));
}

std::string cost_line(const study::CaseCost& cost) {
  return fmt::format(
      "  each simulation at {:g} mm: {:.0f} particles, about {:.0f} time steps, {}, {}\n",
      1000.0 * cost.spacing, cost.counts.particles, cost.counts.steps, core_time(cost.seconds),
      memory_text(cost.counts.memory));
}

constexpr const char* usual_end =
    "  these are runs until no metric changes any more; slow debris may need up to the stop time\n";

/// What a thin fluid gets in place of defaults; empty for debris.
std::string thin_text(const designs::CaseSpec& spec) {
  const double cell = solver::cell_reynolds_number(spec.numerics, spec.scene.material);
  if (!solver::is_thin(spec.numerics, spec.scene.material)) return "";
  return fmt::format(
      "  a thin fluid: cell Reynolds number {:.2g}, {:g} or more; its own settings apply, among "
      "them "
      "a smoothing ratio of {:g} (numerics.thin_fluid)\n",
      cell, solver::thin_cell_reynolds_number,
      solver::numerics_for(spec.numerics, spec.scene.material).smoothing_ratio);
}

std::string cost_text(const designs::CaseSpec& spec) {
  return thin_text(spec) + cost_line(study::case_cost(spec)) + usual_end;
}

std::string cost_text(const designs::StudySpec& study) {
  const study::StudyCost cost = study::study_cost(study);
  std::string text;
  for (const study::CaseCost& level : cost.levels) text += cost_line(level);
  const double simulations = cost.designs * cost.events;
  text += fmt::format("  the study: at most {:.0f} designs, {:.0f} simulations, {}", cost.designs,
                      simulations, core_time(cost.seconds));
  if (!cost.levels.empty()) {
    text += fmt::format(", {} for each job", memory_text(cost.levels.front().counts.memory));
  }
  return text + "\n" + usual_end;
}

std::string cost_text(const designs::SweepSpec& sweep) {
  double seconds = 0.0, memory = 0.0;
  for (const designs::SweepRow& row : sweep.rows) {
    const study::CaseCost cost = study::case_cost(row.spec);
    seconds += cost.seconds;
    memory = std::max(memory, cost.counts.memory);
  }
  return fmt::format("  all rows: {}, {} for each job\n{}", core_time(seconds), memory_text(memory),
                     usual_end);
}

/// What a sound document holds and what it will cost. @throws designs::InputError for one that is
/// not sound or cannot run.
std::string describe(const std::string& argument) {
  const SpecDocument document = read_spec(argument);
  const std::string format = designs::document_format(document.json, document.file);
  if (format == "parapet-case/1") {
    const auto spec = designs::parse_case(document.json, document.file);
    require_affordable(spec, document.file);
    return "case, " + counted(spec.scene.barriers.size(), "barrier") + ")\n" + cost_text(spec);
  }
  if (format == "parapet-sweep/1") {
    const auto sweep = designs::parse_sweep(document.json, document.file);
    require_affordable(sweep, document.file);
    return "sweep, " + counted(sweep.rows.size(), "row") + ")\n" + cost_text(sweep);
  }
  const auto study = designs::parse_study(document.json, document.file);
  if (auto issues = study::method_issues(study); !issues.empty()) {
    throw designs::InputError(std::move(issues));
  }
  require_affordable(study, document.file);
  std::string text = fmt::format("study, {}, {}, {}", counted(study.variables.size(), "variable"),
                                 counted(study.objectives.size(), "objective"),
                                 counted(study.constraints.size(), "constraint"));
  if (!study.scenarios.empty()) text += ", " + counted(study.scenarios.size(), "scenario");
  if (study.fidelity.size() > 1) text += ", " + counted(study.fidelity.size(), "spacing");
  return text + ")\n" + cost_text(study);
}

int check_command(const Session& session, const std::vector<std::string>& files) {
  std::size_t issues = 0;
  for (const std::string& file : files) {
    try {
      session.out->print("{}: ok ({}", file, describe(file));
    } catch (const designs::InputError& error) {
      for (const designs::InputIssue& issue : error.issues()) {
        session.log->error("{}", designs::to_string(issue));
      }
      issues += error.issues().size();
    }
  }
  return issues == 0 ? exit_done : exit_bad_input;
}

}  // namespace

void add_check(CLI::App& app, Session& session) {
  CLI::App* verb =
      app.add_subcommand("check", "Check cases, studies and sweeps without running them");
  auto files = std::make_shared<std::vector<std::string>>();
  verb->add_option("FILE", *files, "Files, or names of shipped specs")->required();
  verb->footer(
      R"(Says every error at once, one per line with file, JSON pointer, value and what is allowed, and then
ends with exit code 2. Of a sound file it says what its simulations will cost: particles and time
steps are counted from the file, the time is 0.43 microseconds for each particle and step, as
measured on one core at 2.6 GHz. What this machine cannot hold is an error.

Examples:
  parapet check my_study.json
  parapet check designs/*.json)");
  verb->callback([files, &session] {
    session.command = [files, &session] { return check_command(session, *files); };
  });
}

}  // namespace parapet::cli
