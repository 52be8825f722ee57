// parapet serve, asked by raw requests: what it gives, and what it refuses.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <iomanip>
#include <optional>
#include <sstream>
#include <thread>
#include <vector>

#include "program_runner.hpp"
#include "tiny_specs.hpp"

namespace parapet::test {
namespace {

using designs::Json;
using ::testing::IsNotSubstring;
using ::testing::IsSubstring;

sockaddr_in loopback(int port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

/// A port that nobody uses at the moment.
int free_port() {
  const int s = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address = loopback(0);
  socklen_t size = sizeof(address);
  EXPECT_EQ(::bind(s, reinterpret_cast<sockaddr*>(&address), size), 0);
  EXPECT_EQ(::getsockname(s, reinterpret_cast<sockaddr*>(&address), &size), 0);
  ::close(s);
  return ntohs(address.sin_port);
}

/// What comes back for a request, until the other side closes, `until` has come, or seconds passed.
std::string ask(int port, const std::string& request, const std::string& until = "",
                int seconds = 5) {
  const int s = ::socket(AF_INET, SOCK_STREAM, 0);
  const timeval patience{.tv_sec = seconds, .tv_usec = 0};
  ::setsockopt(s, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof(patience));
  const sockaddr_in address = loopback(port);
  std::string answer;
  if (::connect(s, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0 &&
      ::send(s, request.data(), request.size(), MSG_NOSIGNAL) >= 0) {
    char buffer[65536];
    while (until.empty() || answer.find(until) == std::string::npos) {
      const ssize_t got = ::recv(s, buffer, sizeof(buffer), 0);
      if (got <= 0) break;
      answer.append(buffer, static_cast<std::size_t>(got));
    }
  }
  ::close(s);
  return answer;
}

class Serve : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_.write("case.json", tiny_case().dump());
    folder_.write("secret.txt", "not for you");
    ASSERT_EQ(run_program(folder_.path(), {"simulate", "case.json", "--out", "out"}).exit_code, 0);
    start("out");
  }

  void start(const std::string& out) {
    port_ = free_port();
    server_.emplace(folder_.path(),
                    std::vector<std::string>{"serve", out, "--port", std::to_string(port_)});
    ASSERT_TRUE(wait_until([&] { return !get("/").empty(); }));
  }

  std::string own_host() const { return "127.0.0.1:" + std::to_string(port_); }

  std::string get(const std::string& path, const std::string& host = "",
                  const std::string& method = "GET") const {
    return ask(port_, method + " " + path + " HTTP/1.1\r\nHost: " +
                          (host.empty() ? own_host() : host) + "\r\nConnection: close\r\n\r\n");
  }

  TemporaryFolder folder_;
  int port_ = 0;
  std::optional<RunningProgram> server_;
};

TEST_F(Serve, GivesThePageAndNothingElse) {
  const std::string page = get("/");
  EXPECT_TRUE(page.starts_with("HTTP/1.1 200")) << page.substr(0, 200);
  EXPECT_PRED_FORMAT2(IsSubstring, "id=\"page-data\"", page);
  EXPECT_PRED_FORMAT2(IsSubstring, "connect-src 'self'", page);
  EXPECT_PRED_FORMAT2(IsSubstring, "X-Content-Type-Options: nosniff", page);
  // As browsers ask. The library would compress at its slowest, which takes longer than the study.
  const std::string asked =
      ask(port_, "GET / HTTP/1.1\r\nHost: " + own_host() +
                     "\r\nAccept-Encoding: gzip, deflate, br\r\nConnection: close\r\n\r\n");
  EXPECT_PRED_FORMAT2(IsNotSubstring, "Content-Encoding", asked.substr(0, asked.find("\r\n\r\n")));
  EXPECT_EQ(asked.size(), page.size());
  EXPECT_TRUE(get("/favicon.ico").starts_with("HTTP/1.1 204"));
  for (const char* path :
       {"/result.json", "/../secret.txt", "/..%2fsecret.txt", "/%2e%2e/secret.txt", "//etc/passwd",
        "/./../../../../etc/passwd", "/report.html", "/.parapet"}) {
    const std::string answer = get(path);
    EXPECT_TRUE(answer.starts_with("HTTP/1.1 404") || answer.starts_with("HTTP/1.1 400"))
        << path << ": " << answer.substr(0, 60);
    EXPECT_PRED_FORMAT2(IsNotSubstring, "not for you", answer);
  }
}

TEST_F(Serve, RefusesOtherHostsMethodsAndMonsters) {
  const std::string own_origin = "http://" + own_host();
  EXPECT_TRUE(get("/", "evil.example").starts_with("HTTP/1.1 403"));
  EXPECT_TRUE(get("/", "evil.example:" + std::to_string(port_)).starts_with("HTTP/1.1 403"));
  EXPECT_TRUE(get("/", "localhost:" + std::to_string(port_)).starts_with("HTTP/1.1 200"));
  for (const char* method : {"POST", "PUT", "DELETE", "PATCH", "OPTIONS"}) {
    EXPECT_TRUE(get("/", "", method).starts_with("HTTP/1.1 405")) << method;
  }
  EXPECT_TRUE(ask(port_, "GET / HTTP/1.1\r\nHost: " + own_host() +
                             "\r\nSec-Fetch-Site: cross-site\r\nConnection: close\r\n\r\n")
                  .starts_with("HTTP/1.1 403"));
  for (const auto& [origin, status] :
       {std::pair("http://evil.example", "403"), std::pair("null", "403"),
        std::pair(own_origin.c_str(), "200")}) {
    EXPECT_TRUE(ask(port_, "GET / HTTP/1.1\r\nHost: " + own_host() + "\r\nOrigin: " + origin +
                               "\r\nConnection: close\r\n\r\n")
                    .starts_with(std::string("HTTP/1.1 ") + status))
        << origin;
  }
  const std::string long_line(100'000, 'a');
  EXPECT_FALSE(get("/" + long_line).starts_with("HTTP/1.1 200"));
  ask(port_, "GET / HTTP/1.1\r\nHost: " + own_host() + "\r\nX: " + long_line + "\r\n\r\n", "", 1);
  ask(port_, std::string("\x00\xff\x16\x03\x01\r\n\r\n", 9), "", 1);
  ask(port_, "GET / HTTP/1.1\r\nHost: " + own_host() + "\r\nContent-Length: -1\r\n\r\n", "", 1);
  ask(port_, "GET / HTTP/9.9\r\n\r\n", "", 1);
  EXPECT_TRUE(get("/").starts_with("HTTP/1.1 200")) << "it must still serve";
}

TEST_F(Serve, TellsOfNewDesignsAndEndsWithCtrlC) {
  const std::string request = "GET /events HTTP/1.1\r\nHost: " + own_host() + "\r\n\r\n";
  std::thread later([&] {
    pause_briefly();
    std::this_thread::sleep_for(std::chrono::milliseconds(800));
    folder_.write("out/summary.json", R"({"evaluations": 7, "state": "running"})");
  });
  const std::string events = ask(port_, request, "\"designs\":7", 10);
  later.join();
  EXPECT_PRED_FORMAT2(IsSubstring, "text/event-stream", events);
  EXPECT_PRED_FORMAT2(IsSubstring, "event: changed", events);
  EXPECT_PRED_FORMAT2(IsSubstring, "\"designs\":7", events);
  server_->send(SIGINT);
  EXPECT_TRUE(wait_until([&] { return server_->ended(); }));
}

TEST_F(Serve, ManyOpenPagesLeaveRoomForOthers) {
  std::vector<std::thread> open;
  std::atomic<int> refused = 0;
  for (int k = 0; k < 12; ++k) {
    open.emplace_back([&] {
      const std::string answer =
          ask(port_, "GET /events HTTP/1.1\r\nHost: " + own_host() + "\r\n\r\n", "nothing", 2);
      if (answer.starts_with("HTTP/1.1 503")) ++refused;
    });
  }
  EXPECT_TRUE(get("/").starts_with("HTTP/1.1 200"));
  for (std::thread& one : open) one.join();
  EXPECT_GE(refused, 1);
  EXPECT_TRUE(get("/").starts_with("HTTP/1.1 200"));
}

// The kernel refuses what is not sent to the loopback address.
TEST_F(Serve, ListensOnTheLoopbackInterfaceAlone) {
  const std::string table = file_text("/proc/net/tcp") + file_text("/proc/net/tcp6");
  std::ostringstream port;
  port << ':' << std::hex << std::uppercase << std::setw(4) << std::setfill('0') << port_;
  int listening = 0;
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string number, local, remote, state;
    words >> number >> local >> remote >> state;
    if (state != "0A" || !local.ends_with(port.str())) continue;
    ++listening;
    EXPECT_EQ(local, "0100007F" + port.str());  // 127.0.0.1
  }
  EXPECT_EQ(listening, 1);
}

TEST_F(Serve, AFolderWithoutResultsAsksForPatience) {
  std::filesystem::create_directory(folder_ / "empty");
  start("empty");
  EXPECT_PRED_FORMAT2(IsSubstring, "There are no results yet", get("/"));
  const Outcome outcome = run_program(folder_.path(), {"serve", "nowhere"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_PRED_FORMAT2(IsSubstring, "is no folder", outcome.err);
}

}  // namespace
}  // namespace parapet::test
