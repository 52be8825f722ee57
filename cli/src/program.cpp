#include "program.hpp"

#include <fmt/format.h>
#include <spdlog/sinks/base_sink.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <mutex>
#include <new>
#include <sstream>
#include <system_error>

#include "interrupt.hpp"
#include "parapet/designs/case_spec.hpp"
#include "parapet/designs/error.hpp"
#include "parapet/designs/text.hpp"
#include "parapet/records/atomic_file.hpp"
#include "program_info.hpp"
#include "session.hpp"
#include "standard_streams.hpp"

namespace parapet::cli {
namespace {

constexpr const char* examples = R"(Examples:
  parapet simulate designs/single_barrier.json      one design: metrics and time series
  parapet table3                                    the fifteen rows of the source paper
  parapet optimize designs/quickstart.json          search for a better barrier
  parapet recommend runs/quickstart-optimize        what the search found, in words
  parapet validate                                  how far to trust the solver
  parapet VERB --help                               options and examples of a verb

Exit codes: 0 done, 1 a run failed or a file could not be read or written, 2 bad input or
arguments, 130 interrupted.
A spec that is not found as a file but has the name of a shipped one is taken from the program.)";

/// Messages, one line each whatever they quote. What standard error does not take is lost: there is
/// nowhere to say it, and the exit code tells how the program ended.
class MessageSink : public spdlog::sinks::base_sink<std::mutex> {
 protected:
  void sink_it_(const spdlog::details::log_msg& message) override {
    // On a terminal a message first wipes the progress line.
    const char* begin = isatty(STDERR_FILENO) != 0 ? "\r\033[K" : "";
    const auto level = spdlog::level::to_string_view(message.level);
    const std::string line =
        fmt::format("{}{}: {}\n", begin, std::string_view(level.data(), level.size()),
                    designs::visible_text({message.payload.data(), message.payload.size()}));
    std::fputs(line.c_str(), stderr);
  }
  void flush_() override {}
};

std::shared_ptr<spdlog::logger> make_logger() {
  return std::make_shared<spdlog::logger>("parapet", std::make_shared<MessageSink>());
}

void add_global_options(CLI::App& app, Session& session) {
  app.set_version_flag(
      "--version",
      "parapet " + session.program.version +
          (session.program.git_revision.empty() ? "" : " (" + session.program.git_revision + ")"));
  app.add_option_function<std::string>(
         "--log-level",
         [&session](const std::string& level) {
           session.log->set_level(spdlog::level::from_str(level));
         },
         "Messages from this level on: trace, debug, info, warning, error (default: info)")
      ->check(CLI::IsMember({"trace", "debug", "info", "warning", "error"}))
      ->trigger_on_parse();
  app.add_flag_callback(
         "-q,--quiet",
         [&session] {
           session.quiet = true;
           session.log->set_level(spdlog::level::warn);
         },
         "No progress and no messages but warnings and errors")
      ->trigger_on_parse();
}

int parse_and_run(CLI::App& app, Session& session, int argc, char** argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::ostringstream out, err;
    const int code = app.exit(error, out, err);
    session.out->write(out.str());
    std::fputs(designs::visible_lines(err.str()).c_str(), stderr);
    return code == 0 ? exit_done : exit_bad_input;
  }
  if (!session.command) {
    std::fputs(app.help().c_str(), stderr);
    return exit_bad_input;
  }
  install_interrupt_handler();
  return session.command();
}

void say_each(const Session& session, const designs::InputError& error) {
  for (const designs::InputIssue& issue : error.issues()) {
    session.log->error("{}", designs::to_string(issue));
  }
}

/// Output that nobody got makes a success a failure. A reader that has seen enough (EPIPE) knows.
int finish_output(const Session& session, int code) {
  const int error = session.out->finish();
  if (error == 0) return code;
  if (error != EPIPE) {
    session.log->error("cannot write standard output: {}; what was printed is lost",
                       std::generic_category().message(error));
  }
  return code == exit_done ? exit_failed : code;
}

/// What the library says, without its own number in brackets.
std::string bare_text(const designs::Json::exception& error) {
  const std::string text = error.what();
  const std::size_t end = text.find("] ");
  return text.starts_with('[') && end != std::string::npos ? text.substr(end + 2) : text;
}

int run_guarded(Session& session, int argc, char** argv, std::initializer_list<AddVerb> verbs) {
  CLI::App app(
      "Parapet finds better debris-flow barriers: a two-dimensional particle simulation of "
      "the flow, driven by an optimiser.",
      "parapet");
  app.require_subcommand(0, 1);
  app.fallthrough();
  app.footer(examples);
  add_global_options(app, session);
  for (const AddVerb add_verb : verbs) add_verb(app, session);
  try {
    return parse_and_run(app, session, argc, argv);
  } catch (const designs::InputError& error) {
    say_each(session, error);
    return exit_bad_input;
  } catch (const records::FileError& error) {
    session.log->error("{}", error.what());
    return exit_failed;
  } catch (const std::filesystem::filesystem_error& error) {
    session.log->error("{}: {}", error.path1().string(), error.code().message());
    return exit_failed;
  } catch (const designs::Json::exception& error) {
    session.log->error("a file does not hold what Parapet writes: {}", bare_text(error));
    return exit_bad_input;
  } catch (const std::bad_alloc&) {
    session.log->error("out of memory: use fewer --jobs or a larger --spacing-mm");
    return exit_failed;
  }
}

}  // namespace

int run_program(int argc, char** argv, std::initializer_list<AddVerb> verbs,
                study::ServiceFactory service) {
  try {
    Session session;
    session.service = std::move(service);
    session.program = program_info();
    session.log = make_logger();
    session.out = std::make_shared<StandardOutput>();
    session.arguments.assign(argv, argv + argc);
    return finish_output(session, run_guarded(session, argc, argv, verbs));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", designs::visible_text(error.what()).c_str());
  } catch (...) {
    std::fputs("error: an exception of unknown type\n", stderr);
  }
  return exit_failed;
}

}  // namespace parapet::cli
