#include "parapet/records/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>

namespace parapet::records {
namespace {

/// Closes a descriptor and removes the unfinished file unless the rename succeeded.
class TemporaryFile {
 public:
  explicit TemporaryFile(std::filesystem::path path) : path_(std::move(path)) {
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (descriptor_ < 0) throw_file_error("create", path_, errno);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!renamed_) ::unlink(path_.c_str());
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
  // The process id keeps two programs that write the same file from sharing the file aside.
  std::filesystem::path aside = file;
  aside += ".tmp" + std::to_string(::getpid());
  TemporaryFile temporary(aside);
  temporary.write(content);
  temporary.rename_to(file);
  sync_folder(folder_of(file));
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (std::filesystem::is_directory(folder)) return;
  if (!error) error = std::make_error_code(std::errc::not_a_directory);
  throw FileError("cannot create the folder " + folder.string() + ": " + error.message());
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

}  // namespace parapet::records
