#include "parapet/reports/sweep_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "key_text.hpp"
#include "parapet/math/units.hpp"
#include "parapet/study/sweep_result.hpp"

namespace parapet::reports {
namespace {

using designs::Json;

struct Column {
  const char* key;
  const char* heading;
  int decimals;
};

constexpr std::array metric_columns{
    Column{"retention_efficiency", "retention", 3},
    Column{"retention_efficiency_total", "total", 3},
    Column{"launch_tip_x_m", "tip x", 3},
    Column{"impact_x_m", "impact x", 3},
    Column{"launch_length_m", "launch", 3},
    Column{"launch_angle_deg", "angle", 1},
    Column{"ramp_angle_deg", "ramp", 1},
    Column{"dead_zone_ratio", "D_F", 2},
    Column{"flow_depth_max_m", "h_max", 4},
    Column{"impact_time_s", "impact t", 3},
    Column{"barrier_1_design_force_n_per_m", "F 1", 0},
    Column{"barrier_2_design_force_n_per_m", "F 2", 0},
};

constexpr const char* legend =
    "-            no value: nothing overflowed, no such barrier, or the run failed\n"
    "(a..b ok)    the source's figure beside ours, which lies in its range; >= and <= likewise\n"
    "(a..b -0.02) ours misses the range by this much; the sign says below (-) or above (+)\n"
    "(x -18 %)    the source states a single value, without a range: ours differs by this share\n"
    "(a..b none)  the source states a figure where the simulation has no value\n"
    "retention    share of the released mass upstream of the first barrier; total: of the last\n"
    "impact x     where the overflow lands, from the reservoir's back wall; launch: from the foot\n"
    "tip x        farthest connected overflow at run.reading_time_s; ramp: slope of the debris "
    "before\n"
    "             the barrier then\n"
    "fit          in the range, by a reading that was chosen after results were seen\n"
    "F 1, 2       design force on the first and second barrier, per metre width\n";

struct Cell {
  std::string value, note;
};

const Json* published_entry(const records::SweepRowResult& row, const std::string& key) {
  if (!row.published.is_object()) return nullptr;
  const auto found = row.published.find(key);
  return found == row.published.end() || !found->is_object() ? nullptr : &*found;
}

std::string published_text(const study::Agreement& agreement) {
  if (agreement.published) return fmt::format("{:.4g}", *agreement.published);
  if (agreement.lower && agreement.upper) {
    return fmt::format("{:.4g}..{:.4g}", *agreement.lower, *agreement.upper);
  }
  if (agreement.lower) return fmt::format(">={:.4g}", *agreement.lower);
  return fmt::format("<={:.4g}", *agreement.upper);
}

std::string note_text(const std::optional<double>& computed, const Json& published) {
  const study::Agreement agreement = study::compare(computed, published);
  if (!agreement.published && !agreement.lower && !agreement.upper) return "";
  std::string mark = published.value("fitted", false) ? "fit" : "ok";
  if (!computed) {
    mark = "none";
  } else if (agreement.verdict == study::Agreement::Verdict::misses) {
    mark = fmt::format("{:+.2g}", agreement.distance);
  } else if (agreement.verdict == study::Agreement::Verdict::none) {
    mark = *agreement.published != 0.0
               ? fmt::format("{:+.0f} %", 100.0 * (*computed / *agreement.published - 1.0))
               : fmt::format("{:+.2g}", *computed);
  }
  return fmt::format("({} {})", published_text(agreement), mark);
}

Cell metric_cell(const records::SweepRowResult& row, const Column& column) {
  const std::optional<double> value = row.metric(column.key);
  const Json* published = published_entry(row, column.key);
  return {value ? fmt::format("{:.{}f}", *value, column.decimals) : "-",
          published != nullptr ? note_text(value, *published) : ""};
}

/// "m/s"; "-" for a pure number.
std::string unit_text(const char* key) {
  const std::string_view unit = math::unit_of(key).plain;
  return unit.empty() ? "-" : std::string(unit);
}

/// One column as lines of equal width: heading, unit, then the rows.
std::vector<std::string> column_lines(const std::string& heading, const std::string& unit,
                                      const std::vector<Cell>& cells, bool right) {
  std::size_t value_width = std::max(heading.size(), unit.size());
  std::size_t note_width = 0;
  for (const Cell& cell : cells) {
    value_width = std::max(value_width, cell.value.size());
    note_width = std::max(note_width, cell.note.size());
  }
  const auto line = [&](const std::string& value, const std::string& note) {
    const std::string text = right ? fmt::format("{:>{}}", value, value_width)
                                   : fmt::format("{:<{}}", value, value_width);
    return note_width == 0 ? text : fmt::format("{} {:<{}}", text, note, note_width);
  };
  if (note_width > 0) note_width = std::max<std::size_t>(note_width, 7);
  std::vector<std::string> lines{line(heading, note_width > 0 ? "(paper)" : ""), line(unit, "")};
  for (const Cell& cell : cells) lines.push_back(line(cell.value, cell.note));
  return lines;
}

std::vector<std::vector<std::string>> table_columns(
    const std::vector<records::SweepRowResult>& rows) {
  const auto column = [&](const std::string& heading, const std::string& unit, bool right,
                          const auto& cell_of) {
    std::vector<Cell> cells;
    for (const records::SweepRowResult& row : rows) cells.push_back(cell_of(row));
    return column_lines(heading, unit, cells, right);
  };
  std::vector<std::vector<std::string>> columns;
  columns.push_back(column("ID", "", false, [](const records::SweepRowResult& row) {
    return Cell{row.id, ""};
  }));
  columns.push_back(column("status", "", false, [](const records::SweepRowResult& row) {
    return Cell{std::string(solver::to_string(row.status)), ""};
  }));
  for (const Column& entry : metric_columns) {
    columns.push_back(
        column(entry.heading, unit_text(entry.key), true,
               [&](const records::SweepRowResult& row) { return metric_cell(row, entry); }));
  }
  columns.push_back(column("stop t", "s", true, [](const records::SweepRowResult& row) {
    return Cell{fmt::format("{:.2f}", row.stop_time), ""};
  }));
  columns.push_back(column("stopped by", "", false, [](const records::SweepRowResult& row) {
    return Cell{row.stop_reason, ""};
  }));
  return columns;
}

std::string joined_columns(const std::vector<std::vector<std::string>>& columns) {
  std::string text;
  const std::size_t n_lines = columns.front().size();
  for (std::size_t line = 0; line < n_lines; ++line) {
    std::string full;
    for (const std::vector<std::string>& column : columns) {
      if (!full.empty()) full += "  ";
      full += column[line];
    }
    if (line == 2) text += std::string(full.size(), '-') + '\n';
    full.erase(full.find_last_not_of(' ') + 1);
    text += full + '\n';
  }
  return text;
}

/// Published figures of metrics that have no column of their own.
std::string further_figures(const std::vector<records::SweepRowResult>& rows) {
  std::set<std::string> shown;
  for (const Column& column : metric_columns) shown.insert(column.key);
  std::string text;
  for (const records::SweepRowResult& row : rows) {
    if (!row.published.is_object()) continue;
    for (const auto& [key, entry] : row.published.items()) {
      if (shown.contains(key) || !entry.is_object()) continue;
      const std::optional<double> value = row.metric(key);
      const std::string note = note_text(value, entry);
      if (note.empty()) continue;
      text += fmt::format("{}: {} = {} {}\n", row.id, key, number_text(value), note);
    }
  }
  return text;
}

std::string misses(const std::vector<records::SweepRowResult>& rows) {
  int judged = 0;
  std::string lines;
  int missed = 0;
  for (const records::SweepRowResult& row : rows) {
    if (!row.published.is_object()) continue;
    for (const auto& [key, entry] : row.published.items()) {
      if (!entry.is_object()) continue;
      const std::optional<double> value = row.metric(key);
      const study::Agreement agreement = study::compare(value, entry);
      if (agreement.verdict == study::Agreement::Verdict::none) continue;
      ++judged;
      if (agreement.verdict == study::Agreement::Verdict::agrees) continue;
      ++missed;
      lines += fmt::format("  misses: {} {} = {} {}\n", row.id, key, number_text(value),
                           note_text(value, entry));
    }
  }
  if (judged == 0) return "";
  return fmt::format("Published ranges met: {} of {}.\n{}", judged - missed, judged, lines);
}

std::string failures(const std::vector<records::SweepRowResult>& rows) {
  std::string text;
  for (const records::SweepRowResult& row : rows) {
    if (row.status == solver::Status::ok) continue;
    text += fmt::format("{} {}: {}\n", row.id, solver::to_string(row.status), row.reason);
  }
  return text;
}

}  // namespace

std::string sweep_table_text(const std::vector<records::SweepRowResult>& rows, double spacing) {
  std::string text =
      fmt::format("{} rows, particle spacing {:g} mm\n\n", rows.size(), 1000.0 * spacing);
  text += joined_columns(table_columns(rows));
  for (const std::string& part : {failures(rows), further_figures(rows), misses(rows)}) {
    if (!part.empty()) text += '\n' + part;
  }
  return text + '\n' + legend;
}

}  // namespace parapet::reports
