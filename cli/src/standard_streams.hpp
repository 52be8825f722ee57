/// Standard input, output and error, whatever state the caller left them in.
#pragma once

#include <fmt/format.h>

#include <atomic>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

namespace parapet::cli {

/// Opens descriptors 0 to 2 where they are closed, so that no file of ours gets one of these
/// numbers and then what is printed. What stands in for a closed stream refuses its use: reading
/// and writing fail with EBADF, as on the closed descriptor. Standard error's swallows. From now on
/// a reader that goes away is an error of the write (EPIPE), not the end of the process. The first
/// thing in main.
void open_standard_streams();

/// Standard output. Every write is checked; the first that fails is remembered, and what follows is
/// not written. Characters that act on a terminal are written as \uXXXX, so that names cannot.
class StandardOutput {
 public:
  template <typename... T>
  void print(fmt::format_string<T...> format, T&&... arguments) {
    write(fmt::format(format, std::forward<T>(arguments)...));
  }
  void write(std::string_view given);

  /// Asks the file system whether all of it has arrived: the errno value of what went wrong first,
  /// 0 for nothing.
  int finish();

  /// The errno value of the first write that failed so far, 0 for none. From any thread.
  int error() const { return error_; }

 private:
  bool used_ = false;
  std::atomic<int> error_ = 0;
};

/// All of standard input.
/// @throws records::FileError when it cannot be read, also when it is closed
std::string read_standard_input();

/// Lines of standard input as they come.
class InputLines {
 public:
  /// What asking for a line came to.
  enum class State { line, end, cancelled };

  /// @param cancelled polled while there is nothing to read
  explicit InputLines(std::function<bool()> cancelled) : cancelled_(std::move(cancelled)) {}

  /// The next line without its end; what stands after the last line end is a line too.
  /// @throws records::FileError when it cannot be read, also when it is closed
  State next(std::string& line);

  /// Number of the line that came last, counted from 1.
  std::size_t number() const { return number_; }

 private:
  std::function<bool()> cancelled_;
  std::string waiting_;  // read and not given yet
  bool ended_ = false;
  std::size_t number_ = 0;
};

}  // namespace parapet::cli
