/// What every verb shares, and how it is registered.
#pragma once

#include <spdlog/logger.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "parapet/records/provenance.hpp"
#include "parapet/study/local_service.hpp"
#include "standard_streams.hpp"

namespace parapet::cli {

/// Exit codes of the program.
enum ExitCode : int { exit_done = 0, exit_failed = 1, exit_bad_input = 2, exit_interrupted = 130 };

/// One call of the program.
struct Session {
  records::ProgramInfo program;
  std::shared_ptr<spdlog::logger> log;  ///< to standard error
  std::shared_ptr<StandardOutput> out;  ///< what the verb answers
  std::vector<std::string> arguments;   ///< as given, the program's name first
  bool quiet = false;                   ///< no progress, only warnings and errors
  study::ServiceFactory service = study::local_service();  ///< who simulates the designs of a study
  std::function<int()> command;  ///< of the verb that was chosen; gives the exit code
};

// Each adds its verb to the program; `session` must outlive `app`.
void add_simulate(CLI::App& app, Session& session);
void add_table3(CLI::App& app, Session& session);
void add_optimize(CLI::App& app, Session& session);
void add_evaluate(CLI::App& app, Session& session);
void add_recommend(CLI::App& app, Session& session);
void add_report(CLI::App& app, Session& session);
void add_serve(CLI::App& app, Session& session);
void add_validate(CLI::App& app, Session& session);       ///< of `parapet-validate`
void add_validate_call(CLI::App& app, Session& session);  ///< executes `parapet-validate`
void add_check(CLI::App& app, Session& session);
void add_approach(CLI::App& app, Session& session);
void add_verify(CLI::App& app, Session& session);

}  // namespace parapet::cli
