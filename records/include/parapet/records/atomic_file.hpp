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

/// Writes a file so that a crash at any moment leaves either the old or the new content on disk. It
/// is written aside under a name that cannot be guessed, in the same folder.
/// @throws FileError, also where `file` is a link
void write_file_atomically(const std::filesystem::path& file, std::string_view content);

/// Whether a file of this name is one being written aside, by this version or by 0.1.0
/// ("result.json.tmp1234").
bool is_written_aside(std::string_view name);

/// Removes what a crash left of files being written aside in a folder; not those that a running
/// process still writes. Nothing happens where that is not possible.
void remove_orphans(const std::filesystem::path& folder);

/// Creates a folder with its parents and makes all of them durable; an existing folder is fine.
/// @throws FileError, also where a file stands in the way.
void make_folder(const std::filesystem::path& folder);

/// Makes the creation or renaming of entries of a folder durable.
/// @throws FileError
void sync_folder(const std::filesystem::path& folder);

/// Content of a whole file.
/// @throws FileError
std::string read_file(const std::filesystem::path& file);

/// Opens a file in a folder of ours: never through a link at its end, and only a regular file. One
/// that is opened for writing must not have a second name elsewhere (a hard link).
/// @param flags of open(2)
/// @return a descriptor
/// @throws FileError
int open_own_file(const std::filesystem::path& file, int flags);

/// Content of such a file.
/// @throws FileError
std::string read_own_file(const std::filesystem::path& file);

}  // namespace parapet::records
