#include <chrono>
#include <memory>
#include <thread>

#include "common_options.hpp"
#include "interrupt.hpp"
#include "page_server.hpp"
#include "parapet/designs/error.hpp"
#include "session.hpp"

namespace parapet::cli {
namespace {

struct ServeOptions {
  std::filesystem::path folder;
  int port = 0;
};

int serve_command(const Session& session, const ServeOptions& options) {
  if (!std::filesystem::is_directory(options.folder)) {
    throw designs::InputError({{options.folder.string(), "", "", "is no folder",
                                "a folder that simulate, table3, optimize or validate writes"}});
  }
  const PageServer server(options.folder, session.program, options.port);
  session.out->print("{}\n", server.address());
  session.log->info("Ctrl-C ends it");
  while (!interrupted()) std::this_thread::sleep_for(std::chrono::milliseconds(100));
  return exit_done;
}

}  // namespace

void add_serve(CLI::App& app, Session& session) {
  CLI::App* verb =
      app.add_subcommand("serve", "Show the page of a folder live, while a study runs");
  auto options = std::make_shared<ServeOptions>();
  verb->add_option("DIR", options->folder, "Folder of results, or of a study that runs")
      ->required();
  verb->add_option("--port", options->port, "Port on this machine (default: any free one)")
      ->check(CLI::Range(0, 65535))
      ->type_name("N");
  verb->footer(
      R"(Prints the address and serves until Ctrl-C. Only this machine can ask, only for the page: no file is
served, and nothing can be changed. The page says when there is something new.

Examples:
  parapet serve runs/quickstart-optimize
  parapet optimize designs/quickstart.json --serve)");
  verb->callback([options, &session] {
    session.command = [options, &session] { return serve_command(session, *options); };
  });
}

}  // namespace parapet::cli
