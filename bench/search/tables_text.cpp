#include "tables_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "oracle.hpp"

namespace parapet::bench::search {
namespace {

std::string share_text(const MethodScore& score, std::size_t evaluations) {
  if (score.median_share.size() < evaluations) return "-";
  return fmt::format("{:.3f}", score.median_share[evaluations - 1]);
}

double longest_seconds(const MethodScore& score) {
  double longest = 0.0;
  for (const Curve& curve : score.curves) {
    if (!curve.seconds.empty()) longest = std::max(longest, curve.seconds.back());
  }
  return longest;
}

nlohmann::ordered_json number_or_null(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json to_json(const MethodScore& score) {
  nlohmann::ordered_json json = {{"method", score.method},
                                 {"label", score.label},
                                 {"family", score.family},
                                 {"runs", score.curves.size()},
                                 {"budget_evaluations", score.budget},
                                 {"worst_share_at_end", score.worst_share},
                                 {"own_seconds", score.own_seconds}};
  for (std::size_t t = 0; t < targets.size(); ++t) {
    json["targets"].push_back({{"share", targets[t]},
                               {"median_evaluations", number_or_null(score.evaluations[t])},
                               {"worst_evaluations", number_or_null(score.worst_evaluations[t])},
                               {"median_seconds", number_or_null(score.seconds[t])},
                               {"runs_that_reached_it", score.reached[t]}});
  }
  // enough of the curve to draw it again
  const std::size_t stride = std::max<std::size_t>(1, score.median_share.size() / 100);
  for (std::size_t k = 0; k < score.median_share.size(); k += stride) {
    json["curve"]["evaluations"].push_back(k + 1);
    json["curve"]["lower_quartile"].push_back(rounded(score.lower_share[k], 4));
    json["curve"]["median"].push_back(rounded(score.median_share[k], 4));
    json["curve"]["upper_quartile"].push_back(rounded(score.upper_share[k], 4));
  }
  return json;
}

}  // namespace

const MethodScore* Comparison::find(const std::string& method) const {
  const auto found = std::find_if(scores.begin(), scores.end(),
                                  [&](const MethodScore& s) { return s.method == method; });
  return found == scores.end() ? nullptr : &*found;
}

Comparison compare_runs(const BenchProblem& problem, std::vector<Eigen::VectorXd> front,
                        const std::vector<MethodRuns>& runs) {
  Comparison comparison{problem, make_yardstick(problem, std::move(front)), {}};
  extend(comparison.yardstick, problem, runs);
  for (const MethodRuns& method : runs) {
    if (!method.runs.empty()) {
      comparison.scores.push_back(score(problem, comparison.yardstick, method));
    }
  }
  std::stable_sort(comparison.scores.begin(), comparison.scores.end(), better);
  return comparison;
}

std::string target_text(double value, double budget, const char* format) {
  const bool reached = std::isfinite(value);
  const std::string text = fmt::format(fmt::runtime(format), reached ? value : budget);
  return reached ? text : "> " + text;
}

std::string evaluations_table(const Comparison& comparison) {
  std::vector<std::vector<std::string>> rows = {{"method", "90 %", "95 %", "worst run", "99 %",
                                                 "share after 50", "after 100", "after 300",
                                                 "worst run at the end"}};
  for (const MethodScore& s : comparison.scores) {
    if (s.method == "bayesian_levels") continue;  // its evaluations are not all of one cost
    std::vector<std::string> row = {s.label};
    for (std::size_t t = 0; t < targets.size(); ++t) {
      row.push_back(target_text(s.evaluations[t], s.budget));
      if (t == 1) row.push_back(target_text(s.worst_evaluations[t], s.budget));
    }
    for (const std::size_t e : {50UL, 100UL, 300UL}) row.push_back(share_text(s, e));
    row.push_back(fmt::format("{:.3f}", s.worst_share));
    rows.push_back(row);
  }
  return markdown_table(rows);
}

std::string levels_table(const Comparison& comparison) {
  const MethodScore* one = comparison.find("bayesian");
  const MethodScore* all = comparison.find("bayesian_levels");
  if (one == nullptr || all == nullptr) return "";
  std::vector<std::vector<std::string>> rows = {{"simulated seconds to", "90 %", "95 %", "99 %"}};
  for (const MethodScore* s : {one, all}) {
    std::vector<std::string> row = {s->label};
    for (const double seconds : s->seconds) {
      row.push_back(target_text(seconds, longest_seconds(*s)));
    }
    rows.push_back(row);
  }
  return markdown_table(rows);
}

std::string markdown_table(const std::vector<std::vector<std::string>>& rows) {
  std::string text;
  for (std::size_t line = 0; line < rows.size(); ++line) {
    for (const std::string& cell : rows[line]) text += "| " + cell + " ";
    text += "|\n";
    if (line > 0) continue;
    for (std::size_t column = 0; column < rows[0].size(); ++column) {
      text += column == 0 ? "|---" : "|---:";
    }
    text += "|\n";
  }
  return text;
}

nlohmann::ordered_json to_json(const Comparison& comparison) {
  const Yardstick& y = comparison.yardstick;
  nlohmann::ordered_json json = {{"name", comparison.problem.name},
                                 {"variables", comparison.problem.variables},
                                 {"objectives", nlohmann::ordered_json::array()},
                                 {"reference_point", nlohmann::ordered_json::array()},
                                 {"level_seconds", comparison.problem.level_seconds},
                                 {"methods", nlohmann::ordered_json::array()}};
  for (std::size_t j = 0; j < comparison.problem.objectives.size(); ++j) {
    const BenchObjective& o = comparison.problem.objectives[j];
    const double at = y.reference[static_cast<Eigen::Index>(j)];
    json["objectives"].push_back({{"metric", comparison.problem.metrics[o.metric].name},
                                  {"goal", o.maximize ? "maximize" : "minimize"}});
    json["reference_point"].push_back(o.maximize ? -at : at);
  }
  json["hypervolume"] = y.volume;
  json["front_designs"] = y.front.size();
  for (const MethodScore& s : comparison.scores) json["methods"].push_back(to_json(s));
  return json;
}

}  // namespace parapet::bench::search
