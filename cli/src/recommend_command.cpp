#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "parapet/reports/atomic_file.hpp"
#include "parapet/reports/recommendation.hpp"
#include "parapet/reports/result_json.hpp"
#include "session.hpp"

namespace parapet::cli {
namespace {

int recommend_command(const Session& session, const std::filesystem::path& folder) {
  const reports::Recommendation recommendation = reports::recommend(folder);
  reports::write_file_atomically(folder / "recommendation.json",
                                 reports::json_text(recommendation.json));
  reports::write_file_atomically(folder / "recommendation.md", recommendation.markdown);
  if (!session.quiet) fmt::print("{}", recommendation.markdown);
  session.log->info("written: {} and recommendation.json", (folder / "recommendation.md").string());
  if (!recommendation.feasible) {
    session.log->warn("no design meets every constraint, so nothing is recommended");
  }
  return exit_done;
}

}  // namespace

void add_recommend(CLI::App& app, Session& session) {
  CLI::App* verb = app.add_subcommand("recommend", "Say which design to build, from a study's log");
  auto folder = std::make_shared<std::string>();
  verb->add_option("STUDY_DIR", *folder, "Folder of a study, as parapet optimize writes it")
      ->required();
  verb->footer(
      R"(Prints the advice and writes recommendation.md and recommendation.json into STUDY_DIR. Nothing is
simulated; a study that still runs can be asked too.

Examples:
  parapet recommend runs/quickstart-optimize)");
  verb->callback([folder, &session] {
    session.command = [folder, &session] { return recommend_command(session, *folder); };
  });
}

}  // namespace parapet::cli
