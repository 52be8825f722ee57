#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "parapet/study/problem.hpp"
#include "session.hpp"
#include "spec_files.hpp"

namespace parapet::cli {
namespace {

std::string counted(std::size_t count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

/// What a sound document holds. @throws designs::InputError for one that is not.
std::string describe(const std::string& argument) {
  const SpecDocument document = read_spec(argument);
  const std::string format = designs::document_format(document.json, document.file);
  if (format == "parapet-case/1") {
    const auto spec = designs::parse_case(document.json, document.file);
    return "case, " + counted(spec.scene.barriers.size(), "barrier");
  }
  if (format == "parapet-sweep/1") {
    const auto sweep = designs::parse_sweep(document.json, document.file);
    return "sweep, " + counted(sweep.rows.size(), "row");
  }
  const auto study = designs::parse_study(document.json, document.file);
  if (auto issues = study::method_issues(study); !issues.empty()) {
    throw designs::InputError(std::move(issues));
  }
  std::string text = fmt::format("study, {}, {}, {}", counted(study.variables.size(), "variable"),
                                 counted(study.objectives.size(), "objective"),
                                 counted(study.constraints.size(), "constraint"));
  if (!study.scenarios.empty()) text += ", " + counted(study.scenarios.size(), "scenario");
  if (study.fidelity.size() > 1) text += ", " + counted(study.fidelity.size(), "spacing");
  return text;
}

int check_command(const Session& session, const std::vector<std::string>& files) {
  std::size_t issues = 0;
  for (const std::string& file : files) {
    try {
      session.out->print("{}: ok ({})\n", file, describe(file));
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
ends with exit code 2.

Examples:
  parapet check my_study.json
  parapet check designs/*.json)");
  verb->callback([files, &session] {
    session.command = [files, &session] { return check_command(session, *files); };
  });
}

}  // namespace parapet::cli
