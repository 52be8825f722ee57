// bench_search_report LIST.json TABLES OUT DOCS REVISION
//
// Scores what the methods left in OUT/PROBLEM/*.json and writes DOCS/comparison.json, the curves
// and DOCS/results.md. OUT/zoo.json and OUT/overhead.json are taken in where they exist.
#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <fstream>
#include <set>

#include "oracle.hpp"
#include "parapet/records/atomic_file.hpp"
#include "tables_text.hpp"

namespace parapet::bench::search {
namespace {

using Json = nlohmann::ordered_json;

Json read_json(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot read " + file.string());
  return Json::parse(in);
}

Comparison read_comparison(const BenchProblem& problem, const std::filesystem::path& folder) {
  std::vector<Eigen::VectorXd> front;
  for (const Json& point : read_json(folder / "front" / "front.json")) {
    const auto y = point.get<std::vector<double>>();
    front.push_back(
        Eigen::Map<const Eigen::VectorXd>(y.data(), static_cast<Eigen::Index>(y.size())));
  }
  return compare_runs(problem, std::move(front), read_runs(folder));
}

std::string introduction(const Comparison& comparison) {
  const BenchProblem& p = comparison.problem;
  std::string objectives;
  for (std::size_t j = 0; j < p.objectives.size(); ++j) {
    const BenchObjective& o = p.objectives[j];
    const double at = comparison.yardstick.reference[static_cast<Eigen::Index>(j)];
    objectives +=
        fmt::format("{}{} `{}` (reference {:.4g})", j == 0 ? "" : ", ",
                    o.maximize ? "most" : "least", p.metrics[o.metric].name, o.maximize ? -at : at);
  }
  const std::size_t runs = comparison.scores.empty() ? 0 : comparison.scores.front().curves.size();
  return fmt::format(
      "{} variables; {}; {:.2g} s of processor time a simulation; {} runs of each method unless "
      "its "
      "name says otherwise.\n",
      p.dimension(), objectives, p.level_seconds.front(), runs);
}

std::string problem_section(const Comparison& comparison, const std::vector<std::string>& figures) {
  std::string text = fmt::format(
      "## {}\n\n{}\nEvaluations (median) to a share of the best "
      "hypervolume, and the share after some evaluations:\n\n{}",
      comparison.problem.title, introduction(comparison), evaluations_table(comparison));
  if (const std::string levels = levels_table(comparison); !levels.empty()) {
    text += fmt::format("\nLevels of fidelity, {:.2g} s and {:.2g} s a simulation:\n\n{}",
                        comparison.problem.level_seconds[0], comparison.problem.level_seconds[1],
                        levels);
  }
  for (const std::string& file : figures) {
    if (file.ends_with(".png")) text += fmt::format("\n![{}]({})\n", file, file);
  }
  return text + "\n";
}

std::string tables_section(const std::filesystem::path& tables,
                           const std::vector<BenchProblem>& problems,
                           const std::vector<std::vector<std::string>>& levels) {
  std::vector<std::vector<std::string>> rows = {
      {"table", "simulations", "metric", "leave-one-out error", "Q2", "noise"}};
  std::set<std::string> seen;  // problems share tables
  for (std::size_t p = 0; p < problems.size(); ++p) {
    for (const std::string& level : levels[p]) {
      if (!seen.insert(level).second) continue;
      const Oracle oracle = read_oracle(tables / (level + ".json"));
      for (const auto& [metric, m] : oracle.metrics) {
        rows.push_back({level, fmt::format("{}", oracle.designs.rows()), "`" + metric + "`",
                        fmt::format("{:.2g}", m.fit.leave_one_out_rms),
                        fmt::format("{:.4f}", m.fit.q_squared),
                        fmt::format("{:.2g}", m.fit.noise)});
      }
    }
  }
  return "## The tables\n\n" + markdown_table(rows) + "\n";
}

std::string overhead_section(const Json& overhead) {
  std::vector<std::vector<std::string>> rows = {
      {"problem", "evaluations", "own time [s]", "simulations [s]", "share"}};
  for (const Json& row : overhead) {
    const double own = row.at("own_seconds"), simulated = row.at("simulated_seconds");
    rows.push_back({row.at("problem"), fmt::format("{}", row.at("evaluations").get<int>()),
                    fmt::format("{:.1f}", own), fmt::format("{:.0f}", simulated),
                    fmt::format("{:.1f} %", 100.0 * own / simulated)});
  }
  return "## What the search itself costs\n\nProcessor time.\n\n" + markdown_table(rows) + "\n";
}

std::string zoo_section(const Json& zoo) {
  std::vector<std::vector<std::string>> rows = {{"problem", "variant", "Bayesian 90 %", "95 %",
                                                 "end", "worst run", "Sobol' 90 %", "95 %", "end",
                                                 "worst run"}};
  const auto reached = [](const Json& value, int budget) {
    return value.is_number() ? fmt::format("{:.0f}", value.get<double>())
                             : fmt::format("> {}", budget);
  };
  for (const Json& row : zoo.at("rows")) {
    std::vector<std::string> cells = {row.at("problem"), row.at("variant")};
    for (const char* method : {"bayesian", "random"}) {
      const Json& score = row.at(method);
      const int budget = score.at("budget");
      cells.push_back(reached(score.at("evaluations_90"), budget));
      cells.push_back(reached(score.at("evaluations_95"), budget));
      cells.push_back(fmt::format("{:.3f}", score.at("share_at_end").get<double>()));
      cells.push_back(fmt::format("{:.3f}", score.value("worst_share_at_end", 0.0)));
    }
    rows.push_back(cells);
  }
  return fmt::format("## Problems with known fronts\n\nMedian of {} runs, {} evaluations each.\n\n",
                     zoo.at("seeds").get<int>(), zoo.at("evaluations").get<int>()) +
         markdown_table(rows) + "\n";
}

/// Gaps and shares of known_bench, one line for each problem.
std::string known_section(const Json& known) {
  std::vector<std::vector<std::string>> rows = {{"problem", "evaluations", "measure"}};
  const auto number = [](const Json& value) {
    return value.is_number() ? fmt::format("{:.2g}", value.get<double>()) : std::string("-");
  };
  std::string last;
  for (const Json& row : known.at("rows")) {
    if (row.at("problem") != last) {
      last = row.at("problem");
      rows.push_back(
          {last, fmt::format("{}", row.at("evaluations").get<int>()),
           row.at("measure") == "gap" ? "gap to the least value" : "share of the hypervolume"});
    }
    const std::string method = row.at("method");
    auto& head = rows.front();
    if (std::find(head.begin(), head.end(), method) == head.end()) head.push_back(method);
    rows.back().push_back(number(row.at("median")) + " (" + number(row.at("worst")) + ")");
  }
  return fmt::format(
             "## Hard problems with known optima\n\nMedian of {} runs, the worst one in "
             "brackets.\n\n",
             known.at("seeds").get<int>()) +
         markdown_table(rows) + "\n";
}

std::string asker_section(const Json& asker) {
  std::vector<std::vector<std::string>> rows = {
      {"designs known", "variables", "questions in a batch", "processor time of one [ms]"}};
  for (const Json& row : asker) {
    rows.push_back({fmt::format("{}", row.at("designs").get<int>()),
                    fmt::format("{}", row.at("variables").get<int>()),
                    fmt::format("{}", row.at("batch").get<int>()),
                    fmt::format("{:.0f}", 1e3 * row.at("seconds_each").get<double>())});
  }
  return "## What a question costs\n\n" + markdown_table(rows) + "\n";
}

void report(const std::filesystem::path& list, const std::filesystem::path& tables,
            const std::filesystem::path& out, const std::filesystem::path& docs,
            const std::string& revision) {
  records::make_folder(docs);
  Json json = {{"format", "parapet-search-comparison-result/1"}, {"revision", revision}};
  std::string text = fmt::format(
      "# Search methods side by side: results\n\nWritten by `bench/search/run` at "
      "revision {}; what it means is in [optimization.md](../optimization.md).\n\n",
      revision);
  std::vector<BenchProblem> problems;
  std::vector<std::vector<std::string>> levels;
  for (const std::string& name : problem_names(list)) {
    if (!std::filesystem::exists(out / name / "front" / "front.json")) continue;
    problems.push_back(load_problem(list, tables, name));
    levels.push_back(level_names(list, name));
    const Comparison comparison = read_comparison(problems.back(), out / name);
    json["problems"].push_back(to_json(comparison));
    text += problem_section(comparison, draw_curves(comparison, docs));
  }
  text += tables_section(tables, problems, levels);
  if (std::filesystem::exists(out / "zoo.json")) {
    json["zoo"] = read_json(out / "zoo.json");
    text += zoo_section(json["zoo"]);
  }
  if (std::filesystem::exists(out / "known.json")) {
    json["known"] = read_json(out / "known.json");
    text += known_section(json["known"]);
  }
  if (std::filesystem::exists(out / "asker.json")) {
    json["asker"] = read_json(out / "asker.json");
    text += asker_section(json["asker"]);
  }
  if (std::filesystem::exists(out / "overhead.json")) {
    json["overhead"] = read_json(out / "overhead.json");
    text += overhead_section(json["overhead"]);
  }
  text.pop_back();  // one end of line is enough
  records::write_file_atomically(docs / "comparison.json", json.dump() + "\n");
  records::write_file_atomically(docs / "results.md", text);
  fmt::print("{}", text);
}

}  // namespace
}  // namespace parapet::bench::search

int main(int argc, char** argv) {
  if (argc != 6) {
    fmt::print(stderr, "usage: bench_search_report LIST.json TABLES OUT DOCS REVISION\n");
    return 2;
  }
  try {
    parapet::bench::search::report(argv[1], argv[2], argv[3], argv[4], argv[5]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_search_report: {}\n", error.what());
    return 1;
  }
}
