#include "standard_streams.hpp"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>

#include "parapet/designs/text.hpp"
#include "parapet/records/atomic_file.hpp"

namespace parapet::cli {

void open_standard_streams() {
  std::signal(SIGPIPE, SIG_IGN);
  // The modes of the first two are the wrong ones on purpose: their use must fail.
  constexpr std::array<int, 3> modes{O_WRONLY, O_RDONLY, O_WRONLY};
  for (int descriptor = 0; descriptor < 3; ++descriptor) {
    if (::fcntl(descriptor, F_GETFD) >= 0 || errno != EBADF) continue;
    // The lowest number that is free is this one. Without /dev/null another open descriptor serves.
    const int mode = modes[static_cast<std::size_t>(descriptor)];
    if (::open("/dev/null", mode) < 0 && ::open("/", O_RDONLY | O_DIRECTORY) < 0) ::_exit(1);
  }
}

void StandardOutput::write(std::string_view given) {
  const std::string shown = designs::visible_lines(given);
  std::string_view text = shown;
  while (error_ == 0 && !text.empty()) {
    used_ = true;
    const ssize_t written = ::write(STDOUT_FILENO, text.data(), text.size());
    if (written >= 0) {
      text.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      error_ = errno;
    }
  }
}

int StandardOutput::finish() {
  if (error_ != 0 || !used_) return error_;
  // Some file systems say only when a file is closed that there was no room for it.
  const int copy = ::dup(STDOUT_FILENO);
  if (copy < 0 || ::close(copy) != 0) error_ = errno;
  return error_;
}

std::string read_standard_input() {
  std::string text;
  std::array<char, 65536> part{};
  for (;;) {
    const ssize_t size = ::read(STDIN_FILENO, part.data(), part.size());
    if (size == 0) return text;
    if (size > 0) {
      text.append(part.data(), static_cast<std::size_t>(size));
    } else if (errno != EINTR) {
      records::throw_file_error("read", "standard input", errno);
    }
  }
}

InputLines::State InputLines::next(std::string& line) {
  std::size_t searched = 0;
  for (;;) {
    const std::size_t end = waiting_.find('\n', searched);
    if (end != std::string::npos || (ended_ && !waiting_.empty())) {
      line = waiting_.substr(0, end);
      waiting_.erase(0, end == std::string::npos ? end : end + 1);
      ++number_;
      return State::line;
    }
    if (ended_) return State::end;
    searched = waiting_.size();
    pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
    constexpr int look_up_ms = 100;
    const int ready = ::poll(&input, 1, look_up_ms);
    if (cancelled_()) return State::cancelled;
    if (ready <= 0) continue;
    std::array<char, 65536> part{};
    const ssize_t size = ::read(STDIN_FILENO, part.data(), part.size());
    if (size > 0) {
      waiting_.append(part.data(), static_cast<std::size_t>(size));
    } else if (size == 0) {
      ended_ = true;
    } else if (errno != EINTR && errno != EAGAIN) {
      records::throw_file_error("read", "standard input", errno);
    }
  }
}

}  // namespace parapet::cli
