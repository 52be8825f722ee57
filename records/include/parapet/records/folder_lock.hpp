/// One writer per folder.
#pragma once

#include <chrono>
#include <filesystem>

namespace parapet::records {

/// Holds an exclusive lock on a folder while it lives. The operating system releases it when the
/// process ends, however it ends.
class FolderLock {
 public:
  /// Waits up to `patience` for the lock. The lock is on the file `.lock` in the folder, which
  /// stays behind.
  /// @throws designs::InputError when another process keeps the lock.
  /// @throws FileError
  explicit FolderLock(const std::filesystem::path& folder, std::chrono::milliseconds patience = {});
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_ = -1;
};

}  // namespace parapet::records
