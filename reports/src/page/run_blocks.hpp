/// Scenes, series and recordings of runs as a page holds them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "page_html.hpp"
#include "parapet/designs/case_spec.hpp"

namespace parapet::reports {

/// Series as bytes: the length of a header (32 bits, little endian), the header {columns, rows} as
/// JSON, then the values as single-precision numbers, column by column, the four bytes of a
/// column's numbers in four planes, compressed together (zlib).
/// @param series {columns: [...], rows: [[...]]}; null where a value is not defined
std::string series_bytes(const designs::Json& series);

/// The same from series.csv.
/// @throws std::runtime_error when the file is none
designs::Json series_from_csv(const std::string& text);

/// Adds a column `barrier_K_overflow_discharge_m2_s` for each barrier: the rate at which retention
/// falls, times the released volume, over the window of peak_overflow_discharge_m2_s (or two
/// samples, when longer).
designs::Json with_discharge(designs::Json series, const designs::CaseSpec& spec);

/// A metric of a run by its key; nothing where it has none.
using MetricLookup = std::function<std::optional<double>(const std::string& key)>;

/// Where the loads come from: [{barrier, key, value, from_s, to_s}], the windows of the running
/// means.
designs::Json load_windows(const designs::CaseSpec& spec, const MetricLookup& metric);

/// Collects the runs of a page.
class RunBlocks {
 public:
  explicit RunBlocks(designs::Json& page) : page_(page) {}

  /// Adds a run by its name: its scene, and the windows of its loads.
  void add_case(const std::string& name, const designs::CaseSpec& spec, const MetricLookup& metric);
  /// Adds its series, with the discharge over each barrier.
  void add_series(const std::string& name, const designs::CaseSpec& spec,
                  const designs::Json& series);

  /// Adds the recording if it is there, sound and has room; else says how to get it.
  void add_recording(const std::string& name, const std::filesystem::path& file,
                     const std::string& record_command, const std::string& show_command);

  const std::vector<PageBlock>& blocks() const { return blocks_; }

 private:
  designs::Json& page_;
  std::vector<PageBlock> blocks_;
  std::size_t recorded_ = 0;  // bytes
};

}  // namespace parapet::reports
