#include "run_blocks.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>

#include "parapet/records/atomic_file.hpp"
#include "parapet/records/deflate.hpp"
#include "parapet/records/flow_recording.hpp"
#include "parapet/records/scene_json.hpp"
#include "parapet/solver/gauge_settings.hpp"

namespace parapet::reports {

using designs::Json;

std::string series_bytes(const Json& series) {
  const Json& columns = series.at("columns");
  const Json& rows = series.at("rows");
  const std::size_t n = rows.size(), m = columns.size();
  std::vector<std::uint8_t> planes(4 * n * m);
  for (std::size_t r = 0; r < n; ++r) {
    for (std::size_t c = 0; c < m; ++c) {
      const Json& cell = rows[r].at(c);
      const float value =
          cell.is_number() ? cell.get<float>() : std::numeric_limits<float>::quiet_NaN();
      const auto bits = std::bit_cast<std::uint32_t>(value);
      for (std::size_t plane = 0; plane < 4; ++plane) {
        planes[4 * n * c + plane * n + r] = static_cast<std::uint8_t>(bits >> (8 * plane));
      }
    }
  }
  const std::string header = Json{{"columns", columns}, {"rows", n}}.dump();
  std::string bytes;
  for (unsigned shift = 0; shift < 32; shift += 8) {
    bytes += static_cast<char>((header.size() >> shift) & 0xFFU);
  }
  return bytes + header + records::deflated(planes);
}

Json series_from_csv(const std::string& text) {
  Json series{{"columns", Json::array()}, {"rows", Json::array()}};
  std::size_t begin = 0;
  bool head = true;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    Json row = Json::array();
    for (std::size_t at = begin; at <= end;) {
      const std::size_t comma = std::min(text.find(',', at), end);
      const std::string cell = text.substr(at, comma - at);
      if (head) {
        row.push_back(cell);
      } else {
        double value = 0.0;
        const auto [rest, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
        const bool whole = error == std::errc() && rest == cell.data() + cell.size();
        if (!whole && !cell.empty()) throw std::runtime_error("is no series: \"" + cell + "\"");
        row.push_back(whole ? Json(value) : Json(nullptr));
      }
      at = comma + 1;
    }
    (head ? series["columns"] : series["rows"].emplace_back()) = std::move(row);
    head = false;
    begin = end + 1;
  }
  for (const Json& row : series["rows"]) {
    if (row.size() != series["columns"].size())
      throw std::runtime_error("has rows of other lengths");
  }
  return series;
}

Json with_discharge(Json series, const designs::CaseSpec& spec) {
  Json& columns = series["columns"];
  Json& rows = series["rows"];
  const std::size_t n = rows.size();
  const double volume = spec.scene.reservoir_length * spec.scene.reservoir_height;
  const double wanted =
      spec.run.gauges.discharge_time_ratio * solver::event_units(spec.scene, spec.run.gauges).time;
  for (std::size_t k = 1; k <= spec.scene.barriers.size(); ++k) {
    const std::string barrier = "barrier_" + std::to_string(k);
    const auto at = std::ranges::find(columns, Json(barrier + "_retention_efficiency"));
    if (at == columns.end()) continue;
    const auto column = static_cast<std::size_t>(at - columns.begin());
    columns.push_back(barrier + "_overflow_discharge_m2_s");
    std::size_t back = 0;
    for (std::size_t row = 0; row < n; ++row) {
      const auto time = [&](std::size_t r) { return rows[r][0].get<double>(); };
      while (back + 1 < row && time(row) - time(back + 1) >= wanted) ++back;
      const Json &now = rows[row][column], &before = rows[back][column];
      const double span = time(row) - time(back);
      rows[row].push_back(now.is_number() && before.is_number() && span > 0.0
                              ? Json(volume * (before.get<double>() - now.get<double>()) / span)
                              : Json(nullptr));
    }
  }
  return series;
}

Json load_windows(const designs::CaseSpec& spec, const MetricLookup& metric) {
  const solver::GaugeSettings& gauges = spec.run.gauges;
  const double unit = solver::event_units(spec.scene, gauges).time;
  Json windows = Json::array();
  for (std::size_t k = 1; k <= spec.scene.barriers.size(); ++k) {
    for (const auto& [name, length] :
         {std::pair("design_force", gauges.design_load_time_ratio * unit),
          std::pair("slam_force", gauges.slam_time_ratio * unit)}) {
      const std::string stem = "barrier_" + std::to_string(k) + "_" + name;
      const std::optional<double> value = metric(stem + "_n_per_m");
      const std::optional<double> end = metric(stem + "_time_s");
      if (!value || !end) continue;
      windows.push_back({{"barrier", k},
                         {"key", stem + "_n_per_m"},
                         {"value", *value},
                         {"from_s", *end - length},
                         {"to_s", *end}});
    }
  }
  return windows;
}

void RunBlocks::add_case(const std::string& name, const designs::CaseSpec& spec,
                         const MetricLookup& metric) {
  page_["runs"][name]["scene"] = records::scene_json(spec.scene);
  Json windows = load_windows(spec, metric);
  for (const Json& one : windows) add_key(page_, one.at("key").get<std::string>());
  if (!windows.empty()) page_["runs"][name]["windows"] = std::move(windows);
}

void RunBlocks::add_series(const std::string& name, const designs::CaseSpec& spec,
                           const Json& series) {
  const Json whole = with_discharge(series, spec);
  const std::string id = "series-" + std::to_string(blocks_.size());
  blocks_.push_back(page_block(id, series_bytes(whole)));
  page_["runs"][name]["series"] = id;
  for (const Json& column : whole.at("columns")) add_key(page_, column.get<std::string>());
}

void RunBlocks::add_recording(const std::string& name, const std::filesystem::path& file,
                              const std::string& record_command, const std::string& show_command) {
  Json& run = page_["runs"][name];
  std::error_code none;
  if (!std::filesystem::is_regular_file(std::filesystem::symlink_status(file, none))) {
    if (!record_command.empty()) run["record_command"] = record_command;
    return;
  }
  const std::string bytes = records::read_own_file(file);
  try {
    records::recording_header(bytes);
  } catch (const std::runtime_error&) {
    run["record_command"] = record_command;
    return;
  }
  if (recorded_ + bytes.size() > most_recorded_bytes) {
    run["record_command"] = show_command;
    return;
  }
  recorded_ += bytes.size();
  const std::string id = "recording-" + std::to_string(blocks_.size());
  blocks_.push_back(page_block(id, bytes));
  run["recording"] = id;
}

}  // namespace parapet::reports
