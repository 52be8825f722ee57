#include <algorithm>
#include <set>

#include "page_html.hpp"
#include "parapet/designs/case_spec.hpp"
#include "parapet/records/atomic_file.hpp"
#include "parapet/records/checksum_list.hpp"
#include "parapet/records/file_name.hpp"
#include "parapet/records/output_folder.hpp"
#include "parapet/study/record_flows.hpp"
#include "run_blocks.hpp"

namespace parapet::reports {
namespace {

namespace fs = std::filesystem;
using designs::Json;

Json json_file(const fs::path& file) {
  return designs::parse_json(records::read_own_file(file), file.string());
}

bool is_file(const fs::path& file) {
  std::error_code none;
  return fs::is_regular_file(fs::symlink_status(file, none));
}

std::string format_of(const fs::path& file) {
  if (!is_file(file)) return "";
  const Json json = Json::parse(records::read_own_file(file), nullptr, false);
  return json.is_object() ? json.value("format", "") : "";
}

void add_metric_keys(Json& page, const Json& metrics) {
  for (const auto& [key, value] : metrics.items()) add_key(page, key);
}

/// The run of a result file: its scene and its series.
void add_result_run(RunBlocks& runs, const std::string& name, const Json& result,
                    const fs::path& series) {
  if (!result.contains("case") || !result["case"].is_object()) return;
  const designs::CaseSpec spec = designs::parse_case(result["case"], name);
  runs.add_case(name, spec, [&](const std::string& key) -> std::optional<double> {
    const Json& metrics = result.at("metrics");
    const auto found = metrics.find(key);
    if (found == metrics.end() || !found->is_number()) return std::nullopt;
    return found->get<double>();
  });
  if (is_file(series)) {
    runs.add_series(name, spec, series_from_csv(records::read_own_file(series)));
  }
}

std::string simulation_page(const fs::path& folder, const PageOptions& options) {
  const Json result = json_file(folder / "result.json");
  const std::string name = result.at("name").get<std::string>();
  Json page =
      common_json("simulation", name,
                  result.at("/provenance/spec_hash"_json_pointer).get<std::string>(), options);
  const Json& spec = result.at("case");
  page["description"] = spec.is_object() ? spec.value("description", "") : "";
  page["simulated_by"] = simulated_by(result.at("provenance"));
  page["result"] = result;
  page["result"].erase("case");
  add_metric_keys(page, result.at("metrics"));
  const std::string out = " --out " + shell_word(folder.string());
  add_command(page, "simulate the same case again", "parapet simulate CASE" + out + " --record");
  add_command(page, "give every metric its uncertainty",
              "parapet simulate CASE" + out + " --uncertainty --record");
  add_command(page, "simulate it again and compare bit by bit",
              "parapet verify " + shell_word(folder.string()));
  RunBlocks runs(page);
  add_result_run(runs, name, result, folder / "series.csv");
  runs.add_recording(name, folder / records::simulation_recording,
                     "parapet simulate CASE" + out + " --record", "");
  return page_html(page, runs.blocks());
}

/// The file of a sweep with all its rows; empty without one.
fs::path sweep_file(const fs::path& folder) {
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    if (entry.path().extension() != ".json") continue;
    if (format_of(entry.path()) == "parapet-sweep-result/1") return entry.path();
  }
  return {};
}

Json sweep_row_json(const Json& row) {
  static const std::set<std::string> other{
      "id",       "description",      "status",      "reason",      "metrics_absent",
      "steps",    "simulated_time_s", "stop_reason", "wall_time_s", "paper",
      "agreement"};
  Json json{{"metrics", Json::object()}};
  for (const auto& [key, value] : row.items()) {
    if (other.contains(key)) {
      json[key] = value;
    } else {
      json["metrics"][key] = value;
    }
  }
  for (const char* key : {"paper", "agreement", "metrics_absent"}) {
    if (!json.contains(key) || !json[key].is_object()) json[key] = Json::object();
  }
  return json;
}

std::string sweep_page(const fs::path& file, const PageOptions& options) {
  const fs::path folder = file.parent_path();
  const Json sweep = json_file(file);
  const Json provenance = sweep.value("provenance", Json::object());
  const std::string name = sweep.at("name").get<std::string>();
  Json page = common_json("sweep", name, provenance.value("spec_hash", ""), options);
  page["simulated_by"] = simulated_by(provenance);
  page["source"] = sweep.value("source", "");
  page["spacing_m"] = sweep.at("spacing_m");
  page["rows"] = Json::array();
  for (const Json& row : sweep.at("rows")) {
    page["rows"].push_back(sweep_row_json(row));
    add_metric_keys(page, page["rows"].back()["metrics"]);
  }
  const std::string out = " --out " + shell_word(folder.string());
  add_command(page, "simulate the rows that are missing", "parapet table3" + out);
  add_command(page, "record the flows", "parapet table3" + out + " --record");
  add_command(page, "simulate rows again and compare bit by bit",
              "parapet verify " + shell_word(folder.string()));
  RunBlocks runs(page);
  for (const Json& row : page["rows"]) {
    const std::string id = row.at("id").get<std::string>();
    if (const fs::path result = folder / "rows" / (id + ".json"); is_file(result)) {
      add_result_run(runs, id, json_file(result), folder / "rows" / (id + ".csv"));
    }
    runs.add_recording(
        id, study::recording_file(folder, id),
        "parapet table3" + out + " --only " + shell_word(id) + " --record",
        "parapet report " + shell_word(folder.string()) + " --show " + shell_word(id));
  }
  return page_html(page, runs.blocks());
}

/// The scorecards of a validation, by name.
std::vector<Json> scorecards(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    if (entry.path().extension() == ".json" && is_file(entry.path())) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  std::vector<Json> cards;
  for (const fs::path& file : files) {
    Json json = Json::parse(records::read_own_file(file), nullptr, false);
    if (json.is_object() && json.contains("suite") && json.contains("measures")) {
      cards.push_back(std::move(json));
    }
  }
  return cards;
}

std::string validation_page(const fs::path& folder, const std::vector<Json>& cards,
                            const PageOptions& options) {
  Json page = common_json("validation", "Verification and validation", "", options);
  page["cases"] = cards;
  page["figures"] = Json::array();
  add_command(page, "run every case again",
              "parapet validate --out " + shell_word(folder.string()));
  std::vector<PageBlock> blocks;
  std::vector<fs::path> pictures;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    if (entry.path().extension() == ".png" && is_file(entry.path()))
      pictures.push_back(entry.path());
  }
  std::ranges::sort(pictures);
  for (const fs::path& picture : pictures) {
    // CASE_WHAT.png: the longest name of a case that it begins with
    const std::string stem = picture.stem().string();
    std::string owner;
    for (const Json& card : cards) {
      const std::string name = card.at("case").get<std::string>();
      if (stem.starts_with(name) && name.size() > owner.size()) owner = name;
    }
    if (owner.empty()) continue;
    const std::string id = "figure-" + std::to_string(blocks.size());
    blocks.push_back(page_block(id, records::read_own_file(picture)));
    page["figures"].push_back(
        {{"case", owner}, {"file", picture.filename().string()}, {"block", id}});
  }
  return page_html(page, blocks);
}

}  // namespace

