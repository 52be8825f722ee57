#include "parapet/records/checksum_list.hpp"

#include <array>

#include "parapet/records/atomic_file.hpp"
#include "parapet/records/checksum.hpp"

namespace parapet::records {
namespace {

namespace fs = std::filesystem;
using Sums = std::map<std::string, std::string>;  // file -> checksum

constexpr std::size_t sum_digits = 64;
constexpr std::string_view list_gap = "  ";

/// Lines that are not of the format are passed over: the files that they meant count as not listed.
Sums read_list(const fs::path& folder) {
  Sums sums;
  const fs::path file = folder / checksum_list;
  if (!fs::exists(fs::symlink_status(file))) return sums;
  const std::string text = read_own_file(file);
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t end = text.find('\n', begin);
    if (end == std::string::npos) end = text.size();
    const std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    if (line.size() <= sum_digits + list_gap.size() ||
        line.substr(sum_digits, list_gap.size()) != list_gap) {
      continue;
    }
    const std::string name = line.substr(sum_digits + list_gap.size());
    const fs::path path = fs::path(name).lexically_normal();
    // Only files of this folder are looked at, whatever the list says.
    if (path.is_absolute() || *path.begin() == ".." || path.string() != name) continue;
    sums[name] = line.substr(0, sum_digits);
  }
  return sums;
}

void write_list(const fs::path& folder, const Sums& sums) {
  std::string text;
  for (const auto& [file, sum] : sums) text.append(sum).append(list_gap).append(file).append("\n");
  write_file_atomically(folder / checksum_list, text);
}

/// The checksum of a file; empty where it cannot be read.
std::string sum_of(const fs::path& file) {
  try {
    return sha256(read_own_file(file));
  } catch (const FileError&) {
    return "";
  }
}

bool belongs(const fs::path& file) {
  constexpr std::array<std::string_view, 8> endings{".json", ".csv", ".md",   ".png",
                                                    ".pvd",  ".vtp", ".flow", ".html"};
  const std::string ending = file.extension().string();
  if (file.filename().string().starts_with('.')) return false;
  for (const std::string_view one : endings) {
    if (ending == one) return true;
  }
  return false;
}

std::vector<std::string> files_of(const fs::path& folder) {
  std::vector<std::string> files;
  const auto add = [&](const fs::path& inner) {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder / inner, ignored)) {
      if (!entry.is_regular_file(ignored) || entry.is_symlink(ignored)) continue;
      const fs::path name = inner / entry.path().filename();
      if (belongs(name)) files.push_back(name.string());
    }
  };
  for (const char* inner : {"", "evaluations", "frames", "recordings", "rows"}) add(inner);
  return files;
}

}  // namespace

ChecksumList::ChecksumList(fs::path folder)
    : folder_(std::move(folder)), listed_(read_list(folder_)) {
  for (const auto& [file, sum] : listed_) {
    std::string found = sum_of(folder_ / file);
    if (found == sum) continue;
    damaged_.push_back(file);
    damaged_sums_.emplace(file, std::move(found));
  }
}

std::string ChecksumList::note(const std::string& file) const {
  const bool missing = damaged_sums_.at(file).empty();
  return (folder_ / file).string() +
         (missing ? " is missing or cannot be read" : " was changed after it was written") + " (" +
         checksum_list + ")";
}

void ChecksumList::begin() {
  std::error_code error;
  const fs::path file = folder_ / checksum_list;
  fs::remove(file, error);
  if (error) throw_file_error("remove", file, error.value());
}

void ChecksumList::write() const {
  Sums sums;
  for (const std::string& file : files_of(folder_)) sums[file] = sum_of(folder_ / file);
  for (const auto& [file, found] : damaged_sums_) {
    const auto now = sums.find(file);
    const bool as_found = now == sums.end() ? found.empty() : now->second == found;
    if (as_found) sums[file] = listed_.at(file);
  }
  write_list(folder_, sums);
}

void update_checksums(const fs::path& folder, const std::set<std::string>& files) {
  Sums sums = read_list(folder);
  for (const std::string& file : files) sums[file] = sum_of(folder / file);
  write_list(folder, sums);
}

}  // namespace parapet::records
