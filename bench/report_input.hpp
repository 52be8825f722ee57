// What the benchmark programs wrote: for every benchmark the median over its repetitions of the
// time and of each counter.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace parapet::bench {

// {benchmark: {quantity: median}}; "cpu_s" and "wall_s" are its times, the rest its counters.
using Medians = std::map<std::string, std::map<std::string, double>>;

struct Report {
  std::string machine;   // processor and number of cores
  std::string revision;  // of the source
  Medians medians;

  std::optional<double> find(const std::string& benchmark, const std::string& quantity) const;
  // The best instruction set that was measured: "x86_64_v4", ...
  std::string best_isa() const;
  // Multiplications and additions of one core at their best [flop/s].
  std::optional<double> peak() const;
};

// All *.json that Google Benchmark left in `folder`.
Medians read_medians(const std::filesystem::path& folder);

Report read_report(const std::filesystem::path& file);
nlohmann::ordered_json report_json(const Report& report);

double median(std::vector<double> values);

}  // namespace parapet::bench
