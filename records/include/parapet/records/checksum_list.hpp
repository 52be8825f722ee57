/// checksums.sha256: what the files of a folder of results held when they were written, in the
/// format of `sha256sum -c`.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace parapet::records {

constexpr const char* checksum_list = "checksums.sha256";

/// The list of a folder while its files change. Files are named by their path from the folder. Logs
/// (.jsonl), whose lines carry checksums of their own, and hidden files are not in it.
class ChecksumList {
 public:
  /// Reads the list that is there, compares the files with it and changes nothing.
  /// @throws FileError
  explicit ChecksumList(std::filesystem::path folder);

  /// Files that are missing or not what they were, in alphabetical order.
  const std::vector<std::string>& damaged() const { return damaged_; }

  /// A sentence about one of them.
  std::string note(const std::string& file) const;

  /// Removes the list: the files are going to change.
  /// @throws FileError
  void begin();

  /// Writes the list of all files that are there. A damaged file that was not written anew keeps
  /// its old checksum: it stays known as damaged.
  /// @throws FileError
  void write() const;

 private:
  std::filesystem::path folder_;
  std::map<std::string, std::string> listed_;        // file -> checksum, as the list says
  std::map<std::string, std::string> damaged_sums_;  // file -> checksum that was found
  std::vector<std::string> damaged_;
};

/// Enters files into the list of a folder, or replaces what it says of them; makes a list where
/// there is none.
/// @param files paths from the folder
/// @throws FileError
void update_checksums(const std::filesystem::path& folder, const std::set<std::string>& files);

}  // namespace parapet::records
