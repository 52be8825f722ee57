#include "report_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <stdexcept>

namespace parapet::bench {
namespace {

using nlohmann::json;

json read_json(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot read " + file.string());
  return json::parse(in);
}

// Google Benchmark appends how it measured: "run/a/iterations:1/real_time" is "run/a".
std::string plain_name(std::string name) {
  for (const char* suffix : {"/iterations:", "/repeats:", "/process_time", "/real_time"}) {
    if (const auto at = name.find(suffix); at != std::string::npos) name.resize(at);
  }
  return name;
}

double seconds(const json& entry, const char* key) {
  const std::string unit = entry.at("time_unit");
  const double scale = unit == "ns" ? 1e-9 : unit == "us" ? 1e-6 : unit == "ms" ? 1e-3 : 1.0;
  return scale * entry.at(key).get<double>();
}

// What every entry has beside its counters.
const std::set<std::string> bookkeeping = {"family_index", "per_family_instance_index",
                                           "repetitions",  "repetition_index",
                                           "threads",      "iterations",
                                           "real_time",    "cpu_time"};

// What is beyond them is noise.
double five_digits(double value) {
  return std::stod(fmt::format("{:.5g}", value));
}

}  // namespace

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n == 0 ? std::nan("") : 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

Medians read_medians(const std::filesystem::path& folder) {
  std::map<std::string, std::map<std::string, std::vector<double>>> all;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    if (file.path().extension() != ".json" || file.path().filename() == "report.json") continue;
    const json document = read_json(file.path());
    for (const json& entry : document.at("benchmarks")) {
      if (entry.at("run_type") != "iteration") continue;
      auto& values = all[plain_name(entry.at("run_name"))];
      values["cpu_s"].push_back(seconds(entry, "cpu_time"));
      values["wall_s"].push_back(seconds(entry, "real_time"));
      for (const auto& [key, value] : entry.items()) {
        if (value.is_number() && !bookkeeping.contains(key)) values[key].push_back(value);
      }
    }
  }
  Medians medians;
  for (const auto& [name, values] : all) {
    for (const auto& [key, list] : values) medians[name][key] = median(list);
  }
  return medians;
}

std::optional<double> Report::find(const std::string& benchmark,
                                   const std::string& quantity) const {
  const auto entry = medians.find(benchmark);
  if (entry == medians.end()) return std::nullopt;
  const auto value = entry->second.find(quantity);
  return value == entry->second.end() ? std::nullopt : std::optional(value->second);
}

std::string Report::best_isa() const {
  for (const char* isa : {"x86_64_v4", "x86_64_v3"}) {
    for (const auto& [name, values] : medians) {
      if (name.find(std::string("/") + isa + "/") != std::string::npos) return isa;
    }
  }
  return "x86_64";
}

std::optional<double> Report::peak() const {
  return find("ceiling/" + best_isa() + "/multiply_add", "flop_per_s");
}

Report read_report(const std::filesystem::path& file) {
  const json document = read_json(file);
  return {document.at("machine"), document.at("revision"), document.at("medians")};
}

nlohmann::ordered_json report_json(const Report& report) {
  nlohmann::ordered_json document;
  document["machine"] = report.machine;
  document["revision"] = report.revision;
  nlohmann::ordered_json& medians = document["medians"];
  medians = nlohmann::ordered_json::object();
  for (const auto& [name, values] : report.medians) {
    for (const auto& [key, value] : values) {
      medians[name][key] = five_digits(value);
    }
  }
  return document;
}

}  // namespace parapet::bench
