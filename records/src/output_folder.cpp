#include "parapet/records/output_folder.hpp"

#include <array>
#include <string_view>
#include <vector>

#include "parapet/records/atomic_file.hpp"
#include "parapet/records/checksum_list.hpp"
#include "parapet/records/result_json.hpp"

namespace parapet::records {
namespace {

namespace fs = std::filesystem;
using designs::Json;

constexpr const char* marker = ".parapet";
constexpr const char* marker_format = "parapet-folder/1";
constexpr std::array<const char*, 4> inner_folders{"evaluations", "frames", "recordings", "rows"};

std::string kind_name(FolderKind kind) {
  switch (kind) {
    case FolderKind::simulation:
      return "simulation";
    case FolderKind::sweep:
      return "sweep";
    case FolderKind::advice:
      return "recommendation";
    case FolderKind::validation:
      return "validation";
    case FolderKind::study:
      break;
  }
  return "study";
}

/// A JSON file's member, as text; empty where there is none.
std::string member(const fs::path& file, const char* key) {
  std::error_code ignored;
  if (!fs::is_regular_file(fs::symlink_status(file, ignored))) return "";
  try {
    const Json json = Json::parse(read_own_file(file), nullptr, false);
    return json.is_object() && json.contains(key) && json[key].is_string()
               ? json[key].get<std::string>()
               : "";
  } catch (const FileError&) {
    return "";
  }
}

/// Whether one of the JSON files in a folder has a member with this text, or with any for "".
bool holds(const fs::path& folder, const char* key, std::string_view text) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    if (entry.path().extension() != ".json") continue;
    const std::string found = member(entry.path(), key);
    if (!found.empty() && (text.empty() || found == text)) return true;
  }
  return false;
}

/// Whether results of a kind stand there, with or without the marker: 0.1.0 wrote none.
bool holds_results(const fs::path& folder, FolderKind kind) {
  switch (kind) {
    case FolderKind::simulation:
      return member(folder / "result.json", "format") == "parapet-result/1";
    case FolderKind::sweep:
      return holds(folder, "format", "parapet-sweep-result/1") ||
             holds(folder / "rows", "format", "parapet-result/1");
    case FolderKind::advice:
      return member(folder / "recommendation.json", "format") == "parapet-recommendation/1";
    case FolderKind::validation:
      return holds(folder, "suite", "");
    case FolderKind::study:
      break;
  }
  return member(folder / "study.json", "format").starts_with("parapet-study-state/");
}

/// What stands there beside lock, marker and files being written; empty for nothing.
std::string first_entry(const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(folder)) {
    std::string name = entry.path().filename().string();
    if (name != ".lock" && name != marker && !is_written_aside(name)) return name;
  }
  return "";
}

[[noreturn]] void refuse(const fs::path& folder, const std::string& problem,
                         const std::string& allowed) {
  throw designs::InputError({{folder.string(), "", "", problem, allowed}});
}

void refuse_links_in(const fs::path& folder) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    if (!entry.is_symlink(ignored)) continue;
    refuse(entry.path(), "is a link, and inside a folder of results no link is followed",
           "files and folders of its own; or another folder, with --out");
  }
}

}  // namespace

void refuse_links(const fs::path& folder) {
  refuse_links_in(folder);
  for (const char* inner : inner_folders) refuse_links_in(folder / inner);
}

void open_output_folder(const fs::path& folder, FolderKind kind) {
  make_folder(folder);
  refuse_links(folder);
  const std::string marked = member(folder / marker, "holds");
  const std::string allowed = "a new or empty folder, or one with results of a " + kind_name(kind) +
                              "; choose it with --out";
  if (marked == kind_name(kind)) return;
  if (!marked.empty()) refuse(folder, "this folder holds results of a " + marked, allowed);
  const std::string entry = first_entry(folder);
  if (entry.empty() || holds_results(folder, kind)) return;
  refuse(folder, "this folder is not Parapet's: it holds " + Json(entry).dump(-1, ' ', true),
         allowed);
}

void take_output_folder(const fs::path& folder, FolderKind kind) {
  remove_orphans(folder);
  for (const char* inner : inner_folders) {
    if (fs::is_directory(folder / inner)) remove_orphans(folder / inner);
  }
  if (!member(folder / marker, "holds").empty()) return;
  Json json;
  json["format"] = marker_format;
  json["holds"] = kind_name(kind);
  write_file_atomically(folder / marker, json_text(json));
}

void remove_earlier_advice(const fs::path& folder) {
  std::vector<fs::path> files{folder / report_page,           folder / designs_table,
                              folder / "recommendation.json", folder / "recommendation.md",
                              folder / "sensitivity.json",    folder / "hypervolume.png"};
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("front") && name.ends_with(".png")) files.push_back(entry.path());
  }
  for (const fs::path& file : files) {
    std::error_code error;
    fs::remove(file, error);
    if (error) throw_file_error("remove", file, error.value());
  }
}

void remove_earlier_simulation(const fs::path& folder) {
  std::vector<fs::path> files{
      folder / checksum_list,   folder / "result.json",        folder / "series.csv",
      folder / "flow.png",      folder / simulation_recording, folder / report_page,
      folder / "approach.json", folder / "pressure.csv",       folder / "pressure.png"};
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder / "frames", ignored)) {
    const std::string ending = entry.path().extension().string();
    if (ending == ".pvd" || ending == ".vtp") files.push_back(entry.path());
  }
  for (const fs::path& file : files) {
    std::error_code error;
    fs::remove(file, error);
    if (error) throw_file_error("remove", file, error.value());
  }
  fs::remove(folder / "frames", ignored);  // only when it is empty
}

}  // namespace parapet::records
