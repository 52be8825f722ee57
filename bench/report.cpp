// bench_report FOLDER REVISION BASELINE: reads what the benchmark programs wrote into FOLDER,
// prints the tables, compares with BASELINE where that exists, and writes FOLDER/report.json.
#include <fmt/format.h>

#include <exception>
#include <fstream>
#include <thread>

#include "tables.hpp"

namespace parapet::bench {
namespace {

std::string machine() {
  std::ifstream info("/proc/cpuinfo");
  std::string model = "unknown processor";
  for (std::string line; std::getline(info, line);) {
    if (!line.starts_with("model name")) continue;
    model = line.substr(line.find(':') + 2);
    break;
  }
  return fmt::format("{}, {} cores", model, std::thread::hardware_concurrency());
}

void section(const std::string& title, const std::string& table) {
  if (!table.empty()) fmt::print("\n{}\n{}", title, table);
}

void print_report(const std::filesystem::path& folder, const std::string& revision,
                  const std::filesystem::path& baseline) {
  const Report report{machine(), revision, read_medians(folder)};
  fmt::print("{}, revision {}\n", report.machine, report.revision);
  section("Targets (medians)", target_table(report));
  section("Roofline", roofline_table(report));
  section("Scaling (H10-D45 after 0.7 s)", scaling_table(report));
  if (std::filesystem::exists(baseline)) {
    section("Against the baseline", comparison_table(report, read_report(baseline)));
  }
  std::ofstream out(folder / "report.json");
  out << report_json(report).dump(1) << '\n';
  if (!out) throw std::runtime_error("cannot write into " + folder.string());
}

}  // namespace
}  // namespace parapet::bench

int main(int argc, char** argv) {
  if (argc != 4) {
    fmt::print(stderr, "usage: bench_report FOLDER REVISION BASELINE\n");
    return 2;
  }
  try {
    parapet::bench::print_report(argv[1], argv[2], argv[3]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_report: {}\n", error.what());
    return 1;
  }
}
