// What the comparison says, for people: Markdown tables and curves.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "score.hpp"

namespace parapet::bench::search {

// The scores of one problem, best first.
struct Comparison {
  BenchProblem problem;
  Yardstick yardstick;
  std::vector<MethodScore> scores;

  const MethodScore* find(const std::string& method) const;  // nullptr if it was not run
};

Comparison compare_runs(const BenchProblem& problem, std::vector<Eigen::VectorXd> front,
                        const std::vector<MethodRuns>& runs);

// Evaluations to reach the targets.
std::string evaluations_table(const Comparison& comparison);

// Seconds to reach the targets with one level of fidelity and with all; empty if one was not run.
std::string levels_table(const Comparison& comparison);

// Share of the hypervolume against evaluations, and against seconds where there are levels; the
// best method of each family. Returns the files' names.
std::vector<std::string> draw_curves(const Comparison& comparison,
                                     const std::filesystem::path& folder);

nlohmann::ordered_json to_json(const Comparison& comparison);

// Rows of cells, the first being the heading; the first column to the left, the others to the
// right.
std::string markdown_table(const std::vector<std::vector<std::string>>& rows);

// "83", or "> 600" where a target was not reached within a budget.
std::string target_text(double value, double budget, const char* format = "{:.0f}");

}  // namespace parapet::bench::search
