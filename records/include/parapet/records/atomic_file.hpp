/// Files that are either complete or not there: written aside, synced, then renamed.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace parapet::records {

/// The file system refused: no permission, disk full, a file where a folder is expected. what() is
/// one sentence naming the path and the cause.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// FileError "cannot ACTION PATH: cause", the cause taken from an errno value.
[[noreturn]] void throw_file_error(std::string_view action, const std::filesystem::path& path,
                                   int error_number);

/// Writes a file so that a crash at any moment leaves either the old or the new content on disk.
/// @throws FileError
void write_file_atomically(const std::filesystem::path& file, std::string_view content);

/// Creates a folder with its parents; an existing folder is fine.
/// @throws FileError, also where a file stands in the way.
void make_folder(const std::filesystem::path& folder);

/// Makes the creation or renaming of entries of a folder durable.
/// @throws FileError
void sync_folder(const std::filesystem::path& folder);

/// Content of a whole file.
/// @throws FileError
std::string read_file(const std::filesystem::path& file);

}  // namespace parapet::records
