#include "run_monitor.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "duration_text.hpp"
#include "parapet/designs/text.hpp"

namespace parapet::cli {
namespace {

constexpr std::chrono::milliseconds terminal_interval{200};
constexpr std::chrono::seconds plain_interval{15};

/// Of standard error; 80 where the terminal does not say.
std::size_t terminal_columns() {
  winsize size{};
  const bool known = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : 80;
}

double seconds(std::chrono::steady_clock::duration duration) {
  return std::chrono::duration<double>(duration).count();
}

}  // namespace

std::string cut_to_width(const std::string& text, std::size_t columns) {
  std::size_t shown = 0, kept = 0;  // characters, and bytes of those that leave room for the mark
  for (std::size_t k = 0; k < text.size(); ++k) {
    const bool continues = (static_cast<unsigned char>(text[k]) & 0xC0U) == 0x80U;
    if (!continues && ++shown + 1 == columns) kept = k;
  }
  // The last column stays free: some terminals go to the next line when it is written.
  return shown < columns ? text : text.substr(0, kept) + "…";
}

std::string progress_line(const std::string& count, const std::string& best,
                          const std::string& left, const std::string& running) {
  std::string text;
  for (const std::string& part : {count, best, left, running}) {
    if (!text.empty() && !part.empty()) text += "; ";
    text += part;
  }
  return text;
}

RunMonitor::RunMonitor(const Session& session, int total, std::string noun)
    : session_(session),
      terminal_(isatty(STDERR_FILENO) != 0),
      total_(total),
      noun_(std::move(noun)) {}

RunMonitor::~RunMonitor() {
  if (line_open_) std::fputs("\r\033[K", stderr);
}

void RunMonitor::running(const std::string& id, const solver::Progress& progress) {
  const std::scoped_lock lock(mutex_);
  running_[id] = progress;
  show();
}

void RunMonitor::ended(const std::string& id, bool skipped) {
  const std::scoped_lock lock(mutex_);
  running_.erase(id);
  ++(skipped ? skipped_ : ended_);
  show();
}

void RunMonitor::simulation_ended(const std::string& id) {
  const std::scoped_lock lock(mutex_);
  running_.erase(id);
}

void RunMonitor::share(double done) {
  const std::scoped_lock lock(mutex_);
  share_ = done;
  show();
}

void RunMonitor::best(std::string text) {
  const std::scoped_lock lock(mutex_);
  best_ = std::move(text);
}

void RunMonitor::show() {
  if (session_.quiet) return;
  const auto now = Clock::now();
  if (terminal_) {
    if (now - shown_ < terminal_interval) return;
    const std::string text = cut_to_width(designs::visible_text(line()), terminal_columns());
    std::fprintf(stderr, "\r\033[K%s", text.c_str());
    std::fflush(stderr);
    line_open_ = true;
  } else {
    if (now - shown_ < plain_interval) return;
    session_.log->info("{}", line());
  }
  shown_ = now;
}

std::string RunMonitor::line() const {
  std::string count, running;
  if (!noun_.empty()) count = fmt::format("{} of {} {}", ended_ + skipped_, total_, noun_);
  if (share_) count = fmt::format("{:.0f} % of the work", 100.0 * *share_);
  int shown = 0;
  for (const auto& [id, progress] : running_) {
    if (++shown > 2) {  // more do not fit on a line
      running += ", ...";
      break;
    }
    if (shown > 1) running += ", ";
    running += fmt::format("{} at {:.2f} of {:.2f} s", id, progress.time, progress.stop_time);
  }
  return progress_line(count, best_, remaining_time(), running);
}

double RunMonitor::share_done() const {
  if (share_) return std::clamp(*share_, 0.0, 1.0);
  double done = ended_;
  for (const auto& [id, progress] : running_) {
    if (progress.stop_time > 0.0) done += progress.time / progress.stop_time;
  }
  const double all = std::max(1, total_ - skipped_);
  return std::clamp(done / all, 0.0, 1.0);
}

std::string RunMonitor::remaining_time() const {
  const double share = share_done();
  const double elapsed = seconds(Clock::now() - begin_);
  if (share < 1e-4) return "estimating";
  return "at most " + duration_text(elapsed * (1.0 - share) / share) + " left";
}

}  // namespace parapet::cli