FolderReport folder_report(const fs::path& folder, const PageOptions& options) {
  try {
    if (is_file(folder / "study.json")) {
      study::LoadedStudy study = study::load_study_folder(folder);
      return study_report(study, recommend(study, options.rule), options);
    }
    if (format_of(folder / "result.json") == "parapet-result/1") {
      return {.page = simulation_page(folder, options), .designs_csv = {}};
    }
    if (const fs::path sweep = sweep_file(folder); !sweep.empty())
      return {.page = sweep_page(sweep, options), .designs_csv = {}};
    if (const std::vector<Json> cards = scorecards(folder); !cards.empty()) {
      return {.page = validation_page(folder, cards, options), .designs_csv = {}};
    }
  } catch (const Json::exception& error) {
    designs::throw_misread(folder, error);
  }
  throw designs::InputError({{folder.string(), "", "", "this folder holds no results of Parapet",
                              "a folder that simulate, table3, optimize or validate has written"}});
}

void write_report(const fs::path& folder, const FolderReport& report) {
  std::set<std::string> files{records::report_page};
  records::write_file_atomically(folder / records::report_page, report.page);
  if (!report.designs_csv.empty()) {
    records::write_file_atomically(folder / records::designs_table, report.designs_csv);
    files.insert(records::designs_table);
  }
  if (is_file(folder / records::checksum_list)) records::update_checksums(folder, files);
}

}  // namespace parapet::reports
