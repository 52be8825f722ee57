#include "run_blocks.hpp"

#include <bit>
#include <charconv>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "parapet/records/atomic_file.hpp"
#include "parapet/records/deflate.hpp"
#include "parapet/records/flow_recording.hpp"
#include "parapet/records/scene_json.hpp"

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

void RunBlocks::add_scene(const std::string& name, const solver::Scene& scene) {
  page_["runs"][name]["scene"] = records::scene_json(scene);
}

void RunBlocks::add_series(const std::string& name, const Json& series) {
  const std::string id = "series-" + std::to_string(blocks_.size());
  blocks_.push_back(page_block(id, series_bytes(series)));
  page_["runs"][name]["series"] = id;
  for (const Json& column : series.at("columns")) add_key(page_, column.get<std::string>());
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
