#include "parapet/records/folder_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <string>
#include <thread>

#include "parapet/designs/error.hpp"
#include "parapet/records/atomic_file.hpp"

namespace parapet::records {
namespace {

/// The process id that the holder wrote into the lock file; empty when there is none.
std::string holder(int descriptor) {
  std::array<char, 32> text{};
  const ssize_t size = ::pread(descriptor, text.data(), text.size(), 0);
  std::string id(text.data(), size > 0 ? static_cast<std::size_t>(size) : 0);
  const bool number =
      !id.empty() && std::all_of(id.begin(), id.end(), [](char c) { return c >= '0' && c <= '9'; });
  return number ? id : "";
}

bool wait_for_lock(int descriptor, const std::filesystem::path& file,
                   std::chrono::milliseconds patience) {
  const auto deadline = std::chrono::steady_clock::now() + patience;
  while (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
    if (errno == EINTR) continue;
    if (errno != EWOULDBLOCK) throw_file_error("lock", file, errno);
    if (std::chrono::steady_clock::now() >= deadline) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return true;
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder, std::chrono::milliseconds patience) {
  const std::filesystem::path file = folder / ".lock";
  descriptor_ = open_own_file(file, O_RDWR | O_CREAT);
  try {
    if (!wait_for_lock(descriptor_, file, patience)) {
      const std::string id = holder(descriptor_);
      throw designs::InputError(
          {{.file = folder.string(),
            .pointer = "",
            .value = "",
            .problem = "another parapet process" + (id.empty() ? "" : " (process " + id + ")") +
                       " is writing into this folder",
            .allowed = "one writer at a time; wait for it, or choose another folder with --out"}});
    }
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
  // Only for the message above; the lock does not depend on it.
  const std::string id = std::to_string(::getpid());
  if (::ftruncate(descriptor_, 0) == 0) {
    [[maybe_unused]] const ssize_t written = ::pwrite(descriptor_, id.data(), id.size(), 0);
  }
}

FolderLock::~FolderLock() {
  ::close(descriptor_);
}

}  // namespace parapet::records
