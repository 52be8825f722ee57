#include "page_server.hpp"

#include <fmt/format.h>
#include <httplib.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "parapet/designs/error.hpp"
#include "parapet/records/atomic_file.hpp"
#include "parapet/reports/page.hpp"

namespace parapet::cli {
namespace {

namespace fs = std::filesystem;
using designs::Json;

constexpr const char* host = "127.0.0.1";
constexpr auto look_interval = std::chrono::milliseconds(500);

/// A page that is open needs a thread for its events; some must be left for others.
constexpr int threads = 8, most_listeners = 6;

/// What changes when a study or a sweep goes on, or a run has ended: sizes and times of its files.
using Progress = std::vector<std::pair<std::uintmax_t, fs::file_time_type>>;

Progress progress_of(const fs::path& folder) {
  Progress now;
  for (const char* name : {"evaluations.jsonl", "summary.json", "recommendation.json",
                           "result.json", "rows", "recordings"}) {
    std::error_code no_size, no_time;
    const auto size = fs::file_size(folder / name, no_size);
    const auto time = fs::last_write_time(folder / name, no_time);
    now.emplace_back(no_size ? 0 : size, no_time ? fs::file_time_type{} : time);
  }
  return now;
}

/// {designs, state} of summary.json, for the page.
std::string event_of(const fs::path& folder) {
  Json event{{"designs", 0}, {"state", "waiting"}};
  try {
    const Json summary =
        Json::parse(records::read_own_file(folder / "summary.json"), nullptr, false);
    if (summary.is_object()) {
      event["designs"] = summary.value("evaluations", 0);
      event["state"] = summary.value("state", "running");
    }
  } catch (const records::FileError&) {  // not there yet
  }
  return "event: changed\ndata: " + event.dump() + "\n\n";
}

/// A page that asks again, for a folder without results.
std::string waiting_page() {
  return "<!doctype html><html lang=\"en\"><head><meta charset=\"utf-8\">"
         "<meta http-equiv=\"refresh\" content=\"2\"><title>Parapet</title></head>"
         "<body><h1>Parapet</h1><p>There are no results yet. This page asks again every two "
         "seconds.</p></body></html>\n";
}

}  // namespace

class PageServer::Server {
 public:
  Server(fs::path folder, records::ProgramInfo program, int port)
      : folder_(std::move(folder)), program_(std::move(program)) {
    server_.new_task_queue = [] { return new httplib::ThreadPool(threads); };
    server_.set_payload_max_length(1024);
    server_.set_read_timeout(5);
    server_.set_keep_alive_max_count(20);
    server_.set_default_headers({{"X-Content-Type-Options", "nosniff"},
                                 {"Cache-Control", "no-store"},
                                 {"Referrer-Policy", "no-referrer"},
                                 {"Cross-Origin-Resource-Policy", "same-origin"},
                                 {"X-Frame-Options", "DENY"}});
    server_.set_pre_routing_handler(
        [this](const httplib::Request& request, httplib::Response& response) {
          return refuse(request, response);
        });
    server_.Get("/", [this](const httplib::Request&, httplib::Response& response) {
      // Not set_content: it compresses with Brotli's slowest level, 14 s for a page of 1.6 MB.
      auto text = std::make_shared<const std::string>(page());
      response.set_content_provider(
          text->size(), "text/html; charset=utf-8",
          [text](std::size_t begin, std::size_t length, httplib::DataSink& sink) {
            return sink.write(text->data() + begin, length);
          });
    });
    server_.Get("/favicon.ico", [](const httplib::Request&, httplib::Response& response) {
      response.status = 204;  // browsers ask for one
    });
    server_.Get("/events", [this](const httplib::Request&, httplib::Response& response) {
      if (++listeners_ > most_listeners) {
        --listeners_;
        response.status = 503;
        response.set_content("too many pages are open\n", "text/plain");
        return;
      }
      response.set_chunked_content_provider(
          "text/event-stream",
          [this, seen = progress_of(folder_), idle = 0](
              std::size_t, httplib::DataSink& sink) mutable { return tell(sink, seen, idle); },
          [this](bool) { --listeners_; });
    });
    if (port == 0) {
      port_ = server_.bind_to_any_port(host);
    } else if (server_.bind_to_port(host, port)) {
      port_ = port;
    }
    if (port_ <= 0) {
      throw records::FileError(fmt::format("cannot serve on port {}: it is taken", port));
    }
    thread_ = std::thread([this] { server_.listen_after_bind(); });
    while (!server_.is_running()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }

  ~Server() {
    ending_ = true;
    server_.stop();
    thread_.join();
  }

  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  int port() const { return port_; }

 private:
  /// A page of another site may ask a name of its own that leads here (DNS rebinding), or this
  /// address itself (browsers say so by Sec-Fetch-Site, older ones by Origin).
  httplib::Server::HandlerResponse refuse(const httplib::Request& request,
                                          httplib::Response& response) const {
    const std::string named = request.get_header_value("Host");
    const bool known =
        named == fmt::format("{}:{}", host, port_) || named == fmt::format("localhost:{}", port_);
    const std::string origin = request.get_header_value("Origin");
    const bool ours = known && request.get_header_value("Sec-Fetch-Site") != "cross-site" &&
                      (origin.empty() || origin == "http://" + named);
    const bool reads = request.method == "GET" || request.method == "HEAD";
    if (ours && reads) return httplib::Server::HandlerResponse::Unhandled;
    response.status = ours ? 405 : 403;
    response.set_content(ours ? "only GET\n" : "for this machine alone\n", "text/plain");
    return httplib::Server::HandlerResponse::Handled;
  }

  std::string page() {
    const std::scoped_lock lock(mutex_);
    const Progress now = progress_of(folder_);
    if (!page_.empty() && now == made_at_) return page_;
    try {
      page_ = reports::folder_report(folder_, {.program = program_, .live = true}).page;
      made_at_ = now;
      return page_;
    } catch (const designs::InputError&) {
      return waiting_page();
    } catch (const records::FileError&) {
      return waiting_page();
    }
  }

  /// Waits for news a while; the server asks again.
  bool tell(httplib::DataSink& sink, Progress& seen, int& idle) const {
    std::this_thread::sleep_for(look_interval);
    if (ending_) {
      sink.done();
      return true;
    }
    if (!sink.is_writable()) return false;  // the page was closed
    const Progress now = progress_of(folder_);
    std::string text;
    if (!(now == seen)) {
      seen = now;
      text = event_of(folder_);
    } else if (++idle % 20 == 0) {
      text = ": still here\n\n";  // keeps the connection
    }
    return text.empty() || sink.write(text.data(), text.size());
  }

  fs::path folder_;
  records::ProgramInfo program_;
  httplib::Server server_;
  int port_ = -1;
  std::mutex mutex_;  // guards the page
  std::string page_;
  Progress made_at_;
  std::atomic<bool> ending_ = false;
  std::atomic<int> listeners_ = 0;
  std::thread thread_;
};

PageServer::PageServer(fs::path folder, records::ProgramInfo program, int port)
    : server_(std::make_unique<Server>(std::move(folder), std::move(program), port)) {}

PageServer::~PageServer() = default;

std::string PageServer::address() const {
  return fmt::format("http://{}:{}/", host, server_->port());
}

}  // namespace parapet::cli
