#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "parapet/records/atomic_file.hpp"
#include "parapet/records/checksum.hpp"
#include "parapet/records/evaluation_log.hpp"

namespace parapet::records {
namespace {

/// What a line holds; `problem` says why it is neither.
struct ParsedLine {
  std::optional<EvaluationRecord> record;
  std::optional<RefusedDesign> refused;
  std::string problem;
  bool has_checksum = false;
};

/// The keys of a line of versions up to 0.1.0. A line with others was written with a checksum.
bool has_only_early_keys(const designs::Json& json) {
  static const std::set<std::string> early{
      "id",        "stage",       "design",     "options",     "status",         "reason",
      "metrics",   "objectives",  "feasible",   "constraints", "metrics_absent", "objective_scalar",
      "spacing_m", "wall_time_s", "cpu_time_s", "scenarios",   "particle_steps", "stop_reason"};
  return std::all_of(json.items().begin(), json.items().end(),
                     [](const auto& item) { return early.contains(item.key()); });
}

/// What a line without a checksum contradicts of itself; empty: nothing.
std::string contradiction(const EvaluationRecord& record) {
  const bool all = std::all_of(record.constraints.begin(), record.constraints.end(),
                               [](const ConstraintRecord& one) { return one.satisfied; });
  const bool fits = record.feasible == (record.ok && all);
  return fits ? "" : "`feasible` contradicts its constraints";
}

ParsedLine parse_line(std::string_view line) {
  ParsedLine parsed;
  const LineChecksum checksum = check_line(line);
  parsed.has_checksum = checksum != LineChecksum::none;
  if (checksum == LineChecksum::wrong) {
    parsed.problem = "its crc32c is not that of its bytes";
    return parsed;
  }
  try {
    const designs::Json json = designs::Json::parse(line);
    if (json.at("status") == "refused") {
      parsed.refused = refused_from_json(json);
    } else {
      parsed.record = record_from_json(json);
    }
    if (parsed.has_checksum) return parsed;
    if (!has_only_early_keys(json)) {
      parsed.problem = "it has no crc32c";
    } else if (parsed.record) {
      parsed.problem = contradiction(*parsed.record);
    }
  } catch (const std::exception& error) {
    parsed.problem = error.what();
  }
  return parsed;
}

/// The first difference between a damaged line and the report that was written beside it.
std::string differing_key(const designs::Json& line, const std::filesystem::path& report_file) {
  try {
    const auto report = designs::Json::parse(read_own_file(report_file));
    for (const auto& [key, value] : line.items()) {
      if (key == "crc32c" || !report.contains(key) || report.at(key) == value) continue;
      const auto changes = designs::Json::diff(report.at(key), value);
      return "/" + key + changes.at(0).at("path").get<std::string>();
    }
  } catch (const std::exception&) {
    // Then the number of the line must do.
  }
  return "";
}

DamagedLine damaged_line(const std::filesystem::path& file, std::size_t number,
                         std::string_view text, std::string problem) {
  DamagedLine damaged{.number = number,
                      .id = "",
                      .key = "",
                      .problem = std::move(problem),
                      .text = std::string(text)};
  const auto json = designs::Json::parse(text, nullptr, false);
  if (!json.is_object() || !json.contains("id") || !json["id"].is_string()) return damaged;
  const auto id = json["id"].get<std::string>();
  if (!is_id(id)) return damaged;
  damaged.id = id;
  damaged.key = differing_key(json, file.parent_path() / "evaluations" / (id + ".json"));
  return damaged;
}

[[noreturn]] void throw_repeated(const std::filesystem::path& file, std::size_t line_number,
                                 const std::string& id) {
  throw designs::InputError({{.file = file.string(),
                              .pointer = "",
                              .value = fmt::format("line {}", line_number),
                              .problem = "the id " + id + " stands in an earlier line too",
                              .allowed = "each design once; remove the line that is wrong"}});
}

}  // namespace

std::string to_string(const DamagedLine& line, const std::filesystem::path& file) {
  std::string what = line.id.empty() ? "" : "design " + line.id;
  if (!line.key.empty()) what += ", " + line.key;
  return fmt::format("{}: line {}{} is damaged: {}", file.string(), line.number,
                     what.empty() ? "" : " (" + what + ")", line.problem);
}

std::string checksum_note(const LogContent& content, const std::filesystem::path& file) {
  if (content.lines_without_checksum == 0) return "";
  return fmt::format(
      "{}: {} of its lines have no checksum, as an earlier version wrote them: a changed digit in "
      "them would not be seen",
      file.string(), content.lines_without_checksum);
}

LogContent read_evaluation_log(const std::filesystem::path& file) {
  LogContent result;
  std::set<std::string> ids;
  const std::string content = read_own_file(file);
  for (std::size_t line_number = 1; result.whole_bytes < content.size(); ++line_number) {
    const std::size_t begin = result.whole_bytes, end = content.find('\n', begin);
    const bool ended = end != std::string::npos;
    const std::string_view line =
        std::string_view(content).substr(begin, (ended ? end : content.size()) - begin);
    ParsedLine parsed = parse_line(line);
    if (!parsed.problem.empty() && !ended) {
      result.incomplete_last_line = true;
      return result;
    }
    result.ends_with_line = ended;
    result.whole_bytes += line.size() + (ended ? 1 : 0);
    if (!parsed.problem.empty()) {
      result.damaged.push_back(damaged_line(file, line_number, line, std::move(parsed.problem)));
      continue;
    }
    const std::string& id = parsed.record ? parsed.record->id : parsed.refused->id;
    if (!ids.insert(id).second) throw_repeated(file, line_number, id);
    if (!parsed.has_checksum) ++result.lines_without_checksum;
    if (parsed.record) {
      result.records.push_back(*std::move(parsed.record));
    } else {
      result.refused.push_back(*std::move(parsed.refused));
    }
  }
  return result;
}

}  // namespace parapet::records
