// bench_search_table STUDY.json IN.jsonl OUT.json METRIC...
//
// Fits the oracle: IN has one simulation a line, as `parapet evaluate` prints it (or the short form
// {"design", "ok", "metrics", "cpu_time_s"}); OUT is the table that the comparison reads.
//
// bench_search_table STUDY.json --designs N SEED
//
// Prints N designs to be simulated, one a line: Sobol' points, shifted by the seed.
#include <fmt/format.h>

#include <exception>
#include <fstream>
#include <iostream>

#include "oracle.hpp"
#include "scrambled_sobol.hpp"
#include "study_part.hpp"

namespace parapet::bench::search {
namespace {

using Json = nlohmann::ordered_json;

TableRow read_row(const Json& json, const StudyPart& study) {
  TableRow row;
  row.ok = json.contains("ok") ? json.at("ok").get<bool>() : json.at("status") == "ok";
  for (std::size_t j = 0; j < study.variables.size(); ++j) {
    const double x = json.at("design").at(study.variables[j]);
    row.u.push_back((x - study.lower[j]) / (study.upper[j] - study.lower[j]));
  }
  if (json.at("metrics").is_object()) {
    for (const auto& [key, value] : json.at("metrics").items()) {
      if (value.is_number()) row.metrics[key] = value.get<double>();
    }
  }
  const auto cpu_time = json.find("cpu_time_s");
  if (cpu_time != json.end() && cpu_time->is_number()) row.cpu_time = *cpu_time;
  return row;
}

std::vector<TableRow> read_rows(const std::string& file, const StudyPart& study) {
  std::ifstream in(file);
  if (!in) throw std::invalid_argument("cannot read " + file);
  std::vector<TableRow> rows;
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    const Json json = Json::parse(line, nullptr, false);
    if (json.is_discarded()) {
      fmt::print(stderr, "{}:{}: not JSON, left out (the last line of a table being written?)\n",
                 file, number);
      continue;
    }
    rows.push_back(read_row(json, study));
  }
  return rows;
}

void print_fit(const Oracle& oracle) {
  fmt::print("{}: {} simulations, {} failed, {:.3g} s each (median)\n", oracle.name,
             oracle.designs.rows(), oracle.failed.size(), oracle.median_cpu_time);
  for (const auto& [name, m] : oracle.metrics) {
    fmt::print("  {:<30} leave-one-out {:.4g} (Q2 {:.4f}), of it noise {:.4g}", name,
               m.fit.leave_one_out_rms, m.fit.q_squared, m.fit.noise);
    if (m.presence) fmt::print(", presence wrong in {:.1f} %", 100.0 * m.presence_errors);
    fmt::print("\n");
  }
}

void make_table(const StudyPart& study, const std::string& in, const std::string& out,
                const std::vector<std::string>& metrics) {
  const Oracle oracle = fit_oracle(study.name, study.variables, study.lower, study.upper,
                                   read_rows(in, study), metrics);
  print_fit(oracle);
  std::ofstream file(out);
  file << to_json(oracle).dump() << '\n';
  if (!file) throw std::runtime_error("cannot write " + out);
}

void print_designs(const StudyPart& study, int n, std::uint64_t seed) {
  ScrambledSobol points(static_cast<int>(study.variables.size()), seed);
  for (int k = 0; k < n; ++k) {
    const std::vector<double> u = points.next();
    Json design = Json::object();
    for (std::size_t j = 0; j < u.size(); ++j) {
      design[study.variables[j]] =
          study.lower[j] + (study.upper[j] - study.lower[j]) * rounded(u[j], design_digits);
    }
    std::cout << design.dump() << '\n';
  }
}

}  // namespace
}  // namespace parapet::bench::search

int main(int argc, char** argv) {
  using namespace parapet;
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  try {
    if (arguments.size() == 4 && arguments[1] == "--designs") {
      bench::search::print_designs(bench::search::read_study_part(arguments[0]),
                                   std::stoi(arguments[2]), std::stoull(arguments[3]));
    } else if (arguments.size() >= 4) {
      bench::search::make_table(bench::search::read_study_part(arguments[0]), arguments[1],
                                arguments[2], {arguments.begin() + 3, arguments.end()});
    } else {
      fmt::print(stderr,
                 "usage: bench_search_table STUDY.json IN.jsonl OUT.json METRIC...\n"
                 "       bench_search_table STUDY.json --designs N SEED\n");
      return 2;
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_search_table: {}\n", error.what());
    return 1;
  }
}
