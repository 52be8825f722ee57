#include "parapet/records/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <random>
#include <system_error>

namespace parapet::records {
namespace {

constexpr std::string_view aside_begin = ".parapet-", aside_end = ".tmp";
constexpr std::size_t aside_digits = 16;

[[noreturn]] void refuse_link(const std::filesystem::path& file) {
  throw FileError(file.string() + " is a link: inside a folder of results no link is followed");
}

/// ".parapet-0123456789abcdef.tmp", at random.
std::string name_aside() {
  std::uint64_t number = 0;
  if (::getrandom(&number, sizeof(number), 0) != static_cast<ssize_t>(sizeof(number))) {
    std::random_device device;
    number = (static_cast<std::uint64_t>(device()) << 32) | device();
  }
  return fmt::format("{}{:016x}{}", aside_begin, number, aside_end);
}

bool only(std::string_view text, std::string_view characters) {
  return !text.empty() && text.find_first_not_of(characters) == std::string_view::npos;
}

}  // namespace

bool is_written_aside(std::string_view name) {
  if (name.starts_with(aside_begin) && name.ends_with(aside_end)) {
    name.remove_prefix(aside_begin.size());
    name.remove_suffix(aside_end.size());
    return name.size() == aside_digits && only(name, "0123456789abcdef");
  }
  const std::size_t at = name.rfind(aside_end);
  if (at == std::string_view::npos || !only(name.substr(at + aside_end.size()), "0123456789")) {
    return false;
  }
  const std::string_view written = name.substr(0, at);
  constexpr std::array<std::string_view, 6> endings{".json", ".csv", ".md", ".png", ".pvd", ".vtp"};
  return std::any_of(endings.begin(), endings.end(),
                     [&](std::string_view ending) { return written.ends_with(ending); });
}

namespace {

/// Closes a descriptor and removes the unfinished file unless the rename succeeded.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::filesystem::path& folder) {
    constexpr int flags = O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
    do {
      path_ = folder / name_aside();
      descriptor_ = ::open(path_.c_str(), flags, 0644);
    } while (descriptor_ < 0 && errno == EEXIST);
    if (descriptor_ < 0) throw_file_error("create", path_, errno);
    // Tells remove_orphans that somebody still writes. Some file systems have no locks.
    ::flock(descriptor_, LOCK_EX | LOCK_NB);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (!renamed_) ::unlink(path_.c_str());
    ::close(descriptor_);
  }

  void write(std::string_view content) const {
    while (!content.empty()) {
      const ssize_t written = ::write(descriptor_, content.data(), content.size());
      if (written < 0) {
        if (errno == EINTR) continue;
        throw_file_error("write", path_, errno);
      }
      content.remove_prefix(static_cast<std::size_t>(written));
    }
    if (::fsync(descriptor_) != 0) throw_file_error("sync", path_, errno);
  }

  void rename_to(const std::filesystem::path& target) {
    if (::rename(path_.c_str(), target.c_str()) != 0) throw_file_error("write", target, errno);
    renamed_ = true;
  }

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
  bool renamed_ = false;
};

std::filesystem::path folder_of(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

}  // namespace

void throw_file_error(std::string_view action, const std::filesystem::path& path,
                      int error_number) {
  throw FileError("cannot " + std::string(action) + " " + path.string() + ": " +
                  std::generic_category().message(error_number));
}

void write_file_atomically(const std::filesystem::path& file, std::string_view content) {
  std::error_code ignored;
  if (std::filesystem::is_symlink(file, ignored)) refuse_link(file);
  TemporaryFile temporary(folder_of(file));
  temporary.write(content);
  temporary.rename_to(file);
  sync_folder(folder_of(file));
}

void remove_orphans(const std::filesystem::path& folder) {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    if (!is_written_aside(entry.path().filename().string())) continue;
    const int descriptor = ::open(entry.path().c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC);
    if (descriptor < 0) continue;
    if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) ::unlink(entry.path().c_str());
    ::close(descriptor);
  }
}

void make_folder(const std::filesystem::path& folder) {
  if (folder.empty() || std::filesystem::is_directory(folder)) return;
  std::error_code error;
  make_folder(folder.parent_path());
  const bool created = std::filesystem::create_directory(folder, error);
  if (!std::filesystem::is_directory(folder)) {
    if (!error) error = std::make_error_code(std::errc::not_a_directory);
    throw FileError("cannot create the folder " + folder.string() + ": " + error.message());
  }
  if (created) sync_folder(folder_of(folder));
}

void sync_folder(const std::filesystem::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) throw_file_error("open the folder", folder, errno);
  const int failed = ::fsync(descriptor);
  const int error_number = errno;
  ::close(descriptor);
  // Some file systems cannot sync a folder and say EINVAL: there is nothing more to be done there.
  if (failed != 0 && error_number != EINVAL) {
    throw_file_error("sync the folder", folder, error_number);
  }
}

std::string read_file(const std::filesystem::path& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) throw_file_error("read", file, EISDIR);
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw_file_error("read", file, errno != 0 ? errno : EIO);
  std::string content{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (stream.bad()) throw_file_error("read", file, EIO);
  return content;
}

int open_own_file(const std::filesystem::path& file, int flags) {
  // Without O_NONBLOCK the opening of a pipe would wait for its other end.
  const int descriptor = ::open(file.c_str(), flags | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0644);
  if (descriptor < 0 && errno == ELOOP) refuse_link(file);
  if (descriptor < 0) throw_file_error("open", file, errno);
  struct stat status {};
  const bool known = ::fstat(descriptor, &status) == 0;
  const bool writes = (flags & O_ACCMODE) != O_RDONLY;
  if (known && S_ISREG(status.st_mode) && (!writes || status.st_nlink <= 1)) return descriptor;
  ::close(descriptor);
  throw FileError("cannot open " + file.string() +
                  (known && S_ISREG(status.st_mode) ? ": the file has another name elsewhere"
                                                    : ": it is not a regular file"));
}

std::string read_own_file(const std::filesystem::path& file) {
  const int descriptor = open_own_file(file, O_RDONLY);
  std::string content;
  std::array<char, 65536> part{};
  for (;;) {
    const ssize_t size = ::read(descriptor, part.data(), part.size());
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) {
      const int error_number = errno;
      ::close(descriptor);
      if (size < 0) throw_file_error("read", file, error_number);
      return content;
    }
    content.append(part.data(), static_cast<std::size_t>(size));
  }
}

}  // namespace parapet::records
