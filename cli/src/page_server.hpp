/// The page of a folder over HTTP, for this machine alone.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "parapet/records/program_info.hpp"

namespace parapet::cli {

/// Serves the page on the loopback interface while it lives, made anew when the folder has changed:
/// "/" is the page, "/events" tells it of new designs (server-sent events). There is nothing else:
/// no file is served, nothing can be written, and requests that name another host are refused.
class PageServer {
 public:
  /// @param port 0: any free one
  /// @throws records::FileError when the port cannot be taken
  PageServer(std::filesystem::path folder, records::ProgramInfo program, int port);
  ~PageServer();
  PageServer(const PageServer&) = delete;
  PageServer& operator=(const PageServer&) = delete;

  /// "http://127.0.0.1:8080/".
  std::string address() const;

 private:
  class Server;
  std::unique_ptr<Server> server_;
};

}  // namespace parapet::cli
